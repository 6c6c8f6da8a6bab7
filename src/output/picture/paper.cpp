// SPDX-License-Identifier: MIT
#include "output/picture/paper.hpp"

#include <cmath>

#include <fmt/format.h>

#include "base/units.hpp"
#include "output/picture/picture.hpp"

namespace hackle {
namespace {

constexpr double points_an_inch = 72.0, inch = 25.4e-3;
constexpr double usual_font = 8.0;  // pt, as journals have it

double points(const Paper& paper) {
  return paper.font_size.value_or(usual_font) / points_an_inch * paper.dpi;
}

}  // namespace

int pixels_of(const Paper& paper) {
  if (!paper.paper) return paper.width;
  return 2 * static_cast<int>(std::lround(0.5 * *paper.paper / inch * paper.dpi));
}

double font_pixels(const Paper& paper) {
  return paper.paper || paper.font_size ? std::round(points(paper)) : 0.0;
}

void check_paper(const std::string& who, const Paper& paper, Problems& problems) {
  const int width = pixels_of(paper);
  if (width < min_picture_width || width > max_picture_width)
    problems.add(fmt::format("{}: {} of paper at {} dpi are {} px, it must be between {} and {}",
                             who, quantity(paper.paper.value_or(0.0), "m"), shortest(paper.dpi),
                             width, min_picture_width, max_picture_width),
                 "another dpi");
  constexpr double least = 6.0, most_share = 0.05;  // px, and of the width
  const double font = points(paper);
  if ((paper.paper || paper.font_size) && !(font >= least && font <= most_share * width))
    problems.add(
        fmt::format("{}: a font_size of {} pt is {:.3g} px of a width of {}", who,
                    shortest(paper.font_size.value_or(usual_font)), font, width),
        fmt::format("it must lie between {} px and {} % of the width", least, 100.0 * most_share));
}

}  // namespace hackle
