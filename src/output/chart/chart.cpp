// SPDX-License-Identifier: MIT
#include "output/chart/chart.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "base/text.hpp"
#include "base/units.hpp"
#include "measure/heading.hpp"
#include "output/chart/chart_kind.hpp"
#include "output/picture/paper.hpp"
#include "render/diagram/diagram_file.hpp"
#include "scene/check_members.hpp"

namespace hackle {
namespace {

constexpr std::string_view who = "chart";

Paper paper_of(const ChartOptions& options) {
  return {options.width, options.paper, options.dpi, options.font_size};
}

DiagramStyle style_of(const ChartOptions& options) {
  const Paper paper = paper_of(options);
  const int width = pixels_of(paper);
  constexpr double height_share = 0.62, font_share = 1.0 / 58.0;
  const double given = font_pixels(paper);
  const double font = given > 0.0 ? given : std::max(11.0, std::round(font_share * width));
  return {{width, static_cast<int>(std::lround(height_share * width)), font},
          options.dpi,
          options.look};
}

std::string in_words(std::string name) {
  std::ranges::replace(name, '.', ' ');
  std::ranges::replace(name, '_', ' ');
  return name;
}

// Collects the curves of a chart, which share the units of its axes.
class ChartMaker {
 public:
  ChartMaker(const std::vector<ChartSource>& sources, const ChartOptions& options)
      : sources_(sources), options_(options) {
    diagram_.x.name = in_words(options.x);
  }

  void add_columns(const std::vector<std::string>& names) {
    for (const ChartSource& source : sources_)
      for (const std::string& name : names) {
        const auto pair = source.pair(options_.x, name);
        if (!pair) refuse_missing(source, name);
        add(source, names.size() > 1 || sources_.size() == 1 ? in_words(name) : "", name, *pair);
      }
    diagram_.y.name = names.size() == 1 ? in_words(names.front()) : "value";
  }

  // Columns that are 0 throughout are left out, unless all are.
  void add_kind(const ChartKind& kind) {
    for (const ChartSource& source : sources_) {
      std::vector<Known> known = columns_of(source, kind);
      if (known.empty()) refuse_missing(source, std::string(kind.columns.front()));
      if (std::ranges::any_of(known, says)) std::erase_if(known, std::not_fn(says));
      for (const Known& column : known)
        add(source, kind.columns.size() > 1 ? in_words(column.name) : "", column.name, column.pair);
    }
    diagram_.y.name = kind.title;
  }

  void add_level_of_rayleigh() {
    std::optional<double> known;
    for (const ChartSource& source : sources_)
      if (const auto speed = source.rayleigh(); speed && speed != known) {
        diagram_.levels.push_back({"c_R", *speed});
        known = speed;
      }
  }

  void add_loads() {
    for (const ChartSource& source : sources_) {
      const std::size_t before = diagram_.curves.size();
      const std::vector<std::string> loads = loads_in(source);
      for (const std::string& load : loads) add_load(source, load, loads.size() > 1);
      if (diagram_.curves.size() == before)
        throw Error(ErrorKind::refused,
                    fmt::format("chart: {} has no forces with their ways", source.name()),
                    "name the load, and let s:log note them, as in s:log { \"run.csv\", "
                    "\"grip.fy\", \"grip.uy\" }");
    }
    diagram_.x.name = "way";
    diagram_.y.name = chart_kind("load")->title;
  }

  void add_histogram() {
    for (const ChartSource& source : sources_) {
      const auto values = source.field(options_.field, options_.time);
      if (!values)
        throw Error(ErrorKind::refused,
                    fmt::format("chart: {} is a table, it has no field", source.name()),
                    "a histogram needs a run file");
      add_bars(source, *values);
    }
    diagram_.x.name = in_words(options_.field);
    diagram_.y.name = chart_kind("histogram")->title;
  }

  Diagram diagram(const std::string& title) {
    diagram_.title = options_.title.value_or(title);
    diagram_.x.range = options_.x_range;
    diagram_.y.range = options_.y_range;
    diagram_.x.logarithmic = options_.x_scale == Scale::log;
    diagram_.y.logarithmic = options_.y_scale == Scale::log;
    if (diagram_.curves.size() == 1) diagram_.curves.front().name.clear();
    return std::move(diagram_);
  }

 private:
  struct Known {
    std::string name;
    ChartSource::Pair pair;
  };

  std::vector<Known> columns_of(const ChartSource& source, const ChartKind& kind) const {
    std::vector<Known> known;
    for (const std::string_view name : kind.columns)
      if (auto pair = source.pair(options_.x, std::string(name)))
        known.push_back({std::string(name), std::move(*pair)});
    return known;
  }

  static bool says(const Known& column) {
    return std::ranges::any_of(column.pair.y.values,
                               [](double value) { return std::isfinite(value) && value != 0.0; });
  }

  void take_unit(DiagramAxis& axis, const std::string& unit, const std::string& name) {
    if (diagram_.curves.empty()) axis.unit = unit;
    if (axis.unit == unit) return;
    const auto named = [](const std::string& u) { return u.empty() ? "no unit" : u; };
    throw Error(ErrorKind::refused,
                fmt::format("chart: '{}' has {}, what stands before it {}", name, named(unit),
                            named(axis.unit)),
                "make a chart for each unit");
  }

