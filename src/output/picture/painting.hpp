// SPDX-License-Identifier: MIT
// Makes the picture that the user's options describe.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "measure/crack_growth.hpp"
#include "output/picture/field_choice.hpp"
#include "output/picture/picture.hpp"
#include "render/plate_painter.hpp"
#include "solver/view.hpp"

namespace hackle {

// Throws Error (refused) with every problem of the options on that lattice; `output` names the
// caller.
void check(const char* output, const PictureOptions& options, const Grid& grid);

// For a movie made while the plate is solved, whose range must be known beforehand. Throws Error
// (refused) for a percentile.
void refuse_percentile(const char* output, const PictureOptions& options);

// For pictures in movies and on sheets. Throws Error (refused) for a transparent background, which
// only a single PNG can have.
void check_opaque(const char* output, const PictureOptions& options);

// Returns the style. Without a range in the options, it is that of the present state, or the
// field's default. Throws Error (refused) if the materials lack a value that the field needs.
PictureStyle style_of(const PictureOptions& options, const View& view);

// Returns the range of the field, widened from `ends` until it fits all values of the state, as
// pictures do for those that are seen; unchanged for a field that does not widen.
Ends fitting_range(const FieldChoice& choice, const View& view, const Ends& ends);

// The size of a picture without texts and bars, stretched to fill these px.
struct Extent {
  int width = 0, height = 0;
};

// Paints the present state. The options must have been checked; `bare` overrides their width.
// Throws Error (run_failed) if the state is not finite, and what PlatePainter throws.
Image paint(const View& view, const PictureOptions& options,
            const std::optional<Extent>& bare = {});

// Writes the same picture, as the ending of the path says: PNG, PDF or SVG. `growth` is how its
// cracks have grown, where that is known. Throws what these throw.
void write_picture(const View& view, const PictureOptions& options,
                   const std::filesystem::path& path, const CrackGrowth* growth = nullptr);

// Returns the width in px of the largest picture with texts that fits into these px, at most
// `most.width`; 0 if the smallest does not fit.
int widest_picture(const PictureOptions& options, const View& view, const Extent& max);

// Returns the content of a picture of the present state; nan without material.
Shot shot_of(const PictureOptions& options, const View& view, const CrackGrowth* growth = nullptr);

}  // namespace hackle
