// SPDX-License-Identifier: MIT
#include <fstream>

#include <gmock/gmock.h>

#include "base/files.hpp"
#include "console/scripts.hpp"
#include "output/run/proof.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

// What a plate p may have, and what its simulation s does before it is saved.
struct Scene {
  const char* name;
  const char* plate;
  const char* options;
  const char* before;
};
void PrintTo(const Scene& scene, std::ostream* out) {
  *out << scene.name;
}

constexpr Scene scenes[] = {
    {"plain", "", "", "s:run(12.3*us)"},
    {"single_precision", "", ", precision = 'f32'", "s:run(12.3*us)"},
    {"history", "p = make { like = 'duran50', alpha = 0.3 }", "", "s:run(12.3*us)"},
    {"widened", "p:initial { velocity = {0, 3000} }", ", precision = 'f32'",
     "s:run(40*us) s:move { from = {0, 0}, to = {5*mm, 5*mm}, displacement = {0, 0} } s:run(1*us)"},
    {"heat",
     "p = make { like = 'duran50', alphaT = 4e-6 } "
     "p:temperature { change = -300, time = ramp(20*us) }",
     "", "s:run(12.3*us)"},
    {"contact",
     "p:contact { friction = 0.3, restitution = 0.5 } p:crack { from = {60*mm, 0}, to = "
     "{60*mm, 40*mm} } p:traction { edge = 'right', stress = {-30*MPa, 0} }",
     "", "s:run(12.3*us)"},
    {"impact",
     "p:impactor { centre = {80*mm, 46*mm}, radius = 5*mm, velocity = {0, -300}, mass = "
     "0.5 }",
     "", "s:run(12.3*us)"},
    {"led",
     "p:roller { centre = {80*mm, 45*mm}, radius = 5*mm, velocity = {0, -20} } "
     "p:clamp { edge = 'right', depth = 2*mm } p:foundation { stiffness = 1e12 }",
     "", "s:run(12.3*us)"},
    {"damped", "p:damping { rate = 1e5, stiffness = 1e-9 } p:absorb { edge = 'right' }", "",
     "s:run(12.3*us)"},
    {"scattered",
     "p:strength { modulus = 10, seed = 3 } p:inclusion { material = 'soda_lime', "
     "centre = {70*mm, 10*mm}, radius = 5*mm } p:hole { centre = {80*mm, 30*mm}, "
     "radius = 4*mm }",
     ", surface = 'energy'", "s:run(12.3*us)"},
    {"at_rest", "", "", "s:relax() "},
    {"slow",
     "p = plate { width = 100*mm, height = 40*mm, material = 'duran50' } "
     "p:crack { from = {0, 20*mm}, to = {50*mm, 20*mm} } "
     "p:clamp { edge = 'right', depth = 2*mm } "
     "p:traction { edge = 'top', stress = {0, 1*MPa}, time = ramp(3*us) }",
     "", "s:quasistatic { duration = 3*us, increments = 3 }"},
    {"changed", "", "",
     "s:run(5.1*us) s:traction { edge = 'top', stress = {0, 20*MPa} } s:damping { rate = 1e4 } "
     "s:run(3.3*us)"},
};

class Checkpoints : public testing::TestWithParam<Scene> {};

// Makes the simulation s of a scene.
std::string script_of(const Scene& scene) {
  return std::string(R"(
    local function make(glass)
      local p = plate { width = 100*mm, height = 40*mm, material = material(glass) }
      p:crack { from = {0, 20*mm}, to = {50*mm, 20*mm} }
      p:traction { edge = "top", stress = {0, 12*MPa} }
      return p:traction { edge = "bottom", stress = {0, -12*MPa} }
    end
    local p = make "duran50"
    )") + scene.plate +
         "\nlocal s = simulate(p, { spacing = 1*mm" + scene.options + " })\n" + scene.before;
}

// On as many threads as there are, with the bits of a run that was never stopped, and on from
// there: the remainder of a step that a run went too far is kept, too.
TEST_P(Checkpoints, GoOnAsIfNothingHadBeen) {
  const test::Folder folder;
  const std::string text = script_of(GetParam()) + R"(
    s:save { "a.ckpt" }
    local t = load "a.ckpt"
    assert(t.hash == s.hash and t.time == s.time and t.steps == s.steps)
    for k = 1, 3 do
      s:run(3.7*us) t:run(3.7*us)
      assert(t.hash == s.hash, "other bits after " .. k)
      assert(t.time == s.time and t.steps == s.steps, "another time")
      for _, entry in ipairs { "external", "kinetic", "strain", "broken", "damped", "released",
                               "contact", "residual" } do
        assert(t.energy[entry] == s.energy[entry], "another ledger: " .. entry)
      end
    end
    s:traction { edge = "right", stress = {20*MPa, 0} } t:traction { edge = "right", stress = {20*MPa, 0} }
    s:run(2*us) t:run(2*us)
    assert(t.hash == s.hash)
  )";
  ConsoleSettings settings = test::quiet(folder.path);
  settings.execution.threads = 0;
  EXPECT_EQ(test::message_of(text, settings), "");
}

