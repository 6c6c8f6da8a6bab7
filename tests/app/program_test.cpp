// SPDX-License-Identifier: MIT
// The program from outside: exit codes, what goes to stdout and stderr, files.
#include "app/program.hpp"

#include <chrono>
#include <thread>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "base/files.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
namespace fs = std::filesystem;

class ProgramTest : public testing::Test {
 protected:
  test::Ended run(const std::string& script, std::vector<std::string> words = {}) {
    write_text(folder_.path / "a.lua", script);
    words.insert(words.begin(), {"run", "a.lua"});
    return program_.run(words);
  }

  test::Folder folder_;
  test::Program program_{folder_};
};

const std::string film = test::scene + R"(
  s:movie { "a.mp4", every = 1*us, width = 320 }
  s:run(3*us)
)";

TEST_F(ProgramTest, ExitCodesTellWhatWentWrong) {
  EXPECT_EQ(run("print 'hello'").code, 0);
  EXPECT_EQ(run("", {"--nonsense"}).code, 2);
  EXPECT_EQ(run("", {"--set", "novalue"}).code, 2);
  EXPECT_EQ(run("", {"-j", "0"}).code, 2);
  EXPECT_EQ(run("error 'x'").code, 3);
  EXPECT_EQ(run("local = 5").code, 3);
  EXPECT_EQ(run("plate { width = -1 }").code, 4);
  EXPECT_EQ(program_.run({"run", "missing.lua"}).code, 5);
  EXPECT_EQ(run("os.exit(42)").code, 42);
}

