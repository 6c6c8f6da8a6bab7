// SPDX-License-Identifier: MIT
// A complete picture of a plate: the field in colours, colour bar, time and scale bar.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/image.hpp"
#include "measure/bond_lines.hpp"
#include "measure/field.hpp"
#include "render/chart.hpp"
#include "render/picture_style.hpp"

namespace hackle {

// What is painted at one time, by Grid::index: of one field at most 14 bytes a node.
struct Shot {
  std::vector<float> values;        // nan where the background is to be seen
  std::vector<float> second;        // of the second field, if the style has one
  std::vector<std::uint8_t> gaps;   // damage in 255ths, to be seen as gaps; empty where it is not
  std::vector<float> displacement;  // m, x and y; empty for the plate at rest
  std::vector<std::uint8_t> links;  // of Link, when there are displacements
  std::vector<BondLine> bonds;      // to be drawn one by one
  double time = 0.0;                // s
  std::vector<Circle> discs;
  std::optional<Window> window;  // as large as that of the style, which it stands in for
  Chart load_curve, energy;      // where the overlay has them
};

// Where everything lies in the pictures of a series.
Layout layout_of(const PictureStyle& style);

// Owns a GL context, so it must be used, and destroyed, by the thread that created it.
class PlatePainter {
 public:
  // Throws Error (files) when a shader, colour map or font is missing, Error (run_failed) when no
  // GL context can be had.
  explicit PlatePainter(PictureStyle style);
  ~PlatePainter();

  int width() const;   // px, even unless bare
  int height() const;  // px, even, from the shape of what is seen; or as the style says

  // Discs are drawn where they are, over the plate, displaced or not.
  Image paint(const Shot& shot);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hackle
