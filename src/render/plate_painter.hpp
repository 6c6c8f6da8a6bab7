// SPDX-License-Identifier: MIT
// Paints complete pictures of a plate: field in colours, colour bar, time and scale bar.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "base/image.hpp"
#include "measure/bond_lines.hpp"
#include "measure/field.hpp"
#include "render/overlay/chart.hpp"
#include "render/overlay/colour_bar.hpp"
#include "render/overlay/crack_drawing.hpp"
#include "render/picture_style.hpp"

namespace hackle {

// The content of one picture, by Grid::index: for one field at most 14 bytes per node.
struct Shot {
  std::vector<float> values;        // nan shows the background
  std::vector<float> second;        // of the second field, if the style has one
  std::vector<std::uint8_t> gaps;   // damage in 1/255, shown as gaps; may be empty
  std::vector<float> displacement;  // m, x and y; empty for the undeformed plate
  std::vector<std::uint8_t> links;  // of Link, if there are displacements or the style is smooth
  std::vector<BondLine> bonds;      // drawn one by one
  double time = 0.0;                // s
  std::vector<Circle> discs;
  std::vector<Box> boxes;
  std::optional<Window> window;  // replaces that of the style and has its size
  Chart load_curve, energy;      // if the overlay shows them
  CrackDrawing cracks;           // likewise
};

// What a painter has adapted to the pictures so far: the ranges of both fields, and the window.
struct Adaptation {
  struct Range {
    double min = 0.0, max = 1.0, widened_by = 1.0;
  };
  std::array<Range, 2> ranges;
  Window window;
};

// Returns the layout of all pictures of a series.
Layout layout_of(const PictureStyle& style);

// Owns a GL context, so the thread that creates it must also use and destroy it.
class PlatePainter {
 public:
  // Throws Error (files) if a shader, colour map or font is missing, Error (run_failed) if no GL
  // context is available.
  explicit PlatePainter(PictureStyle style);
  ~PlatePainter();

  int width() const;   // px, even unless bare
  int height() const;  // px, even, from the shape of the visible part; or as the style says
  // Returns at which ends of each bar values of the last picture lie beyond it.
  const std::vector<Beyond>& beyond() const;

  // From this picture on, widens the range of a field that does so, and the window of a style that
  // encloses the plate, where what is seen does not fit. Discs are drawn at their positions, over
  // the plate, displaced or not.
  Image paint(const Shot& shot);
  // Another painter of the same style that is adapted so goes on with the series to the same bits.
  Adaptation adaptation() const;
  void adapt(const Adaptation& adaptation);
  // Writes the same picture as vectors, with the plate as an embedded image: texts, bars, axes,
  // marks and bonds. Throws what write_vectors throws.
  void write_vectors(const Shot& shot, const std::filesystem::path& path);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hackle
