// SPDX-License-Identifier: MIT
#include "output/files/replay.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "base/units.hpp"
#include "output/files/movie_file.hpp"
#include "output/files/movie_output.hpp"
#include "output/picture/automatic_range.hpp"
#include "output/picture/chart_data.hpp"
#include "output/picture/field_choice.hpp"
#include "output/picture/painting.hpp"

namespace hackle {
namespace fs = std::filesystem;
namespace {

constexpr double max_frames = 1e5;
constexpr double title_size = 0.03;  // of a run's title, in widths of its picture
constexpr double the_end = std::numeric_limits<double>::infinity();

void show_at(Recording& recording, double time) {
  const std::size_t record = recording.nearest(time);
  if (record != recording.shown()) recording.go_to(record);
}

bool is_titled(const Tiles& tiles) {
  return !std::ranges::all_of(tiles, &std::string::empty, &Tile::title);
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

// A painter per tile; combines all pictures of one time.
class Composition {
 public:
  Composition(Tiles tiles, const MovieOptions& options, int columns)
      : tiles_(std::move(tiles)), options_(options.picture) {
    layout_.columns = columns;
    layout_.look = options_.look;
    layout_.width = options_.width;
    layout_.even = true;
    layout_.font = title_size;
    layout_.titled = is_titled(tiles_);
    for (const Tile& tile : tiles_) {
      PictureStyle style = style_of(options_, tile.recording->view());
      if (options.every > 0.0) style.slow_motion = slow_motion_of(options);
      painters_.emplace_back(std::move(style));
      layout_.height = std::max(layout_.height, painters_.back().height());
    }
  }

  Image at(double time) {
    std::vector<SheetImage> images;
    for (std::size_t k = 0; k < tiles_.size(); ++k) {
      show_at(*tiles_[k].recording, time);
      images.push_back(
          {painters_[k].paint(shot_of(options_, tiles_[k].recording->view())), tiles_[k].title});
    }
    return contact_sheet(images, layout_);
  }

 private:
  Tiles tiles_;
  PictureOptions options_;
  SheetLayout layout_;
  std::deque<PlatePainter> painters_;
};

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

PictureOptions with_common_range(PictureOptions options, const Tiles& tiles,
                                 const std::vector<double>& times) {
  if (options.range) return options;
  AutomaticRange seen(options);
  Ends widest = usual_ends(options, tiles.front().recording->view());
  for (const Tile& tile : tiles) {
    const Ends usual = usual_ends(options, tile.recording->view());
    widest = {std::min(widest.min, usual.min), std::max(widest.max, usual.max)};
  }
  const bool looks = options.percentile || first_field(options).is_unlimited();
  for_all(looks ? tiles : Tiles(), times, [&](const View& view) {
    if (options.percentile)
      seen.add(view);
    else
      widest = fitting_range(options, view, widest);
  });
  options.range = options.percentile ? seen.ends() : widest;
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
                       const Moments& moments, int columns, int threads, Talk talk,
                       const OutputNames& names) {
  const std::vector<double> times = frame_times("side_by_side", tiles, moments);
  check_all("side_by_side", tiles, options.picture);
  options.every = times.size() > 1 ? times[1] - times[0] : 0.0;
  options.picture = with_common_range(options.picture, tiles, times);
  show_last(tiles, times, options.picture);
  Composition composition(tiles, options, columns);
  const Recording& first = *tiles.front().recording;
  MovieFile movie(path, options, first.origin(), threads, talk);
  movie.begin([&](const fs::path& other) { return names.is_claimed(other); });
  make_all(
      times, talk, [&](double time) { movie.add(composition.at(time)); }, [&] { movie.finish(); });
}

Image sheet_of(const Tiles& tiles, const std::vector<double>& times, PictureOptions options,
               SheetLayout layout) {
  check_all("contact_sheet", tiles, options);
  check_alone("contact_sheet", options);
  std::vector<SheetImage> images;
  layout.height = 0;
  layout.font = title_size;
  layout.titled = is_titled(tiles);
  layout.look = options.look;
  options = with_common_range(options, tiles, times);
  show_last(tiles, times, options);
  for (const Tile& tile : tiles) {
    PlatePainter painter(style_of(options, tile.recording->view()));
    layout.height = std::max(layout.height, painter.height() * layout.width / painter.width());
    for (const double time : times.empty() ? std::vector{the_end} : times) {
      throw_if_interrupted();
      show_at(*tile.recording, time);
      images.push_back({painter.paint(shot_of(options, tile.recording->view())), tile.title});
    }
  }
  if (tiles.size() > 1 && times.size() > 1) layout.columns = static_cast<int>(times.size());
  return contact_sheet(images, layout);
}

}  // namespace hackle
