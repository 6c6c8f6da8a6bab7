// SPDX-License-Identifier: MIT
// Notes of a run whose step does not resolve the events, from outside.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "app/program.hpp"
#include "base/files.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;
using testing::Not;

class NotesTest : public testing::Test {
 protected:
  test::Ended run(const std::string& script, std::vector<std::string> words = {}) {
    write_text(folder_.path / "a.lua", script);
    words.insert(words.begin(), {"run", "a.lua"});
    return program_.run(words);
  }

  // A clamped plate of 20 x 10 mm with the load `pull` at its top.
  std::string pulled(const std::string& pull, const std::string& more = "") {
    return R"(p = plate { width = 20*mm, height = 10*mm, material = "duran50" }
              p:clamp { edge = "bottom", depth = 1*mm }
              p:traction { edge = "top", )" +
           pull + "}\n" + more + R"(
              s = simulate(p, { spacing = 0.5*mm, surface = "energy" })
              s:run(10*us)
              print(s.damage.broken_bonds))";
  }

  test::Folder folder_;
  test::Program program_{folder_};
};

TEST_F(NotesTest, ADampedPlateUnderASmallLoadStaysWhole) {
  const auto ended = run(pulled("stress = {0, 1e3}", "p:damping { rate = 3e6 }"));
  EXPECT_EQ(ended.code, 0);
  EXPECT_EQ(ended.out, "0\n");
  EXPECT_THAT(ended.err, Not(HasSubstr("note")));
}

TEST_F(NotesTest, WhatComesAndGoesBetweenStepsIsSaidBeforeTheRun) {
  for (const char* amplitude :
       {"time = pulse(1e-12)", "time = {{0, 0}, {1.01*us, 0}, {1.02*us, 1}, {1.03*us, 0}}",
        "time = function(t) return math.sin(2*math.pi*t/20e-9) end"}) {
    const auto ended = run(pulled(std::string("stress = {0, 1e6}, ") + amplitude));
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_THAT(ended.err, HasSubstr("note: traction comes and goes within")) << amplitude;
    EXPECT_THAT(ended.err, HasSubstr("give a step of")) << amplitude;
  }
  const auto ended = run(pulled("stress = {0, 1e6}, time = ramp(2*us)"));
  EXPECT_THAT(ended.err, Not(HasSubstr("note")));
}

TEST_F(NotesTest, ALedgerThatDoesNotCloseIsSaidAtTheEndAndInJson) {
  const std::string cold = R"(
    p = plate { width = 20*mm, height = 10*mm, material = material { like = "duran50", alphaT = 3.3e-6 } }
    p:temperature { change = -1500, from = {5*mm, 2*mm}, to = {15*mm, 8*mm} }
    s = simulate(p, { spacing = 0.5*mm })
    s:run(5*us))";
  const auto ended = run(cold, {"--json"});
  EXPECT_EQ(ended.code, 0);
  const auto json = nlohmann::json::parse(ended.out);
  std::string notes;
  for (const auto& note : json["notes"]) notes += note.get<std::string>() + "\n";
  EXPECT_THAT(notes, HasSubstr("stretches bonds by"));
  const bool closes = std::abs(json["residual_share"].get<double>()) <= 0.05;
  EXPECT_EQ(notes.find("the energies do not add up") == std::string::npos, closes);
}

TEST_F(NotesTest, AFastDiscIsSolvedWithAStepThatResolvesIt) {
  for (const char* speed : {"100", "1000", "10000", "30000"}) {
    const auto ended = run(std::string("VV = ") + speed + R"(
      p = plate { width = 3*mm, height = 20*mm, material = "duran50" }
      p:impactor { centre = {-2.5*mm, 10*mm}, radius = 0.5*mm, velocity = {VV, 0} }
      s = simulate(p, { spacing = 0.5*mm, horizon = 2*mm })
      s:run(12*mm/VV)
      print(VV*s.dt <= 0.05*mm*(1 + 1e-9), s.damage.broken_bonds > 0))");
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(ended.out, "true\ttrue\n") << speed;
  }
}

}  // namespace
}  // namespace hackle
