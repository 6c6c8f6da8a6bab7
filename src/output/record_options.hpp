// SPDX-License-Identifier: MIT
// What a user asks of a run file.
#pragma once

namespace hackle {

struct RecordOptions {
  double every = 0.0;  // simulated seconds from record to record, at least a step
};

}  // namespace hackle
