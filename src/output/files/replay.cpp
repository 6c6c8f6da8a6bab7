// SPDX-License-Identifier: MIT
#include "output/files/replay.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "base/units.hpp"
#include "output/files/movie_file.hpp"
#include "output/files/movie_output.hpp"
#include "output/files/panels.hpp"
#include "output/picture/automatic_range.hpp"
#include "output/picture/chart_data.hpp"
#include "output/picture/field_choice.hpp"
#include "output/picture/painting.hpp"

namespace hackle {
namespace fs = std::filesystem;
namespace {

constexpr double max_frames = 1e5;
constexpr double the_end = std::numeric_limits<double>::infinity();

void show_at(Recording& recording, double time) {
  const std::size_t record = recording.nearest(time);
  if (record != recording.shown()) recording.go_to(record);
}

// Returns the mean interval of the records of the run with the most; one step for a single record.
double usual_every(const Tiles& tiles) {
  double every = 0.0;
  std::size_t max = 0;
  for (const Tile& tile : tiles) {
    const std::vector<double>& times = tile.recording->times();
    if (times.size() <= max) continue;
    max = times.size();
    const double span = times.back() - times.front();
    every = span > 0.0 ? span / static_cast<double>(times.size() - 1) : tile.recording->view().dt();
  }
  return every;
}

void check_moments(const char* who, double from, double to, double every) {
  Problems problems;
  if (!(every > 0.0) || !std::isfinite(every))
    problems.add(fmt::format("{}: every is {}, it must be above 0 s", who, quantity(every, "s")));
  if (!(from <= to) || !std::isfinite(to - from))
    problems.add(
        fmt::format("{}: it would go from {} to {}", who, quantity(from, "s"), quantity(to, "s")),
        "from must come before to");
  problems.throw_if_any();
  if ((to - from) / every >= max_frames)
    throw Error(ErrorKind::refused,
                fmt::format("{}: there would be more than {:.0f} frames", who, max_frames),
                "take a longer every");
}

// Shows the progress, and stops on Ctrl-C after the present frame.
class Frames {
 public:
  Frames(Talk talk, std::size_t count) : progress_(talk), count_(count) {}

  void next() {
    if (interrupted())
      throw Error(ErrorKind::interrupted,
                  fmt::format("interrupted after frame {} of {}", done_, count_));
    const double fraction = static_cast<double>(done_++) / static_cast<double>(count_);
    if (progress_.due(fraction))
      progress_.show(fraction, fmt::format("frame {} of {}", done_, count_));
  }

 private:
  Progress progress_;
  std::size_t count_;
  std::size_t done_ = 0;
};

// Makes one frame per time. After an interrupt the frames made so far are still completed.
template <class Make, class Finish>
void make_all(const std::vector<double>& times, Talk talk, Make make, Finish finish) {
  Frames frames(talk, times.size());
  try {
    for (const double time : times) {
      frames.next();
      make(time);
    }
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::interrupted) finish();
    throw;
  }
  finish();
}

void check_all(const char* who, const Tiles& tiles, const PictureOptions& options) {
  for (const Tile& tile : tiles) check(who, options, tile.recording->view().lattice().grid);
  check_recorded(who, options);
  check_opaque(who, options);
}

}  // namespace

void show_record(Recording& recording, const ShownRecord& record) {
  recording.go_to(recording.nearest(record.time.value_or(the_end)));
}

std::vector<double> frame_times(const char* who, const Tiles& tiles, const Moments& moments) {
  double first = tiles.front().recording->times().front(), last = first;
  for (const Tile& tile : tiles) {
    first = std::min(first, tile.recording->times().front());
    last = std::max(last, tile.recording->times().back());
  }
  const double from = moments.from.value_or(first), to = moments.to.value_or(last);
  const double every = moments.every.value_or(usual_every(tiles));
  check_moments(who, from, to, every);
  const auto count = static_cast<std::size_t>(std::floor((to - from) / every + 1e-9)) + 1;
  std::vector<double> times(count);
  for (std::size_t k = 0; k < count; ++k) times[k] = from + static_cast<double>(k) * every;
  return times;
}

