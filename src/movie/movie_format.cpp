// SPDX-License-Identifier: MIT
#include "movie/movie_format.hpp"

#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/text.hpp"
#include "base/units.hpp"

namespace hackle {
namespace {

constexpr int max_pixels = 16384;  // per side, the limit of x264 and WebP
constexpr double min_fps = 0.1;

void check_fps(const MovieKind& kind, double fps, Problems& problems) {
  if (fps >= min_fps && fps <= kind.max_fps) return;
  problems.add(fmt::format("movie: fps is {}, in {} it must lie between {} and {}", shortest(fps),
                           kind.ending, min_fps, kind.max_fps));
}

void check_crf(const MovieKind& kind, int crf, Problems& problems) {
  if (!kind.takes_crf())
    problems.add(fmt::format("movie: crf has no meaning in {}", kind.ending),
                 "profile says how good it is to be");
  else if (crf < kind.best_crf || crf > kind.worst_crf)
    problems.add(fmt::format("movie: crf is {}, in {} it must lie between {} (best) and {}", crf,
                             kind.ending, kind.best_crf, kind.worst_crf));
}

void check_profile(const MovieKind& kind, Profile profile, Problems& problems) {
  if (kind.settings(profile)) return;
  std::vector<std::string_view> able;
  for (const MovieKind& other : movie_kinds())
    if (other.settings(profile)) able.push_back(other.ending);
  problems.add(
      fmt::format("movie: {} as every player takes it cannot be {}", kind.ending, name_of(profile)),
      "as can " + comma_list(able));
}

}  // namespace

void check_settings(const std::filesystem::path& path, const MovieFormat& format,
                    Problems& problems) {
  if (!(format.hold >= 0.0 && format.hold <= max_hold))
    problems.add(fmt::format("movie: hold is {} s, it must lie between 0 and {} s",
                             shortest(format.hold), max_hold));
  try {
    const MovieKind& kind = movie_kind(path);
    check_fps(kind, format.fps, problems);
    check_profile(kind, format.profile, problems);
    if (format.crf) check_crf(kind, *format.crf, problems);
  } catch (const Error& error) {
    for (const Problem& problem : error.problems()) problems.add(problem.what, problem.remedy);
  }
}

void check(const std::filesystem::path& path, const MovieFormat& format) {
  Problems problems;
  for (const auto& [name, size] : {std::pair{"width", format.width}, {"height", format.height}})
    if (size < 2 || size > max_pixels || size % 2 != 0)
      problems.add(fmt::format("movie: the {} is {} px, it must be even and between 2 and {} px",
                               name, size, max_pixels));
  check_settings(path, format, problems);
  if (format.threads < 1)
    problems.add(fmt::format("movie: threads is {}, it must be at least 1", format.threads));
  problems.throw_if_any();
}

}  // namespace hackle
