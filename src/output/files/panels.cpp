// SPDX-License-Identifier: MIT
#include "output/files/panels.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <string>
#include <utility>

namespace hackle {
namespace {

constexpr double panel_title = 0.03;  // size of a run's title, in widths of its picture

bool differ(const std::vector<std::string>& names) {
  return std::set<std::string>(names.begin(), names.end()).size() == names.size();
}

bool is_titled(const Tiles& tiles) {
  return !std::ranges::all_of(tiles, &std::string::empty, &Tile::title);
}

// Returns px per m.
double scale_of(const PictureStyle& style) {
  return layout_of(style).plate.width / (style.window->nx * style.grid.dx);
}

}  // namespace

std::vector<std::string> panel_names(const std::vector<std::filesystem::path>& files) {
  std::vector<std::string> own, folders, both;
  for (const std::filesystem::path& file : files) {
    own.push_back(file.stem().string());
    folders.push_back(file.parent_path().filename().string());
    both.push_back(folders.back().empty() ? own.back() : folders.back() + "/" + own.back());
  }
  if (differ(own)) return own;
  return differ(folders) ? folders : both;
}

Panels::Panels(const Tiles& tiles, PictureOptions options, SheetLayout layout, double slow_motion)
    : tiles_(tiles), options_(std::move(options)), layout_(layout) {
  layout_.look = options_.look;
  layout_.font = panel_title;
  layout_.titled = is_titled(tiles_);
  layout_.tallest = 0.0;
  std::vector<PictureStyle> styles;
  for (const Tile& tile : tiles_) {
    styles.push_back(style_of(options_, tile.recording->view()));
    styles.back().slow_motion = slow_motion;
  }
  legend_style_ = styles.front();
  share_scale(styles);
  for (PictureStyle& style : styles) {
    const PlatePainter& painter = painters_.emplace_back(std::move(style));
    const double shape = static_cast<double>(painter.height()) / painter.width();
    layout_.tallest = std::max(layout_.tallest, shape);
  }
}

// All are as large as the least of them would be alone, and as wide as the widest.
void Panels::share_scale(std::vector<PictureStyle>& styles) {
  scale_ = std::numeric_limits<double>::infinity();
  int width = 0;
  for (const PictureStyle& style : styles) {
    scale_ = std::min(scale_, scale_of(style));
    width = std::max(width, style.width);
  }
  for (PictureStyle& style : styles) {
    style.width = width;
    style.cell = scale_ * style.grid.dx;
    style.encloses = false;  // the scale would change
    style.overlay.bar = style.overlay.scale_bar = false;
  }
  scale_ *= static_cast<double>(layout_.width) / width;
}

void Panels::add(std::size_t k) {
  PlatePainter& painter = painters_[k];
  images_.push_back(
      {painter.paint(shot_of(options_, tiles_[k].recording->view())), tiles_[k].title});
  beyond_.resize(std::max(beyond_.size(), painter.beyond().size()));
  for (std::size_t bar = 0; bar < painter.beyond().size(); ++bar) {
    beyond_[bar].below |= painter.beyond()[bar].below;
    beyond_[bar].above |= painter.beyond()[bar].above;
  }
}

Image Panels::sheet() {
  const int width = sheet_width(static_cast<int>(images_.size()), layout_);
  Legend legend(legend_style_, width + width % 2, scale_);
  std::vector<SheetImage> images = std::exchange(images_, {});
  return contact_sheet(images, layout_, legend.paint(std::exchange(beyond_, {})));
}

}  // namespace hackle
