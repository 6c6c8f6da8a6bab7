// SPDX-License-Identifier: MIT
#include "store/run_difference.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/interrupt.hpp"

namespace hackle {
namespace {

// Rounding makes no other time of one.
constexpr double same_time = 1e-9;  // of the last time

bool is_same(const Grid& one, const Grid& other) {
  return one.nx == other.nx && one.ny == other.ny && one.dx == other.dx &&
         one.centre == other.centre;
}

struct Pairs {
  std::vector<std::pair<std::size_t, std::size_t>> places;  // of states at one time
  std::size_t only_in_one = 0, only_in_other = 0;
};

Pairs paired(const std::vector<double>& one, const std::vector<double>& other) {
  const double tolerance = same_time * std::max(std::abs(one.back()), std::abs(other.back()));
  Pairs pairs;
  std::size_t k = 0, l = 0;
  while (k < one.size() && l < other.size()) {
    if (std::abs(one[k] - other[l]) <= tolerance)
      pairs.places.emplace_back(k++, l++);
    else if (one[k] < other[l])
      ++k, ++pairs.only_in_one;
    else
      ++l, ++pairs.only_in_other;
  }
  pairs.only_in_one += one.size() - k;
  pairs.only_in_other += other.size() - l;
  return pairs;
}

void add(std::vector<FieldCourse>& courses, const FieldDifference& field, double time) {
  if (field.is_none()) return;
  const auto known = std::ranges::find_if(
      courses, [&](const FieldCourse& course) { return course.largest.name == field.name; });
  if (known == courses.end()) {
    courses.push_back({time, time, field, field.l2});
    return;
  }
  known->l2 = std::max(known->l2, field.l2);
  if (field.max <= known->largest.max) return;
  known->largest = field;
  known->at = time;
}

std::vector<Difference> of_inputs(const Inputs& one, const Inputs& other) {
  std::vector<Difference> list = Differences(one.plate, other.plate).list();
  const std::vector<Difference> numerics = Differences(one.numerics, other.numerics).list();
  list.insert(list.end(), numerics.begin(), numerics.end());
  return list;
}

}  // namespace

std::optional<double> RunDifference::first_time() const {
  if (fields.empty()) return std::nullopt;
  return std::ranges::min_element(fields, {}, &FieldCourse::first)->first;
}

RunDifference difference(StoredRun& one, StoredRun& other,
                         const std::function<void(double)>& progress) {
  RunDifference found;
  found.inputs = of_inputs(one.inputs(), other.inputs());
  found.same_grid = is_same(one.view().lattice().grid, other.view().lattice().grid);
  if (!found.same_grid) return found;
  const Pairs pairs = paired(one.times(), other.times());
  const bool both_runs = one.kind() == other.kind();
  if (both_runs || pairs.places.empty()) {
    found.only_in_one = pairs.only_in_one;
    found.only_in_other = pairs.only_in_other;
  }
  const Compared how =
      one.is_exact() && other.is_exact() ? Compared::in_double : Compared::in_single;
  const bool with_velocity = one.velocity_is_of_its_time() == other.velocity_is_of_its_time();
  for (const auto& [k, l] : pairs.places) {
    throw_if_interrupted();
    progress(static_cast<double>(found.common.size()) / static_cast<double>(pairs.places.size()));
    one.show(k);
    other.show(l);
    found.common.push_back(one.times()[k]);
    for (const FieldDifference& field : differences(one.view(), other.view(), how))
      if (with_velocity || field.name != "velocity") add(found.fields, field, found.common.back());
  }
  return found;
}

}  // namespace hackle
