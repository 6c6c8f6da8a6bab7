// SPDX-License-Identifier: MIT
// What a user may say of a picture.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "measure/scalar.hpp"
#include "render/picture_style.hpp"

namespace hackle {

// What a picture looks at: a window of the plate's shape, rounded to whole cells of the lattice.
struct Zoom {
  Vec2 centre{0, 0};        // m; the window must show some of the plate
  double half_width = 0.0;  // m, from one spacing to the plate's width
};

// Where a crack runs that a picture follows.
enum class Toward { right, left, up, down };
inline constexpr std::array<std::string_view, 4> toward_names{"right", "left", "up", "down"};

// How a picture is made.
struct PictureOptions {
  std::string field = "damage";          // one of scalar_names
  int width = 1280;                      // px, even, 320..7680; the height follows from the plate
  std::optional<double> pixels_a_metre;  // instead of the width
  std::optional<Ends> range;             // of the colour bar, SI; what suits the field if not given
  // Instead of a range, %, 50..100: the range spans this share of the values that are seen.
  std::optional<double> percentile;
  std::optional<bool> logarithmic;    // as the field has it if not given
  std::string colours;                // one of colour_map_names, or "" for what suits the field
  std::optional<std::string> second;  // another of scalar_names
  std::optional<Ends> second_range;   // as range
  Arrangement arrangement = Arrangement::below;  // of the second field
  bool cracks = true;                            // cracks are gaps, except in a picture of damage
  double thickness = 5e-3;                       // m, of the plate, for fringes
  std::optional<Zoom> zoom;                      // the whole plate if not given
  std::optional<Toward> follow;                  // the zoom goes where the foremost damage is
  double rotation = 0.0;                         // rad, counterclockwise
  bool deformed = false;                         // displacements are shown,
  std::optional<double> magnification;  // so many times as large; what suits the plate if not given
  bool bonds = false;                   // drawn one by one
  Background background = Background::dark;
  OverlayOptions overlay;  // what stands around the plate and on it
};

}  // namespace hackle
