// SPDX-License-Identifier: MIT
#include "study/measurement.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "study/parameter.hpp"

namespace hackle {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr std::size_t most_points = 60;

[[noreturn]] void refuse_measurement(std::string_view word, std::string_view what,
                                     std::string remedy = {}) {
  throw Error(ErrorKind::usage, fmt::format("'{}': {}", word, what), std::move(remedy));
}

std::vector<std::string> cells_in(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream text(line);
  for (std::string cell; std::getline(text, cell, ',');) {
    std::erase_if(cell, [](char c) { return c == '"' || c == '\r'; });
    cells.push_back(cell);
  }
  return cells;
}

// A column of a table: its place, and the size of its unit in m.
struct LengthColumn {
  std::size_t at = 0;
  double factor = 1.0;
};

// "x", "x_mm", "x (mm)", "x [mm]"
std::optional<LengthColumn> column_named(const std::vector<std::string>& heads, char name) {
  for (std::size_t k = 0; k < heads.size(); ++k) {
    std::string head = heads[k];
    std::erase_if(
        head, [](char c) { return std::string_view(" ()[]_").find(c) != std::string_view::npos; });
    if (head.empty() || std::tolower(static_cast<unsigned char>(head.front())) != name) continue;
    const std::string unit = head.substr(1);
    if (unit.empty()) return LengthColumn{k, 1.0};
    if (const auto measure = measure_of("1" + unit)) return LengthColumn{k, measure->factor};
  }
  return std::nullopt;
}

// Returns at most so many points, the first and the last among them.
Line thinned(const Line& line) {
  if (line.size() <= most_points) return line;
  Line fewer;
  for (std::size_t k = 0; k < most_points; ++k)
    fewer.push_back(line[k * (line.size() - 1) / (most_points - 1)]);
  return fewer;
}

Line line_in(const std::string& file) {
  std::istringstream lines(read_text(file));
  std::string text;
  std::getline(lines, text);
  const std::vector<std::string> heads = cells_in(text);
  const auto x = column_named(heads, 'x'), y = column_named(heads, 'y');
  if (!x || !y)
    throw Error(ErrorKind::files, fmt::format("'{}' has no columns x and y", file),
                "its first line names them, as in x_mm,y_mm");
  Line line;
  for (int number = 2; std::getline(lines, text); ++number) {
    const std::vector<std::string> cells = cells_in(text);
    if (cells.empty()) continue;
    const auto value = [&](const LengthColumn& column) {
      const auto measure =
          column.at < cells.size() ? measure_of(cells[column.at]) : std::optional<Measure>();
      if (!measure)
        throw Error(ErrorKind::files,
                    fmt::format("'{}', line {}: '{}' is no number", file, number,
                                column.at < cells.size() ? cells[column.at] : ""));
      return measure->value() * column.factor;
    };
    line.emplace_back(value(*x), value(*y));
  }
  if (line.empty()) throw Error(ErrorKind::files, fmt::format("'{}' has no points", file));
  return thinned(line);
}

Vec2 place_in(std::string_view word, std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma != std::string_view::npos) {
    auto x = measure_of(text.substr(0, comma));
    const auto y = measure_of(text.substr(comma + 1));
    if (x && y && x->unit.empty()) x->factor = y->factor;
    if (x && y) return {x->value(), y->value()};
  }
  refuse_measurement(word, "a place is X,Y", "as in fork.place=67mm,20mm");
}

Vec2 nearest_on(const Vec2& a, const Vec2& b, const Vec2& point) {
  const Vec2 along = b - a;
  const double squared = along.squaredNorm();
  return squared > 0.0 ? Vec2(a + std::clamp((point - a).dot(along) / squared, 0.0, 1.0) * along)
                       : a;
}

Vec2 nearest_in(const std::vector<Line>& lines, const Vec2& point) {
  Vec2 nearest = lines.front().front();
  for (const Line& line : lines)
    for (std::size_t k = 0; k < line.size(); ++k) {
      const Vec2 found = nearest_on(line[k], line[std::min(k + 1, line.size() - 1)], point);
      if ((found - point).squaredNorm() < (nearest - point).squaredNorm()) nearest = found;
    }
  return nearest;
}

}  // namespace

Index Measurement::size() const {
  if (value.place) return 2;
  return value.paths.empty() ? 1 : static_cast<Index>(2 * value.paths.front().size());
}

std::optional<VectorXd> Measurement::residuals(const Outcome& outcome, double deviation) const {
  const QuantityValue got = value_of(outcome, row);
  if (!got.found()) return std::nullopt;
  VectorXd all(size());
  if (value.number) {
    all[0] = *got.number - *value.number;
  } else if (value.place) {
    all = *got.place - *value.place;
  } else {
    const Line& points = value.paths.front();
    for (std::size_t k = 0; k < points.size(); ++k)
      all.segment<2>(static_cast<Index>(2 * k)) = nearest_in(got.paths, points[k]) - points[k];
    all /= std::sqrt(static_cast<double>(points.size()));
  }
  return all / deviation;
}

Measurement measurement_of(std::string_view word) {
  const std::size_t equals = word.find('=');
  if (equals == 0 || equals == std::string_view::npos || equals + 1 == word.size())
    refuse_measurement(word, "it is not NAME=VALUE", "as in --to fork.time=22us");
  const std::string_view text = word.substr(equals + 1);
  Measurement result{.row = quantities_named({std::string(word.substr(0, equals))}).front(),
                     .text = std::string(text)};
  switch (result.row.kind) {
    case ComparedAs::place:
      result.value.place = place_in(word, text);
      return result;
    case ComparedAs::paths:
      result.value.paths = {line_in(std::string(text))};
      return result;
    case ComparedAs::field:
      refuse_measurement(word, "a field cannot be fitted to");
    default:
      break;
  }
  const auto number = measure_of(text);
  if (!number) refuse_measurement(word, "not a number with its unit", "as in --to fork.time=22us");
  result.value.number = number->value();
  return result;
}

void set_sigma(std::vector<Measurement>& all, std::string_view word) {
  const std::size_t equals = std::min(word.find('='), word.size());
  const auto found = std::ranges::find(all, word.substr(0, equals),
                                       [](const Measurement& one) { return one.row.name; });
  const auto value = measure_of(word.substr(std::min(equals + 1, word.size())));
  if (found == all.end() || !value || !(value->value() > 0.0))
    refuse_measurement(word, "not NAME=VALUE of something that --to measures",
                       "as in --sigma fork.time=0.5us");
  found->sigma = value->value();
}

}  // namespace hackle
