// SPDX-License-Identifier: MIT
// Pictures of several recorded runs on one sheet, with one scale and one legend for all.
#pragma once

#include <deque>
#include <filesystem>
#include <string>
#include <vector>

#include "base/image.hpp"
#include "output/files/tile.hpp"
#include "output/picture/painting.hpp"
#include "render/contact_sheet.hpp"
#include "render/legend.hpp"

namespace hackle {

// Returns a name for each of these files: its own without the ending, or, where files are called
// alike, that of its folder, or both where folders are called alike, too.
std::vector<std::string> panel_names(const std::vector<std::filesystem::path>& files);

class Panels {
 public:
  // Windows suit the present states of the recordings. The options have a range. `slow_motion` is 0
  // if not shown. Of the layout, the number of columns and the width of panels and whether its
  // sides are even count; the tallest picture keeps its shape.
  Panels(const Tiles& tiles, PictureOptions options, SheetLayout layout, double slow_motion);

  // Adds a panel with the present state of the recording of tile k.
  void add(std::size_t k);
  // Returns the sheet of the panels that were added, and begins the next.
  Image sheet();

 private:
  void share_scale(std::vector<PictureStyle>& styles);

  Tiles tiles_;
  PictureOptions options_;
  SheetLayout layout_;
  double scale_ = 0.0;  // px per m, in every panel
  PictureStyle legend_style_;
  std::deque<PlatePainter> painters_;
  std::vector<SheetImage> images_;
  std::vector<Beyond> beyond_;  // of all panels together
};

}  // namespace hackle