  void add(const ChartSource& source, const std::string& label, const std::string& name,
           const ChartSource::Pair& pair) {
    take_unit(diagram_.x, pair.x.unit, options_.x);
    take_unit(diagram_.y, pair.y.unit, name);
    DiagramCurve curve{label, {}};
    if (sources_.size() > 1)
      curve.name = label.empty() ? source.name() : fmt::format("{} {}", source.name(), label);
    for (std::size_t k = 0; k < pair.x.values.size(); ++k)
      curve.points.emplace_back(pair.x.values[k], pair.y.values[k]);
    diagram_.curves.push_back(std::move(curve));
  }

  // Returns the names of loads of which the source has a force.
  static std::vector<std::string> loads_in(const ChartSource& source) {
    std::vector<std::string> loads;
    for (const std::string& name : source.names())
      if (name.ends_with("_fx") || name.ends_with("_fy")) {
        const std::string load = name.substr(0, name.size() - 3);
        if (std::ranges::find(loads, load) == loads.end()) loads.push_back(load);
      }
    return loads;
  }

  static double largest(const ChartSource::Pair& pair) {
    double size = 0.0;
    for (const double value : pair.y.values)
      if (std::isfinite(value)) size = std::max(size, std::abs(value));
    return size;
  }

  // Tables hold the force of the plate on the load.
  void add_load(const ChartSource& source, const std::string& load, bool is_named) {
    const auto along_x = source.pair(load + ".ux", load + ".fx");
    const auto along_y = source.pair(load + ".uy", load + ".fy");
    if (!along_x && !along_y) return;
    const bool is_x = along_x && (!along_y || largest(*along_x) > largest(*along_y));
    ChartSource::Pair pair = is_x ? *along_x : *along_y;
    for (double& value : pair.y.values) value = 0.0 - value;
    add(source, is_named || sources_.size() == 1 ? in_words(load) : "", load, pair);
  }

  void add_bars(const ChartSource& source, const NodeValues& values) {
    take_unit(diagram_.x, values.unit(), options_.field);
    diagram_.y.unit = "";
    const Ends ends = options_.x_range.value_or(Ends{values.min().value, values.max().value});
    const double step = ends.max > ends.min ? (ends.max - ends.min) / options_.bins : 1.0;
    DiagramCurve curve{source.name(), {}, DiagramStroke::bars};
    for (int k = 0; k < options_.bins; ++k)
      curve.points.emplace_back(ends.min + (k + 0.5) * step, 0);
    values.for_each([&](int, int, double value) {
      const double place = (value - ends.min) / step;
      if (!(place >= 0.0 && place <= options_.bins)) return;
      const auto bin = std::min(static_cast<std::size_t>(place), curve.points.size() - 1);
      curve.points[bin].y() += 1.0;
    });
    diagram_.curves.push_back(std::move(curve));
  }

  [[noreturn]] void refuse_missing(const ChartSource& source, const std::string& name) const {
    std::vector<std::string> names = source.names();
    for (const ChartKind& kind : chart_kinds()) names.emplace_back(kind.name);
    const std::vector<std::string_view> known(names.begin(), names.end());
    throw Error(ErrorKind::refused,
                fmt::format("chart: {} has no table with '{}' and '{}'{}", source.name(),
                            options_.x, name, did_you_mean(name, known)),
                "s:log notes columns, see help \"columns\"; it has " + comma_list(known));
  }

  const std::vector<ChartSource>& sources_;
  const ChartOptions& options_;
  Diagram diagram_;
};

}  // namespace

void check(const std::string& caller, const ChartOptions& options) {
  Problems problems;
  check_members(options, caller, problems);
  check_paper(caller, paper_of(options), problems);
  const auto check_range = [&](const char* name, const std::optional<Ends>& range, Scale scale) {
    if (range && !(range->min < range->max))
      problems.add(fmt::format("{}: {} has no width", caller, name), "the smaller value is first");
    else if (range && scale == Scale::log && !(range->min > 0.0))
      problems.add(fmt::format("{}: {} begins at {}, a logarithmic scale needs more than 0", caller,
                               name, shortest(range->min)));
  };
  check_range("x_range", options.x_range, options.x_scale);
  check_range("y_range", options.y_range, options.y_scale);
  problems.throw_if_any();
}

Diagram chart_of(const std::vector<ChartSource>& sources, const std::vector<std::string>& what,
                 const ChartOptions& options) {
  ChartMaker chart(sources, options);
  const ChartKind* kind = what.size() == 1 ? chart_kind(what.front()) : nullptr;
  if (kind == nullptr)
    chart.add_columns(what);
  else if (kind->name == "load")
    chart.add_loads();
  else if (kind->name == "histogram")
    chart.add_histogram();
  else
    chart.add_kind(*kind);
  if (std::ranges::any_of(
          what, [](const std::string& name) { return name == "speed" || name == "tip.speed"; }))
    chart.add_level_of_rayleigh();
  return chart.diagram(sources.size() == 1 ? sources.front().name() : "");
}

std::filesystem::path table_of_chart(std::filesystem::path picture) {
  return picture.replace_extension(".chart.csv");
}

void write_chart(const Diagram& diagram, const ChartOptions& options,
                 const std::filesystem::path& path) {
  make_folder_of(path);
  write_diagram(diagram, style_of(options), path);
  write_text(table_of_chart(path), csv_of(diagram));
}

}  // namespace hackle
