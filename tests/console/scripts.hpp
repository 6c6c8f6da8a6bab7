// SPDX-License-Identifier: MIT
// Runs scripts in tests.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "console/console.hpp"
#include "support/folder.hpp"

namespace hackle::test {

inline ConsoleSettings quiet(const std::filesystem::path& output_folder = "unused") {
  ConsoleSettings settings;
  settings.output_folder = output_folder;
  settings.talk = Talk::quiet;
  settings.execution.threads = 1;
  return settings;
}

// With --trust.
inline ConsoleSettings trusted(const std::filesystem::path& output_folder = "unused") {
  ConsoleSettings settings = quiet(output_folder);
  settings.trust = true;
  return settings;
}

// Plate p of 100 x 40 mm with an edge crack under load, and simulation s with 50 x 20 nodes.
inline const std::string scene = R"(
p = plate { width = 100*mm, height = 40*mm, material = "duran50" }
p:crack { from = {0, 20*mm}, to = {50*mm, 20*mm} }
p:traction { edge = "top", stress = {0, 12*MPa} }
p:traction { edge = "bottom", stress = {0, -12*MPa} }
s = simulate(p, { spacing = 2*mm })
)";

// Recording r of that simulation, with two records; a new s like the first, and its values v.
inline const std::string recorded = R"(
s:record { "r.h5", every = 1*us }
s:run(1*us)
s:close()
r = recording "r.h5"
s = simulate(p, { spacing = 2*mm })
v = s:values("damage")
)";

// Opens the same recording again in the folder that holds it.
inline const std::string reopened = "r = recording \"r.h5\"\n";

// Plate p of 100 x 40 mm, without cracks or loads.
inline const std::string plate_p =
    "p = plate { width = 100*mm, height = 40*mm, material = 'duran50' }\n";

// Returns the error of the script, or nothing.
inline std::optional<Error> failure_of(const std::string& script, ConsoleSettings settings) {
  try {
    Console console(std::move(settings));
    console.run_text(script, "test.lua");
    return std::nullopt;
  } catch (const Error& error) {
    return error;
  }
}

// Returns its text, or "".
inline std::string message_of(const std::string& script, ConsoleSettings settings = quiet()) {
  const auto failure = failure_of(script, std::move(settings));
  return failure ? failure->what() : "";
}

}  // namespace hackle::test
