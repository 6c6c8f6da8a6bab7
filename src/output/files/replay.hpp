// SPDX-License-Identifier: MIT
// Makes movies and sheets of recorded runs, without computing again.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/image.hpp"
#include "base/progress.hpp"
#include "output/files/output_names.hpp"
#include "output/files/replay_options.hpp"
#include "output/files/tile.hpp"
#include "render/contact_sheet.hpp"
#include "store/recording.hpp"

namespace hackle {

// Brings the recording to it.
void show_record(Recording& recording, const ShownRecord& record);

// Returns the times of all frames, s; at most 1e5. Throws Error (refused) for invalid times; `who`
// names the calling function.
std::vector<double> frame_times(const char* who, const Tiles& tiles, const Moments& moments);

// Returns the options with a common range, also of the second field, for these runs at all these
// times, or at the end: the given range, that of their percentile over all visible values, or the
// widest of the field's defaults, widened until it fits every state.
PictureOptions with_common_range(PictureOptions options, const Tiles& tiles,
                                 const std::vector<double>& times);

// Makes a movie of one run on up to `threads` threads; ignores `options.every`. Throws Error
// (refused) for impossible options, Error (interrupted) on Ctrl-C, where the movie then ends, and
// what MovieOutput throws.
void film(const std::shared_ptr<Recording>& recording, const std::filesystem::path& path,
          MovieOptions options, const Moments& moments, int threads, Talk talk,
          std::shared_ptr<const OutputNames> names);

// Makes a movie of several runs with a common clock and range, side by side in the columns of
// the layout, and one legend.
// The width is that of each run. Throws the same.
void film_side_by_side(const Tiles& tiles, const std::filesystem::path& path, MovieOptions options,
                       const Moments& moments, SheetLayout layout, int threads, Talk talk,
                       const OutputNames& names);

// Paints each run at each time, with a common range: one row per run, one column per time; a single
// run, or all runs at their end if no times are given, in the columns of the layout. Throws what
// check(), PlatePainter and contact_sheet() throw.
Image sheet_of(const Tiles& tiles, const std::vector<double>& times, PictureOptions options,
               SheetLayout layout);

}  // namespace hackle