// A run file of it can be computed again, and its exact records are checkpoints: those of its first
// and last step.
TEST_P(Checkpoints, AreInExactRecordsToo) {
  const test::Folder folder;
  const std::string text = script_of(GetParam()) + R"(
    local f = s:fork()
    f:record { "a.h5", steps = 3, exact = true }
    f:step(6) f:traction { edge = "top", stress = {0, 9*MPa} } f:step(3) f:close()
    local t, u = load { "a.h5", time = 0 }, load "a.h5"
    assert(t.hash == s.hash and u.hash == f.hash and u.steps == f.steps)
    t:step(6) t:traction { edge = "top", stress = {0, 9*MPa} } t:step(3)
    assert(t.hash == f.hash)
    s:step(6) s:traction { edge = "top", stress = {0, 9*MPa} } s:step(8) u:step(5)
    assert(u.hash == s.hash)
  )";
  EXPECT_EQ(test::message_of(text, test::quiet(folder.path)), "");
  const Proof proof = prove(folder.path / "a.h5", {2}, Talk::quiet);
  EXPECT_EQ(proof.compared, 4U);
  EXPECT_EQ(proof.stopped, "");
  EXPECT_FALSE(proof.difference) << proof.difference->quantity;
}
INSTANTIATE_TEST_SUITE_P(OfScenes, Checkpoints, testing::ValuesIn(scenes),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(CheckpointBinding, TwoFuturesComeFromOneFile) {
  const test::Folder folder;
  EXPECT_EQ(test::message_of(test::scene + R"(
    s:run(5*us) s:save { "a.ckpt" }
    local one, other = load "a.ckpt", load { "a.ckpt" }
    other:traction { edge = "top", stress = {0, 0} }
    one:run(5*us) other:run(5*us) s:run(5*us)
    assert(one.hash == s.hash and other.hash ~= s.hash)
    one:frame { "a.png", width = 320 }
  )",
                             test::quiet(folder.path)),
            "");
}

TEST(CheckpointBinding, AFunctionOfTheScriptMaySave) {
  const test::Folder folder;
  EXPECT_EQ(test::message_of(test::scene + R"(
    s:on { "every", every = 2*us, call = function() s:save { "a.ckpt" } end }
    s:run(5*us)
    local t = load "a.ckpt"
    assert(t.steps == 5 and load("a_prev.ckpt").steps == 3, t.steps)
    t:run(5*us - t.time)
    assert(t.hash == s.hash)
  )",
                             test::quiet(folder.path)),
            "");
}

TEST(CheckpointBinding, RefusesWhatItCannotDo) {
  const test::Folder folder;
  write_text(folder.path / "b.ckpt", "no checkpoint, but long enough to be one");
  for (const auto& [text, message] : std::initializer_list<std::pair<const char*, const char*>>{
           {"s:save { 'a.h5' }", "no checkpoint (one of .ckpt"},
           {"s:save {}", "save: file is missing"},
           {"load 'nowhere.ckpt'", "No such file"},
           {"load 'b.ckpt'", "it does not begin with 'Hackle checkpoint 2'"},
           {"load { 'b.ckpt', time = 1*us }", "a checkpoint has one time only"},
           {"load 'nowhere.h5'", "there is no such file"},
           {"s:record { 'c.h5', every = 1*us } s:run(2*us) s:close() load { 'c.h5', time = 2*us }",
            "its record at 2 us does not hold the exact state"},
           {"load { 'b.ckpt', 3 }", "3 stands in the braces without a name"},
           {"s:frame { 'c.png' } s:save { 'c.png' }", "no checkpoint"}})
    EXPECT_THAT(test::message_of(test::scene + text, test::quiet(folder.path)), HasSubstr(message))
        << text;
}

// What a load is at a place or time, only the script can tell.
TEST(CheckpointBinding, AFunctionIsRefusedWithTheReason) {
  const test::Folder folder;
  EXPECT_THAT(test::message_of(test::plate_p + R"(
    p:traction { edge = "top", stress = {0, 1*MPa}, time = function(t) return t end }
    local s = simulate(p, { spacing = 2*mm })
    s:run(1*us) s:save { "a.ckpt" } load("a.ckpt"):run(1*us)
  )",
                               test::quiet(folder.path)),
              HasSubstr("function"));
}

TEST(CheckpointBinding, LoadStillCompilesLua) {
  EXPECT_EQ(test::message_of("assert(load 'return 7'() == 7) assert(load('return x', 'c', 't', "
                             "{ x = 3 })() == 3) local n = 0 assert(load(function() n = n + 1 "
                             "return n == 1 and 'return 5' or nil end)() == 5) "),
            "");
}

}  // namespace
}  // namespace hackle
