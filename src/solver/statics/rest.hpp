// SPDX-License-Identifier: MIT
// What is asked of bringing a plate to rest, once or again and again while loads grow slowly, and
// what comes of it.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace hackle {

struct RelaxOptions {
  // The largest residual force on a node over the largest load or reaction on a node, in (0, 1).
  // Without either: over the largest force at the beginning.
  double tolerance = 1e-8;
  // Called now and then with the progress, 0..1; may throw, which leaves everything unchanged.
  std::function<void(double fraction, int iterations)> progress;
  // For messages: the user's call, and the state of the plate after an interrupt.
  std::string who = "relax";
  std::string left = "as it was";
};

struct RelaxResult {
  int iterations = 0;  // of conjugate gradients, in all Newton steps
  int newton_steps = 0;
  double residual = 0.0;    // residual, in the units of the tolerance
  double max = 0.0;         // the largest stretch of a bond over its critical stretch
  std::int64_t beyond = 0;  // bonds above 1, which the next step will break
};

struct QuasistaticOptions {
  double duration = 0.0;    // s, of the amplitudes of the loads; above 0
  int increments = 10;      // number of equal parts of the duration, >= 1
  double tolerance = 1e-6;  // of RelaxOptions
  bool goes_on = false;     // with the loading in which the snapshot was taken
  // Called now and then with the progress, 0..1, and the present position; may throw.
  std::function<void(double fraction, int increment, int pass, std::int64_t broken)> progress;
};

struct QuasistaticResult {
  // The number of equilibria in each increment: 1 if nothing broke.
  std::vector<int> passes;
  std::int64_t iterations = 0;  // of conjugate gradients
  std::int64_t broken = 0;      // bonds
  // Whether the plate bears the loads to the end. If not, it came apart in the last increment of
  // `passes`: bonds are broken as far as equilibria were found, and a run continues from there.
  bool bears = true;
  std::string why;  // what was then found
};

// How far loads have grown slowly, so that it can go on there.
struct SlowCourse {
  double begin = 0.0, end = 0.0;  // s
  int increments = 0;             // completed
  QuasistaticResult result;       // of those
};

}  // namespace hackle
