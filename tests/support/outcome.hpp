// SPDX-License-Identifier: MIT
// Classifies how a run ends.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "measure/field.hpp"
#include "solver/simulation.hpp"

namespace hackle::test {

inline bool is_finite(const Field& field) {
  return std::ranges::all_of(field.values, [](float value) { return std::isfinite(value); });
}

// Expects that no result contains anything but finite numbers.
inline void expect_numbers(const Simulation& simulation, const std::string& what) {
  EXPECT_TRUE(is_finite(displacement(simulation))) << what;
  EXPECT_TRUE(is_finite(velocity(simulation))) << what;
  EXPECT_TRUE(is_finite(damage(simulation))) << what;
}

enum class Outcome { solved, refused, failed };

// Runs `steps` steps. A completed run must contain only finite numbers; any other must end with an
// Error that is either a refusal before the run, or names time and place.
inline Outcome outcome(const Plate& plate, const Numerics& numerics, int steps,
                       const std::string& what) {
  try {
    Simulation simulation(plate, numerics, {1});
    try {
      simulation.run(steps * simulation.dt());
      EXPECT_EQ(simulation.state().step, steps) << what;
      expect_numbers(simulation, what);
      return Outcome::solved;
    } catch (const Error& error) {
      if (error.kind() == ErrorKind::refused) return Outcome::refused;  // an impossible duration
      EXPECT_EQ(error.kind(), ErrorKind::run_failed) << what << ": " << error.what();
      EXPECT_NE(std::string(error.what()).find("diverged by step"), std::string::npos)
          << what << ": " << error.what();
      return Outcome::failed;
    }
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused) << what << ": " << error.what();
    return Outcome::refused;
  }
}

}  // namespace hackle::test
