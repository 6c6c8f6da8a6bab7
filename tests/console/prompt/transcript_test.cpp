// SPDX-License-Identifier: MIT
#include "console/prompt/transcript.hpp"

#include <gtest/gtest.h>

namespace hackle {
namespace {

using Outcome = Transcript::Outcome;
using Chunk = Transcript::Chunk;

std::string written(const Chunk& chunk, Outcome outcome) {
  Transcript transcript;
  transcript.typed(chunk, outcome);
  return transcript.text();
}

TEST(Transcript, WritesWhatDoesTheSameInAScript) {
  const struct {
    Chunk chunk;
    Outcome outcome;
    const char* script;
  } cases[] = {
      {{"x = 1", false, true}, Outcome::nothing, "x = 1\n"},
      {{"s:run(1)", true, true}, Outcome::nothing, "s:run(1)\n"},
      {{"(s):run(1)", true, true}, Outcome::nothing, ";(s):run(1)\n"},
      {{"s.time", true, false}, Outcome::value, "_ = s.time\n"},
      {{"x", true, false}, Outcome::nothing, ";(function(...)\nreturn x\nend)(...)\n"},
      {{"local x = 1", false, true}, Outcome::nothing, ";(function(...)\nlocal x = 1\nend)(...)\n"},
      {{"return 5", false, true}, Outcome::value, "_ = (function(...)\nreturn 5\nend)(...)\n"},
      {{"f() -- no", true, true},
       Outcome::failed,
       "pcall(function(...)\nreturn f() -- no\nend, ...)\n"},
      {{"while true do\nend", false, true},
       Outcome::interrupted,
       "-- interrupted, and left out:\n--   while true do\n--   end\n"},
  };
  for (const auto& [chunk, outcome, script] : cases)
    EXPECT_EQ(written(chunk, outcome), script) << chunk.text;
}

TEST(Transcript, TellsHowFarSimulationsHadGone) {
  Transcript transcript;
  transcript.went_on(2, 341, 12.3e-6, false);
  transcript.went_on(1, 7, 0.0, true);
  transcript.interrupted(1, 9);
  transcript.typed({"s:run(1)", true, true}, Outcome::interrupted);
  EXPECT_EQ(transcript.text(),
            "simulations()[2]:wait { steps = 341 }  -- 12.3 us\n"
            "pcall(function() simulations()[1]:wait { steps = 7 } end)  -- 0 s\n"
            "simulations()[1]:interrupt { steps = 9 }\n"
            "pcall(function(...)\nreturn s:run(1)\nend, ...)\n");
}

}  // namespace
}  // namespace hackle
