// SPDX-License-Identifier: MIT
// In what two stored runs differ: inputs, times, fields.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "measure/view_difference.hpp"
#include "scene/differences.hpp"
#include "store/stored_run.hpp"

namespace hackle {

// A field over all common times at which it differs.
struct FieldCourse {
  double first = 0.0;       // s, when it first differs
  double at = 0.0;          // s, when it differs most
  FieldDifference largest;  // then
  double l2 = 0.0;          // the largest of any time
};

struct RunDifference {
  std::vector<Difference> inputs;  // members of plate and numerics
  bool same_grid = false;          // without it fields are not compared
  std::vector<double> common;      // s, the times that were compared
  // States at times that only one file has. Those of a run file beside a checkpoint do not count.
  std::size_t only_in_one = 0, only_in_other = 0;
  std::vector<FieldCourse> fields;  // those that differ somewhere

  bool is_none() const {
    return inputs.empty() && same_grid && only_in_one + only_in_other == 0 && !common.empty() &&
           fields.empty();
  }
  std::optional<double> first_time() const;  // s, of a difference of fields
};

// Calls progress(share) before each time. Throws Error (files) for a record that is damaged, Error
// (interrupted).
RunDifference difference(
    StoredRun& one, StoredRun& other, const std::function<void(double)>& progress = [](double) {});

}  // namespace hackle
