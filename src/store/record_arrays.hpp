// SPDX-License-Identifier: MIT
// The datasets of a record, as they are written and compared.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "solver/simulation.hpp"
#include "store/hdf5.hpp"
#include "store/record_contents.hpp"

namespace hackle {

struct RecordArray {
  std::string name, unit, long_name;
  std::vector<hsize_t> shape;  // in the file: rows, or rows and columns
  hsize_t given = 1;           // columns of the values; the others are 0
  // Their type is that of the file.
  std::variant<std::vector<float>, std::vector<double>, std::vector<std::uint32_t>> values;

  std::size_t size() const;
  // Of one of `given` times shape[0] values.
  double value(std::size_t at) const;
};

// Calls visit for one dataset after the other; `with_state` adds the arrays of the state, to the
// last bit (exact_state.hpp). Throws Error (run_failed) if a value is not a finite float.
void for_each_dataset(const Simulation& simulation, const RecordContents& contents, bool with_state,
                      const std::function<void(const RecordArray&)>& visit);

}  // namespace hackle