namespace {

// Calls visit(view) for each run at each time, or at its end.
void for_all(const Tiles& tiles, const std::vector<double>& times, const auto& visit) {
  for (const Tile& tile : tiles)
    for (const double time : times.empty() ? std::vector{the_end} : times) {
      throw_if_interrupted();
      show_at(*tile.recording, time);
      visit(tile.recording->view());
    }
}

// Brings displaced plates to their last record: a window that suits it suits those before.
void show_last(const Tiles& tiles, const std::vector<double>& times,
               const PictureOptions& options) {
  if (!options.deformed) return;
  for (const Tile& tile : tiles) show_at(*tile.recording, times.empty() ? the_end : times.back());
}

}  // namespace

namespace {

// Returns the widest of the default ranges of one of the fields, widened until it fits all states.
Ends common_range(const FieldChoice& field, const Tiles& tiles, const std::vector<double>& times) {
  Ends widest = usual_ends(field, tiles.front().recording->view());
  for (const Tile& tile : tiles) {
    const Ends usual = usual_ends(field, tile.recording->view());
    widest = {std::min(widest.min, usual.min), std::max(widest.max, usual.max)};
  }
  if (!field.is_unlimited()) return widest;
  for_all(tiles, times, [&](const View& view) { widest = fitting_range(field, view, widest); });
  return widest;
}

Ends range_of_percentile(const PictureOptions& options, const Tiles& tiles,
                         const std::vector<double>& times) {
  AutomaticRange seen(options);
  for_all(tiles, times, [&](const View& view) { seen.add(view); });
  return seen.ends();
}

}  // namespace

PictureOptions with_common_range(PictureOptions options, const Tiles& tiles,
                                 const std::vector<double>& times) {
  if (options.second && !options.second_range)
    options.second_range = common_range(second_field(options), tiles, times);
  if (options.range) return options;
  options.range = options.percentile ? range_of_percentile(options, tiles, times)
                                     : common_range(first_field(options), tiles, times);
  options.percentile.reset();
  return options;
}

void film(const std::shared_ptr<Recording>& recording, const fs::path& path, MovieOptions options,
          const Moments& moments, int threads, Talk talk,
          std::shared_ptr<const OutputNames> names) {
  const Tiles tiles{{recording, ""}};
  const std::vector<double> times = frame_times("movie", tiles, moments);
  check_all("movie", tiles, options.picture);
  options.every = times.size() > 1 ? times[1] - times[0] : recording->view().dt();
  options.every = std::max(options.every, recording->view().dt());
  options.picture = with_common_range(options.picture, tiles, times);
  show_last(tiles, times, options.picture);
  MovieOutput movie(path, options, recording->view(), recording->origin(), threads, talk,
                    std::move(names));
  make_all(
      times, talk,
      [&](double time) {
        show_at(*recording, time);
        movie.add(recording->view());
      },
      [&] { movie.close(); });
}

void film_side_by_side(const Tiles& tiles, const fs::path& path, MovieOptions options,
                       const Moments& moments, SheetLayout layout, int threads, Talk talk,
                       const OutputNames& names) {
  const std::vector<double> times = frame_times("side_by_side", tiles, moments);
  check_all("side_by_side", tiles, options.picture);
  options.every = times.size() > 1 ? times[1] - times[0] : 0.0;
  options.picture = with_common_range(options.picture, tiles, times);
  show_last(tiles, times, options.picture);
  layout.width = options.picture.width;
  layout.even = true;
  Panels panels(tiles, options.picture, layout,
                options.every > 0.0 ? slow_motion_of(options) : 0.0);
  const Recording& first = *tiles.front().recording;
  MovieFile movie(path, options, first.origin(), threads, talk);
  movie.begin([&](const fs::path& other) { return names.is_claimed(other); });
  make_all(
      times, talk,
      [&](double time) {
        for (std::size_t k = 0; k < tiles.size(); ++k) {
          show_at(*tiles[k].recording, time);
          panels.add(k);
        }
        movie.add(panels.sheet());
      },
      [&] { movie.finish(); });
}

Image sheet_of(const Tiles& tiles, const std::vector<double>& times, PictureOptions options,
               SheetLayout layout) {
  check_all("contact_sheet", tiles, options);
  check_alone("contact_sheet", options);
  options = with_common_range(options, tiles, times);
  show_last(tiles, times, options);
  if (tiles.size() > 1 && times.size() > 1) layout.columns = static_cast<int>(times.size());
  Panels panels(tiles, options, layout, 0.0);
  for (std::size_t k = 0; k < tiles.size(); ++k)
    for (const double time : times.empty() ? std::vector{the_end} : times) {
      throw_if_interrupted();
      show_at(*tiles[k].recording, time);
      panels.add(k);
    }
  return panels.sheet();
}

}  // namespace hackle
