// SPDX-License-Identifier: MIT
#include "study/sweep_files.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "base/interrupt.hpp"
#include "base/version.hpp"
#include "movie/make_film.hpp"
#include "render/contact_sheet.hpp"
#include "render/png.hpp"
#include "study/sweep_report.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;

std::vector<SheetPicture> pictures_of(const CaseRunner& runner, const Sweep& sweep) {
  std::vector<SheetPicture> pictures;
  for (const SweepRun& run : sweep.runs) {
    Settings varied;
    for (const Parameter& parameter : sweep.parameters)
      varied[parameter.key] = run.outcome.setting.settings.at(parameter.key);
    const fs::path file = runner.picture_of(run.outcome.setting);
    std::error_code ignored;
    if (run.outcome.finished() && fs::is_regular_file(file, ignored))
      pictures.push_back({file, name_of(varied)});
  }
  if (pictures.empty())
    throw Error(ErrorKind::refused, "no run of the sweep has left a picture",
                "the script must make a simulation");
  return pictures;
}

SheetLayout sheet_layout(const Sweep& sweep, std::size_t count) {
  SheetLayout layout;
  const bool is_matrix =
      sweep.parameters.size() == 2 && count == sweep.runs.size() && !sweep.threshold;
  const std::size_t suits =
      is_matrix ? sweep.parameters.back().values.size()
                : static_cast<std::size_t>(std::ceil(std::sqrt(0.7 * static_cast<double>(count))));
  layout.columns = static_cast<int>(std::clamp<std::size_t>(suits, 1, 50));
  layout.width = layout.columns > 2 ? 320 : 640;
  layout.font = 16.0 / layout.width;
  return layout;
}

MovieFormat film_format(const CaseRunner& runner, const Sweep& sweep, const Image& first) {
  const std::string script = runner.script().path.string();
  return {.width = first.width,
          .height = first.height,
          .fps = 4.0,
          .hold = 1.0,
          .title = fmt::format("{} over {}", script, sweep.parameters.front().key),
          .comment = fmt::format("Made by Hackle {} ({}) from {}", version(), git_hash(), script)};
}

}  // namespace

std::vector<Diagram> charts_of(const Sweep& sweep) {
  std::vector<Diagram> charts;
  if (sweep.parameters.size() != 1) return charts;
  const Parameter& parameter = sweep.parameters.front();
  for (const QuantityRow& row : sweep.quantities) {
    DiagramCurve curve;
    for (const SweepRun& run : sweep.runs)
      if (const auto number = value_of(run.outcome, row).number; number && run.numbers.front())
        curve.points.emplace_back(*run.numbers.front(), *number);
    if (curve.points.size() < 2) continue;
    std::ranges::sort(curve.points, {}, [](const Vec2& point) { return point.x(); });
    Diagram& chart = charts.emplace_back();
    chart.x = {parameter.key, parameter.unit};
    chart.y = {std::string(row.name), std::string(row.unit)};
    chart.curves.push_back(std::move(curve));
  }
  return charts;
}

StudyFindings findings_of(const Sweep& sweep, std::size_t columns) {
  StudyFindings findings{"sweep", text_of(sweep, columns), numbers_of(sweep), charts_of(sweep), {}};
  for (const Diagram& chart : findings.diagrams) {
    std::string name = chart.y.name;
    std::ranges::replace(name, '/', '_');
    std::ranges::replace(name, ' ', '_');
    findings.diagram_names.push_back("sweep-" + name);
  }
  return findings;
}

void write_sheet(const CaseRunner& runner, const Sweep& sweep, const fs::path& path) {
  const std::vector<SheetPicture> pictures = pictures_of(runner, sweep);
  make_folder_of(path);
  write_png(contact_sheet(pictures, sheet_layout(sweep, pictures.size())), path);
}

void write_film(const CaseRunner& runner, const Sweep& sweep, const fs::path& path) {
  if (sweep.parameters.size() != 1)
    throw Error(ErrorKind::refused, "a film runs over one parameter",
                "let one --set have several values");
  const SheetLayout layout{.columns = 1, .width = 1280, .font = 0.02, .tallest = 1.0, .even = true};
  make_folder_of(path);
  std::unique_ptr<Film> film;
  MovieFormat format;
  for (const SheetPicture& picture : pictures_of(runner, sweep)) {
    throw_if_interrupted();
    const Image frame = contact_sheet({picture}, layout);
    if (!film) film = make_film(path, format = film_format(runner, sweep, frame));
    if (frame.width != format.width || frame.height != format.height)
      throw Error(ErrorKind::refused, "the pictures of the runs differ in size: no film",
                  "the plate must keep its shape");
    film->add(frame);
  }
  film->finish();
  film.reset();
  publish(path);
}

}  // namespace hackle
