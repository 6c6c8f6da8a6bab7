// SPDX-License-Identifier: MIT
// Movies and sheets of recorded runs, without computing again.
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
#include "render/contact_sheet.hpp"
#include "store/recording.hpp"

namespace hackle {

// A recorded run in company.
struct Tile {
  std::shared_ptr<Recording> recording;
  std::string title;  // may be empty
};
using Tiles = std::vector<Tile>;

// Brings the recording to it.
void show_record(Recording& recording, const ShownRecord& record);

// The times of all frames, s; at most 1e5. Throws Error (refused) where they make no sense; `who`
// names the call.
std::vector<double> frame_times(const char* who, const Tiles& tiles, const Moments& moments);

// The options with the range that holds for these runs at all these times, or in the end: the one
// they give, that of their percentile over all that is seen, or the widest of those that suit the
// field.
PictureOptions with_common_range(PictureOptions options, const Tiles& tiles,
                                 const std::vector<double>& times);

// A movie of one run; `options.every` does not count. Throws Error (refused) for impossible
// options, Error (interrupted) on Ctrl-C, when the movie ends there, and what MovieOutput throws.
void film(const std::shared_ptr<Recording>& recording, const std::filesystem::path& path,
          MovieOptions options, const Moments& moments, Talk talk,
          std::shared_ptr<const OutputNames> names);

// A movie of several on a common clock and a common range, side by side in so many columns. The
// width is that of each. Throws the same.
void film_side_by_side(const Tiles& tiles, const std::filesystem::path& path, MovieOptions options,
                       const Moments& moments, int columns, Talk talk, const OutputNames& names);

// Each run at each of these times, with a common range: a row for each run, a column for each time;
// one run alone, or without times all as they were in the end, in the columns of the layout. Throws
// what check(), PlatePainter and contact_sheet() throw.
Image sheet_of(const Tiles& tiles, const std::vector<double>& times, PictureOptions options,
               SheetLayout layout);

}  // namespace hackle