TEST_F(ProgramTest, RunsATextFromTheCommandLine) {
  const auto ended = program_.run({"-e", "print(2*MPa, ...)", "--", "x"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.out, "2000000.0\tx\n");
  EXPECT_EQ(program_.run({"run", "-e", "error 'x'"}).code, 3);
  EXPECT_EQ(program_.run({"run", "-e", "print(1)", "a.lua"}).code, 2);
  EXPECT_EQ(program_.run({"check", "-e", "print(1)"}).code, 0);
  EXPECT_EQ(program_.run({"run"}).code, 2);
}

TEST_F(ProgramTest, RunsAScriptFromStdin) {
  program_.input = "local x = 3\nprint(x + 1)\n";
  EXPECT_EQ(program_.run({"-"}).out, "4\n");
  EXPECT_EQ(program_.run({"run", "-", "-q"}).out, "4\n");
  program_.input = "error 'x'";
  EXPECT_THAT(program_.run({"run", "-"}).err, HasSubstr("stdin:1: x"));
}

// Locals and simulations of the script are there at the prompt; files are complete at its end.
TEST_F(ProgramTest, GoesOnAtThePromptAfterAScript) {
  program_.input = "s.steps, load\ns:step(2)\ns.steps\n";
  const auto ended = run(test::scene +
                             "local load <const> = 7\ns:step(3)\n"
                             "s:movie { 'a.mp4', every = 1*us, width = 320 }",
                         {"-i"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.out, "3\n7\n5\n");
  EXPECT_TRUE(fs::exists(folder_.path / "out/a/a.mp4")) << ended.err;
}

TEST_F(ProgramTest, GoesOnAtThePromptAfterAnErrorToo) {
  program_.input = "x\n";
  const auto ended = run("local x = 5\nerror 'no'", {"-i"});
  EXPECT_EQ(ended.out, "5\n");
  EXPECT_EQ(ended.code, 3);
}

TEST_F(ProgramTest, ABareWordLeavesThePrompt) {
  for (const char* word : {"quit", "exit", "quit()", "exit()", "os.exit()"}) {
    program_.input = fmt::format("1\n{}\n2\n", word);
    const auto ended = program_.run({});
    EXPECT_EQ(ended.out, "1\n") << word;
    EXPECT_EQ(ended.code, 0);
  }
  program_.input = "exit(4)\n";
  EXPECT_EQ(program_.run({}).code, 4);
}

TEST_F(ProgramTest, ABlownUpRunIsAFailedRun) {
  const auto ended = run(R"(
    p = plate { width = 20*mm, height = 20*mm, material = "duran50" }
    p:traction { edge = "top", stress = {0, 12*MPa} }
    p:nofail { from = {0, 0}, to = {20*mm, 20*mm} }
    s = simulate(p, { spacing = 1*mm, step = 1*us, force_step = true })
    s:run(10e-3))");
  EXPECT_EQ(ended.code, 1) << ended.err;
}

TEST_F(ProgramTest, ErrorsGoToStderrWithFileAndLine) {
  const auto ended = run("\nplate { widht = 1 }");
  EXPECT_EQ(ended.out, "");
  EXPECT_THAT(ended.err, StartsWith("error: a.lua:2: plate: "));
  EXPECT_THAT(ended.err, HasSubstr("did you mean 'width'?"));
}

TEST_F(ProgramTest, JsonIsOneObjectWithEveryDocumentedKey) {
  const auto ended = run("print 'talk'\n io.write('more\\n')\n" + film, {"--json", "-q"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto json = nlohmann::json::parse(ended.out);
  for (const char* key : {"schema", "script", "nodes", "bonds", "steps", "time_s", "dt_s",
                          "dt_limit_s", "precision", "threads", "wall_s", "node_steps_per_s",
                          "energy_J_per_m", "damage", "peak_rss_bytes", "hash", "files"})
    EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_EQ(json["script"], "a.lua");
  EXPECT_EQ(json["files"], nlohmann::json::array({"out/a/a.mp4"}));
  EXPECT_THAT(ended.err, HasSubstr("talk\nmore\n"));
}

TEST_F(ProgramTest, AnErrorLeavesNoJson) {
  const auto ended = run("plate { }", {"--json"});
  EXPECT_EQ(ended.code, 4);
  EXPECT_EQ(ended.out, "");
  EXPECT_THAT(ended.err, HasSubstr("width is missing"));
}

TEST_F(ProgramTest, FilesGoToTheFolderOfTheScriptAndAreNamedAtTheEnd) {
  const auto ended = run(film);
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_TRUE(test::is_whole_mp4(folder_.path / "out/a/a.mp4"));
  EXPECT_THAT(ended.err, HasSubstr("wrote out/a/a.mp4"));
}

TEST_F(ProgramTest, AnotherFolderCanBeChosenAndQuietSaysNothing) {
  const auto ended = run(film, {"-o", "here and there", "-q"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_EQ(ended.err, "");
  EXPECT_TRUE(test::is_whole_mp4(folder_.path / "here and there/a.mp4"));
  EXPECT_FALSE(fs::exists(folder_.path / "out"));
}

TEST_F(ProgramTest, ARefusedScriptWritesNothing) {
  EXPECT_EQ(run(test::scene + "s:movie { 'a.mp4', every = 1*us, widht = 5 }").code, 4);
  EXPECT_FALSE(fs::exists(folder_.path / "out"));
}

TEST_F(ProgramTest, AFolderThatCannotBeWrittenIsRefused) {
  write_text(folder_.path / "file", "");
  const auto ended = run(film, {"-o", "file/out"});
  EXPECT_EQ(ended.code, 5);
  EXPECT_THAT(ended.err, HasSubstr("'file/out': Not a directory (choose another folder with -o)"));
}

TEST_F(ProgramTest, OptionsOfTheScriptCanBeSetTwice) {
  const auto ended = run("local o = options { a = 1*mm, b = 'x' }\nprint(o.a, o.b)",
                         {"--set", "a=2*mm", "--set", "b=y = z"});
  EXPECT_EQ(ended.out, "0.002\ty = z\n") << ended.err;
}

TEST_F(ProgramTest, WhatFollowsTheDashesIsForTheScript) {
  EXPECT_EQ(run("print(#arg, arg[1], ...)", {"--", "-o", "x"}).out, "2\t-o\t-o\tx\n");
}

TEST_F(ProgramTest, AScriptWithASpaceInItsPathIsRunWithoutTheWordRun) {
  fs::create_directories(folder_.path / "my scenes");
  write_text(folder_.path / "my scenes/first one.lua", film);
  EXPECT_EQ(program_.run({"my scenes/first one.lua"}).code, 0);
  EXPECT_TRUE(fs::exists(folder_.path / "out/first one/a.mp4"));
}

TEST_F(ProgramTest, TheHashDoesNotDependOnThreads) {
  const std::string script = test::scene + "s:run(20*us)";
  const auto hash = [&](const char* threads) {
    return nlohmann::json::parse(run(script, {"--json", "-j", threads}).out)["hash"];
  };
  EXPECT_EQ(hash("1"), hash("3"));
}

TEST_F(ProgramTest, CtrlCCompletesTheMovie) {
  // The file of the movie is opened with the first frame, which the run requests before its first
  // step.
  program_.at_first_word = [this](pid_t process) {
    for (int tries = 0; tries < 600 && !fs::exists(folder_.path / "out/a/.a.partial.mp4"); ++tries)
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    kill(process, SIGINT);
  };
  const auto ended = run(test::scene + R"(
    s:movie { "a.mp4", every = 1*us, width = 320 }
    print "go" io.stdout:flush()
    s:run(1)
  )");
  EXPECT_EQ(ended.code, 130) << ended.err;
  EXPECT_TRUE(test::is_whole_mp4(folder_.path / "out/a/a.mp4"));
  EXPECT_FALSE(fs::exists(folder_.path / "out/a/.a.partial.mp4"));
  EXPECT_THAT(ended.err, HasSubstr("error: a.lua:10: interrupted after step"));
}

TEST_F(ProgramTest, CtrlCStopsALoopThatCatchesEverything) {
  program_.at_first_word = [](pid_t process) { kill(process, SIGINT); };
  EXPECT_EQ(run("print 'go' io.stdout:flush() while true do pcall(error) end").code, 130);
}

TEST_F(ProgramTest, AnUnknownCommandGetsTheNearest) {
  const auto ended = program_.run({"inof"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("there is no command or script 'inof' (did you mean 'info'?)"));
}

TEST_F(ProgramTest, HelpIsEverywhere) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"-h"}, {"run", "-h"}, {"bench", "-h"}, {"info", "--help"}}) {
    const auto ended = program_.run(words);
    EXPECT_EQ(ended.code, 0);
    EXPECT_THAT(ended.out, HasSubstr("Usage: hackle"));
  }
}

TEST_F(ProgramTest, VersionNamesCompilerAndLibraries) {
  const auto ended = program_.run({"--version"});
  EXPECT_EQ(ended.code, 0);
  for (const char* part : {"hackle ", "git ", "Lua 5.4", "HDF5 1.", "libavcodec", "Cairo 1."})
    EXPECT_THAT(ended.out, HasSubstr(part));
}

TEST_F(ProgramTest, InfoDescribesTheMachine) {
  const auto json = nlohmann::json::parse(program_.run({"info", "--json"}).out);
  for (const char* key : {"schema", "version", "git", "compiler", "libraries", "gl_renderer",
                          "processor", "instruction_set", "cores", "memory_bytes"})
    EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_THAT(program_.run({"info"}).out, HasSubstr("OpenGL"));
}

TEST_F(ProgramTest, LinesOfStdinAreAPrompt) {
  program_.input = "x = 20\nfor i = 1, 2 do\nx = x + 1\nend\nx\nplate { }\n1\n";
  const auto ended = program_.run({});
  EXPECT_EQ(ended.out, "22\n1\n");
  EXPECT_THAT(ended.err, StartsWith("error: plate: width is missing"));
  EXPECT_EQ(ended.code, 4);
}

TEST_F(ProgramTest, AScriptIsAStrangerUnlessItIsTrusted) {
  const std::string script = "print(io.popen('echo from outside'):read('a'))";
  EXPECT_EQ(run(script).code, 3);
  const auto trusted = run(script, {"--trust"});
  EXPECT_EQ(trusted.code, 0) << trusted.err;
  EXPECT_THAT(trusted.out, HasSubstr("from outside"));
  EXPECT_EQ(run("io.open('/etc/passwd')").code, 4);
  EXPECT_EQ(run("io.open('/etc/passwd'):read('a')", {"--trust"}).code, 0);
}

TEST_F(ProgramTest, ThePromptHasTheSameRules) {
  program_.input = "print(os.getenv and 'free' or 'fenced')\n";
  EXPECT_THAT(program_.run({}).out, HasSubstr("fenced"));
  EXPECT_THAT(program_.run({"--trust"}).out, HasSubstr("free"));
  program_.input = "io.open('/etc/passwd')\n";
  EXPECT_EQ(program_.run({}).code, 4);
  program_.input = "('x'):rep(2e6)\n";
  EXPECT_EQ(program_.run({"--lua-memory", "1"}).code, 3);
}

TEST_F(ProgramTest, LuaMemoryAndOutputHaveLimits) {
  const auto greedy = run("local t = {} for i = 1, 1e9 do t[i] = i end", {"--lua-memory", "4"});
  EXPECT_EQ(greedy.code, 3);
  EXPECT_THAT(greedy.err, HasSubstr("exceed 4 MB (--lua-memory allows more)"));
  const auto wordy = run(film, {"--output-limit", "0.001"});
  EXPECT_EQ(wordy.code, 0) << wordy.err;
  const auto more = run(test::scene + "s:movie { 'a.mp4', every = 1*us } s:run(20)");
  EXPECT_EQ(more.code, 4);
  EXPECT_THAT(more.err, HasSubstr("the limit is 20 GB"));
  EXPECT_EQ(run("", {"--lua-memory", "0"}).code, 2);
  EXPECT_EQ(run("", {"--output-limit", "-1"}).code, 2);
}

// Lua calls no hook during a pattern search; the second Ctrl-C ends the program.
TEST_F(ProgramTest, APatternWithoutEndIsLeftByTheSecondInterrupt) {
  program_.at_first_word = [](pid_t child) {
    for (int k = 0; k < 2; ++k) {
      std::this_thread::sleep_for(std::chrono::milliseconds(300));
      kill(child, SIGINT);
    }
  };
  const auto ended =
      run("print 'looking' io.stdout:flush()\n"
          "string.find(('a'):rep(5000), ('a-'):rep(30) .. 'b')");
  EXPECT_EQ(ended.code, 128 + SIGINT);
  EXPECT_THAT(ended.err, HasSubstr("again to abort"));
}

}  // namespace
}  // namespace hackle
