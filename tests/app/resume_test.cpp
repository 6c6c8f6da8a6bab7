// SPDX-License-Identifier: MIT
// A script that was stopped goes on: by the same command, by hackle resume, and elsewhere.
#include <gmock/gmock.h>

#include "app/program.hpp"
#include "base/files.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string counted = test::scene + R"(
s:run(10*us)
s:log { "a.csv", every = 50*us }
s:on { "every", every = 2*us, call = function(t) print(t, s.energy.kinetic) io.stdout:flush() end }
s:run(400*us)
print(s.hash, arg[1])
)";

class Resumed : public testing::Test {
 protected:
  Resumed() {
    write_text(folder_.path / "a.lua", counted);
    whole_ = run({"run", "a.lua", "-o", "whole", "--", "x"}).out;
    EXPECT_THAT(whole_, HasSubstr("\tx\n"));
    test::Program stopped(folder_);
    stopped.at_first_word = [](pid_t process) { kill(process, SIGINT); };
    const test::Ended first = stopped.run({"run", "a.lua", "--", "x"});
    EXPECT_EQ(first.code, 130) << first.err;
    EXPECT_THAT(first.err, HasSubstr("hackle resume"));
    EXPECT_LT(first.out.size(), whole_.size());
  }

  test::Ended run(const std::vector<std::string>& words) const {
    return test::Program(folder_).run(words);
  }

  const test::Folder folder_;
  std::string whole_;
};

TEST_F(Resumed, TheSameCommandGoesOn) {
  const test::Ended on = run({"run", "a.lua", "--", "x"});
  EXPECT_EQ(on.out, whole_);
  EXPECT_THAT(on.err, AllOf(HasSubstr("going on with the run that stopped"),
                            HasSubstr("the script is where it stopped")));
}

TEST_F(Resumed, InfoTellsHow) {
  EXPECT_THAT(run({"info", "out/a/a.auto.ckpt"}).out, HasSubstr("hackle resume out/a/a.auto.ckpt"));
}

TEST_F(Resumed, OtherArgumentsAreAnotherRun) {
  const test::Ended other = run({"run", "a.lua", "--", "y"});
  EXPECT_EQ(other.code, 0);
  EXPECT_THAT(other.err, Not(HasSubstr("going on")));
  EXPECT_THAT(run({"run", "a.lua", "--", "x"}).err, HasSubstr("going on"));
}

TEST_F(Resumed, FreshBeginsAnew) {
  const test::Ended anew = run({"run", "a.lua", "--fresh", "--", "x"});
  EXPECT_EQ(anew.out, whole_);
  EXPECT_THAT(anew.err, Not(HasSubstr("going on")));
  EXPECT_TRUE(fs::exists(folder_.path / "out/a/a.former.ckpt"));
}

TEST_F(Resumed, ByTheNameOfItsFolder) {
  const test::Ended on = run({"resume", "out/a", "-j", "2"});
  EXPECT_EQ(on.out, whole_);
  EXPECT_EQ(on.code, 0) << on.err;
}

TEST_F(Resumed, ByTheNameOfItsCheckpointAndAsJson) {
  const test::Ended on = run({"resume", "out/a/a.auto.ckpt", "--json"});
  EXPECT_EQ(on.code, 0) << on.err;
  EXPECT_THAT(on.out, AllOf(HasSubstr("\"schema\":1"), HasSubstr("\"script\":\"a.lua\"")));
}

// The folder is all that is needed.
TEST_F(Resumed, Elsewhere) {
  fs::create_directory(folder_.path / "far");
  fs::rename(folder_.path / "out/a", folder_.path / "far/moved");
  fs::remove(folder_.path / "a.lua");
  EXPECT_EQ(run({"resume", "far/moved", "-q"}).out, whole_);
}

// As if killed between the end of the run and the removal of what only its continuation needed.
TEST_F(Resumed, NotWhatHasFinished) {
  const fs::path kept = folder_.path / "out/a/a.auto.ckpt";
  fs::copy_file(kept, folder_.path / "left.ckpt");
  EXPECT_EQ(run({"run", "a.lua", "--", "x"}).code, 0);
  EXPECT_FALSE(fs::exists(kept));
  fs::copy_file(folder_.path / "left.ckpt", kept);
  EXPECT_THAT(run({"resume", "out/a"}).err, HasSubstr("no run that was stopped"));
  const test::Ended anew = run({"run", "a.lua", "--", "x"});
  EXPECT_THAT(anew.err, AllOf(Not(HasSubstr("going on")), HasSubstr("finished run")));
  EXPECT_EQ(anew.out, whole_);
  EXPECT_FALSE(fs::exists(kept));
}

TEST_F(Resumed, NotARunWithOtherInputsThatIsOverwritten) {
  const std::vector<std::string> other{"run", "a.lua", "--force", "--", "y"};
  fs::copy_file(folder_.path / "out/a/a.auto.ckpt", folder_.path / "left.ckpt");
  EXPECT_EQ(run(other).code, 0);
  fs::copy_file(folder_.path / "left.ckpt", folder_.path / "out/a/a.auto.ckpt",
                fs::copy_options::overwrite_existing);
  std::string mark = read_text(folder_.path / "out/a/a.inputs.json");
  const std::size_t finished = mark.find("true");
  ASSERT_NE(finished, std::string::npos) << mark;
  write_text(folder_.path / "out/a/a.inputs.json", mark.replace(finished, 4, "false"));
  EXPECT_THAT(run(other).err, Not(HasSubstr("going on")));
}

// As if killed while the checkpoint of another simulation was replaced.
TEST_F(Resumed, FromTheCheckpointBefore) {
  write_text(folder_.path / "b.lua", test::scene + R"(
t = s:fork()
s:run(2*us)
t:on { "every", every = 1*us, call = function(t) print(t) io.stdout:flush() end }
t:run(400*us)
s:run(1*us)
print(s.hash, t.hash))");
  const std::string whole = run({"run", "b.lua", "-o", "whole"}).out;
  test::Program stopped(folder_);
  stopped.at_first_word = [](pid_t process) { kill(process, SIGINT); };
  ASSERT_EQ(stopped.run({"run", "b.lua"}).code, 130);
  fs::rename(folder_.path / "out/b/b.auto.ckpt", folder_.path / "out/b/b.auto_prev.ckpt");
  EXPECT_EQ(run({"run", "b.lua"}).out, whole);
}

TEST_F(Resumed, WhereNothingWasStoppedIsAnError) {
  EXPECT_EQ(run({"run", "a.lua", "--", "x"}).code, 0);
  const test::Ended none = run({"resume", "out/a"});
  EXPECT_EQ(none.code, 5);
  EXPECT_THAT(none.err, HasSubstr("has no run that was stopped"));
  EXPECT_EQ(run({"resume", "a.lua"}).code, 5);
  EXPECT_EQ(run({"resume", "nowhere"}).code, 5);
  EXPECT_EQ(run({"resume"}).code, 2);
}

}  // namespace
}  // namespace hackle
