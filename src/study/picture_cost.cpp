// SPDX-License-Identifier: MIT
#include "study/picture_cost.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

#include "base/units.hpp"
#include "study/front.hpp"
#include "study/scene_numerics.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;

constexpr auto every_key = "movie.every", width_key = "movie.width";
constexpr std::array frames{400.0, 100.0, 25.0};            // over the whole run
constexpr std::array widths{1920.0, 1280.0, 640.0, 320.0};  // px
constexpr double usual_frames = 100.0, usual_width = 1280.0;

Settings filmed(double every, double width) {
  return {{every_key, shortest(every)}, {width_key, shortest(width)}};
}

std::vector<Settings> choices(double duration) {
  std::vector<Settings> all;
  all.reserve(frames.size() + widths.size());
  for (const double count : frames) all.push_back(filmed(duration / count, usual_width));
  for (const double width : widths)
    if (width != usual_width) all.push_back(filmed(duration / usual_frames, width));
  return all;
}

template <class Visit>
void for_each_file(const Outcome& outcome, const Visit& visit) {
  if (!outcome.finished() || !outcome.told.contains("files")) return;
  for (const auto& file : outcome.told["files"]) visit(fs::path(file.get<std::string>()));
}

bool has_movie(const Outcome& outcome) {
  constexpr auto endings =
      std::to_array<std::string_view>({".mp4", ".webm", ".gif", ".webp", ".apng", ".mkv", ".mov"});
  bool found = false;
  for_each_file(outcome, [&](const fs::path& file) {
    found = found || std::ranges::find(endings, file.extension().string()) != endings.end();
  });
  return found;
}

std::uint64_t bytes_of(const Outcome& outcome) {
  std::uint64_t sum = 0;
  for_each_file(outcome, [&](const fs::path& file) {
    std::error_code missing;
    if (const auto size = fs::file_size(file, missing); !missing) sum += size;
  });
  return sum;
}

PictureCost cost_of(const Settings& settings, const Outcome& outcome, const Outcome& plain) {
  return {.settings = settings,
          .outcome = outcome,
          .more = outcome.cpu - plain.cpu,
          .file_bytes = bytes_of(outcome)};
}

void tell_errors(PictureCost& cost, const Outcome& plain, const SceneNumerics& scene) {
  const double every = std::stod(cost.settings.at(every_key));
  const double width = std::stod(cost.settings.at(width_key));
  const double speed = value_of(plain, *quantity_named("tip.speed")).number.value_or(0.0);
  double pixel = 0.0;
  if (plain.told.contains("plate")) pixel = plain.told["plate"]["width_m"].get<double>() / width;
  cost.errors = {{"seen.time", every}, {"seen.place", std::max(pixel, speed * every)}};
  constexpr double percent = 0.01;
  cost.error =
      score(cost.errors, {{"seen.time", percent * scene.duration}, {"seen.place", scene.horizon}});
}

void mark_front(std::vector<PictureCost>& costs) {
  std::vector<Candidate> all;
  for (const PictureCost& one : costs)
    if (!one.errors.empty()) all.push_back({one.outcome.cpu, one.error});
  const std::vector<bool> front = front_of(all);
  std::size_t next = 0;
  for (PictureCost& one : costs)
    if (!one.errors.empty()) one.on_front = front[next++];
}

}  // namespace

std::vector<PictureCost> picture_costs(CaseRunner& runner, const Outcome& plain) {
  const SceneNumerics scene = numerics_of(plain);
  const Settings& base = plain.setting.settings;
  const Case own{.settings = base, .sample_at = plain.setting.sample_at, .with_pictures = true};
  const Outcome with_own = runner.run_alone(own, "pictures");
  if (!has_movie(with_own)) return {};
  const std::vector<Settings> all = choices(scene.duration);
  std::vector<Case> cases;
  cases.reserve(all.size());
  for (const Settings& settings : all)
    cases.push_back(
        {.settings = joined(base, settings), .sample_at = own.sample_at, .with_pictures = true});
  const std::vector<Outcome> outcomes = runner.run(cases, "pictures");
  std::vector<PictureCost> costs{cost_of({}, with_own, plain)};
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (!outcomes[k].finished()) continue;
    costs.push_back(cost_of(all[k], outcomes[k], plain));
    tell_errors(costs.back(), plain, scene);
  }
  mark_front(costs);
  return costs;
}

}  // namespace hackle
