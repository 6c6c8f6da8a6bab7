// SPDX-License-Identifier: MIT
// What picture the options of a user ask for.
#pragma once

#include <optional>
#include <string>

#include "output/picture/picture.hpp"
#include "render/plate_painter.hpp"
#include "solver/simulation.hpp"

namespace hackle {

// Throws Error (refused) with every problem of the options on that lattice; `output` names who
// asks.
void check(const char* output, const PictureOptions& options, const Grid& grid);

// Of a movie that is made while the plate is solved: its range must be known before. Throws Error
// (refused) for a percentile.
void refuse_percentile(const char* output, const PictureOptions& options);

// Of pictures that go into movies and onto sheets. Throws Error (refused) for a transparent
// background, which only a PNG by itself can have.
void check_opaque(const char* output, const PictureOptions& options);

// Without a range in the options it is the one of the state as it is, or what suits the field.
// Throws Error (refused) when the materials lack what the field needs.
PictureStyle style_of(const PictureOptions& options, const Simulation& simulation);

// A picture without texts and bars, stretched to fill these px.
struct Extent {
  int width = 0, height = 0;
};

// A picture of the state as it is. The options have been checked; `bare` overrides their width.
// Throws Error (run_failed) when the state is not finite, and what PlatePainter throws.
Image paint(const Simulation& simulation, const PictureOptions& options,
            const std::optional<Extent>& bare = {});

// The width in px of the largest picture with texts that fits into these px, at most `most.width`;
// 0 when the smallest does not.
int widest_picture(const PictureOptions& options, const Simulation& simulation, const Extent& most);

// What the picture shows of the state as it is; nan where there is no material.
Shot shot_of(const PictureOptions& options, const Simulation& simulation);

}  // namespace hackle
