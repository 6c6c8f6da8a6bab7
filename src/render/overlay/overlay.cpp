// SPDX-License-Identifier: MIT
#include "render/overlay/overlay.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "render/overlay/axes.hpp"
#include "render/overlay/canvas.hpp"
#include "render/overlay/strip_chart.hpp"

namespace hackle {
namespace {

// Copies to a rectangle as large as `from`.
void copy(const Image& from, Image& to, const Rectangle& area) {
  const std::uint8_t* row = from.pixels.data();
  const std::ptrdiff_t left = 4 * static_cast<std::ptrdiff_t>(area.x);
  std::uint8_t* at = to.pixels.data() + static_cast<std::ptrdiff_t>(area.y) * to.stride() + left;
  for (int k = 0; k < area.height; ++k, row += from.stride(), at += to.stride())
    std::memcpy(at, row, static_cast<std::size_t>(from.stride()));
}

// Returns the base line of the letters of one caption line.
double base_line(const Rectangle& line, double font) {
  return line.y + font;
}

}  // namespace

Overlay::Overlay(const Layout& layout, const OverlayText& text, const std::vector<ColourMap>& maps,
                 double pixels_a_metre)
    : layout_(layout),
      text_(text),
      maps_(maps),
      pixels_a_metre_(pixels_a_metre),
      theme_(theme_of(text.background)),
      slow_motion_(slow_motion_text(text.slow_motion)) {
  if (layout.font == 0.0) return;
  font_.emplace();
  draw_once();
}

void Overlay::set_bars(const std::vector<BarText>& bars, const std::vector<ColourMap>& maps) {
  text_.bars = bars;
  maps_ = maps;
  if (font_) draw_once();
}

void Overlay::set_scale(double pixels_a_metre) {
  pixels_a_metre_ = pixels_a_metre;
  if (font_) draw_once();
}

void Overlay::draw_once() {
  lasting_.clear();
  strips_.clear();
  bars_.clear();
  write_caption();
  for (std::size_t k = 0; k < layout_.bars.size(); ++k) {
    const ColourBar& bar =
        bars_.emplace_back(layout_, layout_.bars[k], text_.bars[k], theme_, *font_);
    lasting_.insert(lasting_.end(), bar.texts().begin(), bar.texts().end());
  }
  if (!layout_.scale.empty()) {
    scale_.emplace(layout_, text_, *font_, 1.0 / pixels_a_metre_);
    lasting_.push_back(scale_->text());
  }
  const auto draw_all = [this](Canvas& canvas) { draw_lasting(canvas); };
  keep({0, 0, layout_.width, layout_.caption.bottom()}, draw_all);
  keep({0, layout_.foot, layout_.width, layout_.height - layout_.foot}, draw_all);
}

void Overlay::draw_lasting(Canvas& canvas) const {
  for (std::size_t k = 0; k < bars_.size(); ++k) bars_[k].draw(canvas, maps_[k]);
  if (scale_) scale_->draw(canvas);
  for (const PlacedText& one : lasting_) canvas.write(*font_, one);
}

void Overlay::keep(const Rectangle& area, const std::function<void(Canvas&)>& draw_all) {
  if (area.empty()) return;
  Strip& strip = strips_.emplace_back(Strip{area, Image(area.width, area.height)});
  Canvas canvas(strip.pixels, area.x, area.y);
  canvas.colour(theme_.background, theme_.opacity);
  canvas.fill(area.x, area.y, area.width, area.height);
  draw_all(canvas);
}

void Overlay::write_caption() {
  const auto write = [&](const std::string& words, const Rectangle& line, double size,
                         Colour colour) {
    if (line.empty()) return;
    lasting_.push_back(font_->place(font_->fitting(words, size, line.width), line.x,
                                    base_line(line, layout_.font), size, 0.0, colour));
  };
  write(text_.title, layout_.title, layout_.font, theme_.text);
  write(text_.note, layout_.note, layout_.small_font, theme_.quiet);
}

void Overlay::draw_axes(Canvas& canvas, const Rectangle& plate, const Camera& camera) {
  if (!text_.parts.axes) return;
  const Axes axes(plate, camera, layout_, theme_, *font_);
  axes.draw(canvas);
  for (const PlacedText& one : axes.texts()) canvas.write(*font_, one);
  fleeting_.insert(fleeting_.end(), axes.texts().begin(), axes.texts().end());
}

void Overlay::draw_marks(Canvas& canvas, const Rectangle& plate, const Camera& camera,
                         const Moment& moment) {
  if (font_) {
    canvas.colour(theme_.outline);
    canvas.outline(plate, layout_.hairline);
  }
  const Vec2 scale = camera.pixels_a_metre();
  for (const Circle& disc : moment.discs)
    canvas.disc(camera.pixel(disc.centre), disc.radius * scale.x(), disc.radius * scale.y(),
                theme_.disc);
  for (const Box& box : moment.boxes) {
    const Vec2 corner = camera.pixel({box.min.x(), box.max.y()});
    canvas.box(corner.x(), corner.y(), (box.max.x() - box.min.x()) * scale.x(),
               (box.max.y() - box.min.y()) * scale.y(), theme_.disc);
  }
  if (!font_) return;
  draw_axes(canvas, plate, camera);
  hackle::draw(canvas, moment.cracks, layout_, plate, camera);
  std::vector<Marker> markers = text_.parts.markers;
  markers.insert(markers.end(), moment.cracks.tips.begin(), moment.cracks.tips.end());
  const auto placed = place_markers(markers, layout_, plate, camera, *font_);
  hackle::draw(canvas, placed, layout_, *font_);
  placed_.insert(placed_.end(), placed.begin(), placed.end());
}

void Overlay::draw_chart(Canvas& canvas, const Rectangle& room, ChartHistory& history,
                         const Chart& chart, double time) {
  if (room.empty()) return;
  const StripChart strip(room, history.add(chart, time), time, layout_, theme_, *font_);
  strip.draw(canvas);
  fleeting_.insert(fleeting_.end(), strip.texts().begin(), strip.texts().end());
}

// The slow motion stands beside the time; it moves only for times that are longer than usual.
void Overlay::write_clock(double time) {
  const Rectangle& clock = layout_.clock;
  double left = clock.right();
  if (!clock.empty()) {
    const std::string text = font_->fitting(time_text(time), layout_.font, clock.width);
    fleeting_.push_back(font_->place(text, clock.right(), base_line(clock, layout_.font),
                                     layout_.font, 1.0, theme_.text));
    left = std::min(fleeting_.back().x, clock.right() - font_->width_of("000.00 µs", layout_.font));
  }
  const Rectangle& slow = layout_.slow_motion;
  if (slow.empty()) return;
  const double right = slow.y == clock.y ? left - layout_.font : slow.right();
  fleeting_.push_back(font_->place(font_->fitting(slow_motion_, layout_.small_font, slow.width),
                                   right, base_line(slow, layout_.font), layout_.small_font, 1.0,
                                   theme_.quiet));
}

void Overlay::draw_all_marks(Canvas& canvas, const std::vector<Camera>& cameras,
                             const Moment& moment) {
  placed_.clear();
  fleeting_.clear();
  draw_marks(canvas, layout_.plate, cameras.front(), moment);
  if (!layout_.second_plate.empty())
    draw_marks(canvas, layout_.second_plate, cameras.back(), moment);
}

void Overlay::draw(Image& image, const std::vector<Camera>& cameras, const Moment& moment) {
  {
    Canvas canvas(image);
    draw_all_marks(canvas, cameras, moment);
  }
  for (const Strip& strip : strips_) copy(strip.pixels, image, strip.area);
  Canvas canvas(image);
  if (font_) draw_fleeting(canvas, moment);
}

void Overlay::draw(Canvas& canvas, const std::vector<Camera>& cameras, const Moment& moment) {
  const Rectangle between{0, layout_.caption.bottom(), layout_.width,
                          layout_.foot - layout_.caption.bottom()};
  canvas.within(between, [&] { draw_all_marks(canvas, cameras, moment); });
  if (!font_) return;
  draw_lasting(canvas);
  draw_fleeting(canvas, moment);
}

void Overlay::draw_fleeting(Canvas& canvas, const Moment& moment) {
  const std::size_t marked = std::min(bars_.size(), moment.beyond.size());
  for (std::size_t k = 0; k < marked; ++k) bars_[k].draw_ends(canvas, maps_[k], moment.beyond[k]);
  const std::size_t before = fleeting_.size();
  write_clock(moment.time);
  for (std::size_t k = before; k < fleeting_.size(); ++k) canvas.write(*font_, fleeting_[k]);
  draw_chart(canvas, layout_.load_curve, loads_, moment.load_curve, moment.time);
  draw_chart(canvas, layout_.energy, energy_, moment.energy, moment.time);
}

std::vector<PlacedText> Overlay::texts() const {
  std::vector<PlacedText> all = lasting_;
  all.insert(all.end(), fleeting_.begin(), fleeting_.end());
  for (const PlacedMarker& marker : placed_)
    if (marker.label) all.push_back(*marker.label);
  return all;
}

}  // namespace hackle
