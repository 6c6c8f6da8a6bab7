// SPDX-License-Identifier: MIT
// A run with a movie, a run file and checkpoints is killed at random moments and begun again with
// the same command, until it ends: all that it leaves is that of a run which was never stopped.
// HACKLE_KILLS is the number of kills (5).
#include <chrono>
#include <cstdlib>
#include <random>
#include <thread>

#include <gmock/gmock.h>

#include "base/files.hpp"
#include "faults/faulty_program.hpp"
#include "measure/scalar.hpp"
#include "store/recording.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using test::Ended;
using testing::HasSubstr;

int kills() {
  const char* text = std::getenv("HACKLE_KILLS");  // NOLINT(concurrency-mt-unsafe)
  return text != nullptr ? std::atoi(text) : 5;
}

// About a second on two cores.
const std::string script = R"(
local p = plate { width = 60*mm, height = 40*mm, material = "duran50" }
p:crack { from = {0, 20*mm}, to = {25*mm, 20*mm} }
p:traction { edge = "top", stress = {0, 24*MPa} }
p:traction { edge = "bottom", stress = {0, -24*MPa} }
local s = simulate(p, { spacing = 0.5*mm })
s:movie { "a.mp4", every = 0.5*us, width = 320 }
s:record { "a.h5", every = 1*us }
s:log { "a.csv", "time", "tip.x", "tip.speed", "broken", { strain = function(s) return s.energy.strain end } }
s:on { "every", every = 2*us, call = function(t) print(t, s.energy.kinetic) end }
s:on { "break", call = function(t)
  print("breaks", t) s:damping { rate = 1e3 } end }
s:run(9.7*us)
print(s.hash, s.damage.broken_bonds)
local t = s:fork()
t:record { "t.h5", every = 2*us }
t:run(4*us)
s:run(9*us)
print(s.hash, t.hash, s.energy.external, s.energy.broken)
)";

class Kills : public testing::Test {
 protected:
  Kills() { write_text(folder_.path / "a.lua", script); }
  fs::path out() const { return folder_.path / "out/a"; }

  Ended run(const std::vector<std::string>& words, std::optional<int> microseconds = {}) const {
    test::Fault fault;
    if (microseconds)
      fault.meanwhile = [=](pid_t process) {
        std::this_thread::sleep_for(std::chrono::microseconds(*microseconds));
        kill(process, SIGKILL);
      };
    return program_.run(words, fault);
  }

  test::Folder folder_;
  test::FaultyProgram program_{folder_};
};

void expect_same_records(const fs::path& one, const fs::path& other) {
  Recording first(one), second(other);
  ASSERT_EQ(first.times(), second.times());
  for (std::size_t k = 0; k < first.times().size(); ++k) {
    first.go_to(k);
    second.go_to(k);
    for (const char* name : {"damage", "speed", "stress_1"})
      EXPECT_EQ(scalar_of(name).values(first.view()), scalar_of(name).values(second.view()))
          << name << k;
  }
}

TEST_F(Kills, LeaveNoTrace) {
  const std::vector<std::string> words{"run", "a.lua", "--checkpoint", "0.02s", "-q"};
  const auto begin = std::chrono::steady_clock::now();
  const Ended whole = run(words);
  const auto length = std::chrono::duration_cast<std::chrono::microseconds>(
      std::chrono::steady_clock::now() - begin);
  ASSERT_EQ(whole.code, 0) << whole.err;
  fs::rename(out(), folder_.path / "whole");
  std::mt19937 random(7);
  int done = 0;
  for (int left = kills(); left > 0;) {
    fs::remove_all(out());
    Ended ended;
    do {
      const bool is_spent = --left < 0;
      std::uniform_int_distribution<int> moment(1000, static_cast<int>(length.count()));
      ended = run(words, is_spent ? std::optional<int>() : moment(random));
    } while (ended.code == 128 + SIGKILL);
    ASSERT_EQ(ended.code, 0) << ended.err;
    ++done;
    EXPECT_EQ(ended.out, whole.out);
    EXPECT_EQ(read_text(out() / "a.mp4"), read_text(folder_.path / "whole/a.mp4"));
    EXPECT_EQ(read_text(out() / "a.csv"), read_text(folder_.path / "whole/a.csv"));
    expect_same_records(out() / "a.h5", folder_.path / "whole/a.h5");
    expect_same_records(out() / "t.h5", folder_.path / "whole/t.h5");
    for (const auto& entry : fs::directory_iterator(out())) {
      const std::string name = entry.path().filename().string();
      // Of a run that was killed before its first checkpoint, the remains are kept.
      EXPECT_TRUE(name.find("cut_off") != std::string::npos ||
                  fs::exists(folder_.path / "whole" / name))
          << name << " is left";
    }
  }
  EXPECT_GT(done, 0);
}

}  // namespace
}  // namespace hackle
