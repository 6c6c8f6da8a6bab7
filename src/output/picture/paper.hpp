// SPDX-License-Identifier: MIT
// The size of what is drawn, in px or on paper.
#pragma once

#include <optional>
#include <string>

#include "base/error.hpp"

namespace hackle {

struct Paper {
  int width = 1280;                 // px
  std::optional<double> paper;      // m, the width on paper, instead
  double dpi = 300.0;               // px per inch of paper
  std::optional<double> font_size;  // pt, on paper; default: suits the width
};

// Returns the width in px; on paper it is even.
int pixels_of(const Paper& paper);
// Returns the size of texts in px; 0 where it is to suit the width.
double font_pixels(const Paper& paper);

// Adds a problem if it is too small or too large, or its texts would be illegible or leave no room.
void check_paper(const std::string& who, const Paper& paper, Problems& problems);

}  // namespace hackle
