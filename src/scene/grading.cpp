// SPDX-License-Identifier: MIT
#include "scene/grading.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "base/interrupt.hpp"
#include "base/units.hpp"

namespace hackle {
namespace {

// The cells of a plate, row by row from its lower left corner.
struct GradedCells {
  GradedCells(const Plate& plate, const Grading& grading)
      : size(plate.width, plate.height),
        cell(grading.cell > 0.0 ? grading.cell : size.maxCoeff() / 400.0),
        columns(std::max(1.0, std::round(size.x() / cell))),
        rows(std::max(1.0, std::round(size.y() / cell))) {}

  double count() const { return columns * rows; }
  Vec2 middle(int i, int j) const {
    return size.cwiseProduct(Vec2((i + 0.5) / columns, (j + 0.5) / rows));
  }

  Vec2 size;
  double cell;
  double columns, rows;  // whole numbers, which an int might not hold
};

// The levels of one quantity: equal parts of its range.
class Levels {
 public:
  Levels(const std::vector<double>& values, int count)
      : least_(*std::ranges::min_element(values)),
        width_((*std::ranges::max_element(values) - least_) / count),
        found_(static_cast<std::size_t>(count)) {
    for (const double value : values) {
      auto& [min, max] = found_[level_of(value)];
      min = std::min(min, value);
      max = std::max(max, value);
    }
  }

  std::size_t level_of(double value) const {
    if (!(width_ > 0.0)) return 0;
    return std::min(found_.size() - 1, static_cast<std::size_t>((value - least_) / width_));
  }
  // Returns the middle of the values in the level: exact if they are all the same.
  double middle(std::size_t level) const {
    return found_[level].first + 0.5 * (found_[level].second - found_[level].first);
  }

 private:
  using Found = std::pair<double, double>;
  struct Nothing : Found {
    Nothing() : Found(std::numeric_limits<double>::max(), 0.0) {}
  };

  double least_, width_;
  std::vector<Nothing> found_;
};

double graded_value(const ScalarField& field, std::size_t quantity_index, const Vec2& place) {
  const double value = field.at(place);
  if (std::isfinite(value) && value > 0.0) return value;
  const std::string_view unit = graded_units[quantity_index];
  throw Error(ErrorKind::refused,
              fmt::format("grade: {} is {} at x = {}, y = {}, it must be above 0",
                          graded_names[quantity_index], quantity(value, unit),
                          quantity(place.x(), "m"), quantity(place.y(), "m")));
}

void set(Material& material, std::size_t quantity_index, double value) {
  double* const direct[] = {&material.E, &material.rho, &material.G0};
  if (quantity_index < std::size(direct)) {
    *direct[quantity_index] = value;
  } else if (material.s0 > 0.0) {
    material.s0 *= value;
  } else {
    material.G0 *= value * value;  // goes with the square of the critical stretch
  }
}

// Which cells are graded, with the values of every quantity that is.
struct GradedValues {
  std::vector<std::size_t> cells;
  std::array<std::vector<double>, Grading::quantities> of;
};

GradedValues values_of(const Grading& grading, const GradedCells& cells) {
  GradedValues values;
  std::size_t cell = 0;
  for (int j = 0; j < cells.rows; ++j) {
    throw_if_interrupted();
    for (int i = 0; i < cells.columns; ++i, ++cell) {
      const Vec2 place = cells.middle(i, j);
      if (grading.region && !covers(*grading.region, place, 0.0)) continue;
      values.cells.push_back(cell);
      for (std::size_t k = 0; k < Grading::quantities; ++k)
        if (grading.fields[k]) values.of[k].push_back(graded_value(*grading.fields[k], k, place));
    }
  }
  return values;
}

using Rounded = std::array<std::size_t, Grading::quantities>;  // the level of each quantity

std::map<Rounded, std::vector<std::size_t>> rounded(const GradedValues& values,
                                                    const std::vector<Levels>& levels) {
  std::map<Rounded, std::vector<std::size_t>> cells;
  for (std::size_t n = 0; n < values.cells.size(); ++n) {
    Rounded key{};
    for (std::size_t k = 0; k < Grading::quantities; ++k)
      if (!values.of[k].empty()) key[k] = levels[k].level_of(values.of[k][n]);
    cells[key].push_back(values.cells[n]);
  }
  return cells;
}

Bitmap bitmap_of(const std::vector<std::size_t>& inside, const GradedCells& cells) {
  Bitmap bitmap{{0, 0},
                cells.size,
                static_cast<int>(cells.columns),
                static_cast<int>(cells.rows),
                std::vector<std::uint8_t>(static_cast<std::size_t>(cells.count()))};
  for (const std::size_t cell : inside) bitmap.inside[cell] = 1;
  return bitmap;
}

}  // namespace

void check(const Plate& plate, const Grading& grading, Problems& problems) {
  const double count = GradedCells(plate, grading).count();
  if (!(count <= most_cells))
    problems.add(fmt::format("grade: cells of {} are {:.3g} on the plate, {:.0g} are the most",
                             quantity(grading.cell, "m"), count, most_cells),
                 "give larger cells; half a spacing is fine enough");
  if (std::ranges::none_of(grading.fields, [](const auto& field) { return field.has_value(); }))
    problems.add("grade: nothing is graded",
                 "give E, rho, G0 or strength, as a function of x and y");
}

std::vector<Inclusion> make(const Plate& plate, const Grading& grading) {
  const GradedCells cells(plate, grading);
  const GradedValues values = values_of(grading, cells);
  if (values.cells.empty())
    throw Error(ErrorKind::refused, "grade: no cell has its middle in the area",
                "give a larger area, or smaller cells");
  std::vector<Levels> levels;
  for (const std::vector<double>& of : values.of)
    levels.emplace_back(of.empty() ? std::vector<double>{1.0} : of, grading.levels);
  const auto parts = rounded(values, levels);
  if (parts.size() > most_levels)
    throw Error(ErrorKind::refused,
                fmt::format("grade: its quantities take {} pairs of levels, {} are the most",
                            parts.size(), most_levels),
                "give fewer levels");
  std::vector<Inclusion> inclusions;
  for (const auto& [key, inside] : parts) {
    Inclusion& inclusion =
        inclusions.emplace_back(Inclusion{bitmap_of(inside, cells), grading.material});
    for (std::size_t k = 0; k < Grading::quantities; ++k)
      if (grading.fields[k]) set(inclusion.material, k, levels[k].middle(key[k]));
  }
  return inclusions;
}

}  // namespace hackle
