// SPDX-License-Identifier: MIT
// What the end of a cell of the envelope is worth.
#pragma once

#include <string>
#include <string_view>

#include "base/described.hpp"
#include "study/case.hpp"
#include "study/envelope_cells.hpp"

namespace hackle {

enum class CellEnd {
  right,    // exit code 0; finite numbers; every expectation passes; a ledger open by 5 % is said
  refused,  // exit code 3 or 4, before the run, with a remedy
  stopped,  // an error that names cause, time and place
  failed,   // anything else, and an end that the cell does not allow
};

template <>
inline constexpr auto enum_names<CellEnd> = std::to_array<std::string_view>({"right", "refused",
                                                                             "stopped", "failed"});

struct CellVerdict {
  CellEnd end = CellEnd::failed;
  std::string why;  // what failed, or the message of the program; of a right result what it passed
};

// Returns the verdict on an outcome. A crash, a run that was ended after its time, output that is
// not JSON or has a number that is not finite, and a message that lacks what it must name fail.
CellVerdict verdict_of(const Outcome& outcome, Demand demand);

}  // namespace hackle
