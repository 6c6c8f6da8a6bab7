// SPDX-License-Identifier: MIT
// Files and folders that are missing, in the way, full or not what their names say, and limits of
// the process. Root may write everywhere, so an unwritable path is a file in place of a folder, or
// a folder of the kernel.
#include <fstream>
#include <memory>

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "base/files.hpp"
#include "faults/faulty_program.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using test::Ended;
using testing::HasSubstr;

class Disk : public testing::Test {
 protected:
  Ended run(const std::vector<std::string>& words, const test::Fault& fault = {}) const {
    return program_.run(words, fault);
  }
  Ended run_script(const std::string& script, const test::Fault& fault = {}) const {
    write("a.lua", script);
    return run({"run", "a.lua"}, fault);
  }
  void write(const fs::path& name, const std::string& text) const {
    fs::create_directories((folder_.path / name).parent_path());
    write_text(folder_.path / name, text);
  }

  test::Folder folder_;
  test::FaultyProgram program_{folder_};
};

const std::string film = test::scene +
                         "s:movie { 'a.mp4', every = 1*us, width = 320 }\n"
                         "s:run(2*us)";
const std::string record = test::scene + "s:record { 'a.h5', every = 1*us } s:run(2*us)";
const std::string frame = test::scene + "s:frame { 'a.png', width = 320 }";
const std::string note = "local f = assert(io.open('a.txt', 'w')) f:write('x') f:close()";
const std::string typed = test::scene + "s:script 'a.lua'";
const std::string sheet = test::scene +
                          "s:frame { 'b.png', width = 320 }\n"
                          "contact_sheet { 'a.png', pictures = { 'b.png' } }";

TEST_F(Disk, AFolderThatCannotBeIsAnErrorOfFiles) {
  write("file", "");
  for (const std::string& script : {film, record, frame, typed, sheet, note})
    for (const char* folder : {"file", "file/below", "/proc/hackle", "/dev/null/x"}) {
      write("a.lua", script);
      const Ended ended = run({"run", "a.lua", "-o", folder});
      EXPECT_EQ(ended.code, 5) << folder << "\n" << script << "\n" << ended.err;
      EXPECT_THAT(ended.err, HasSubstr(folder));
    }
}

TEST_F(Disk, AFolderWhereAFileShouldBeIsSaidBeforeARun) {
  for (const auto& [script, name] :
       {std::pair{film, "a.mp4"}, {record, "a.h5"}, {frame, "a.png"}, {typed, "a.lua"}}) {
    fs::create_directories(folder_.path / "out/a" / name);
    const Ended ended = run_script(script);
    EXPECT_EQ(ended.code, 5) << name << ended.err;
    EXPECT_THAT(ended.err, HasSubstr(name));
    fs::remove_all(folder_.path / "out");
  }
}

TEST_F(Disk, AFullDiskLeavesNoFileThatIsNotWhole) {
  const std::string large = test::scene + "s:run(1*us)\n";
  for (const auto& [script, name] :
       {std::pair{large + "s:movie { 'a.mp4', every = 1*us } s:run(30*us)", "a.mp4"},
        {large + "s:frame { 'a.png' }", "a.png"},
        {large + "local f = io.open('a.txt', 'w') for k = 1, 1e4 do assert(f:write('some text')) "
                 "end assert(f:close())",
         "no.txt"}})
    for (const rlim_t max : {0, 512, 4096}) {
      const Ended ended =
          run_script(script, {.limits = {{RLIMIT_FSIZE, max}}, .ignored = {SIGXFSZ}});
      // A script's own assert() is an error of the script.
      EXPECT_THAT(ended.code, testing::AnyOf(3, 5)) << name << max << ended.err;
      EXPECT_FALSE(fs::exists(folder_.path / "out/a" / name)) << name << max;
      fs::remove_all(folder_.path / "out");
    }
}

// An unwritable file stays as it is; the program still ends with its code.
TEST_F(Disk, ARecordOnAFullDiskIsAnErrorOfFiles) {
  for (const rlim_t max : {0, 512, 4096, 65536}) {
    const Ended ended = run_script(test::scene + "s:record { 'a.h5', every = 1*us } s:run(30*us)",
                                   {.limits = {{RLIMIT_FSIZE, max}}});
    EXPECT_EQ(ended.code, 5) << max << ended.err;
    // If no file may grow at all, neither may the file behind stderr.
    if (max > 0) {
      EXPECT_THAT(ended.err, HasSubstr("a.h5"));
    }
    fs::remove_all(folder_.path / "out");
  }
}

// The program goes on renaming its files below the folder: what is seen may be gone when it is
// removed.
void remove_whole(const fs::path& folder) {
  std::error_code failed;
  for (int k = 0; k < 1000 && fs::exists(folder, failed); ++k) fs::remove_all(folder, failed);
}

TEST_F(Disk, AFolderThatGoesAwayIsOneClearError) {
  for (const std::string& start :
       {test::scene + "s:movie { 'a.mp4', every = 1*us, width = 320 } s:run(1*us)",
        test::scene + "s:record { 'a.h5', every = 1*us } s:run(1*us)"}) {
    write("a.lua", start +
                       "\nprint 'go' io.stdout:flush()\n"
                       "while not io.open('gone', 'r') do s:step(1) end s:close()");
    const Ended ended = run({"run", "a.lua"}, {.meanwhile = [&](pid_t) {
                              program_.wait_for_go();
                              remove_whole(folder_.path / "out");
                              write("gone", "");
                            }});
    // A movie not begun by then is made in a new folder.
    EXPECT_TRUE(ended.code == 5 || test::is_whole_mp4(folder_.path / "out/a/a.mp4")) << ended.err;
    fs::remove(folder_.path / "gone");
  }
}

struct Source {
  const char* what;
  std::string text;
  int code;
};

TEST_F(Disk, ScriptsOfAnyKindEndWithTheirCode) {
  const std::vector<Source> sources{
      {"empty", "", 0},
      {"blank", " \n\t\n", 0},
      {"a mark of byte order", "\xEF\xBB\xBFprint 'x'", 0},
      {"a mark and a shebang", "\xEF\xBB\xBF#!/usr/bin/hackle\nprint 'x'", 0},
      {"a shebang without an end", "#!", 0},
      {"lines of Windows", "local x = 1\r\nassert(x == 1)\r\n", 0},
      {"lines of old Macs", "local x = 1\rassert(x == 1)\r", 0},
      {"a zero byte", std::string("local x = 1\0print(x)", 20), 3},
      {"byte code", std::string("\x1bLua\x54\x00\x19\x93\r\n\x1a\n", 12), 3},
      {"a picture", "\x89PNG\r\n\x1a\n", 3},
      {"UTF-16", std::string("\xFF\xFEp\0r\0", 6), 3},
      {"half a string", "print 'x", 3},
      {"half a comment", "--[[ x", 3},
      {"half a block", "for i = 1, 2 do", 3},
      {"deep brackets", std::string(1000, '('), 3},
      {"deep tables", "local x = " + std::string(1000, '{'), 3},
      {"many locals",
       [] {
         std::string text;
         for (int k = 0; k < 300; ++k) text += "local v" + std::to_string(k) + " = 1\n";
         return text;
       }(),
       3},
      {"a long line", "local x = '" + std::string(1 << 20, 'x') + "'", 0},
      {"an umlaut outside of a string",
       "pr\xc3\xbc"
       "fe()",
       3}};
  for (const Source& source : sources) {
    const Ended ended = run_script(source.text);
    EXPECT_EQ(ended.code, source.code) << source.what << ended.err;
  }
  EXPECT_GE(sources.size(), 19U);
}

TEST_F(Disk, AScriptThatCannotBeReadIsSaid) {
  fs::create_directory(folder_.path / "folder.lua");
  fs::create_symlink("nowhere.lua", folder_.path / "dangling.lua");
  fs::create_symlink("ring.lua", folder_.path / "ring.lua");
  for (const char* name : {"missing.lua", "folder.lua", "dangling.lua", "ring.lua", "a.lua/b.lua",
                           "/proc/self/mem", ""})
    for (const char* command : {"run", "check"}) {
      const Ended ended = run({command, name});
      EXPECT_THAT(ended.code, testing::AnyOf(5, name[0] == '\0' ? 2 : 5)) << name << ended.err;
      EXPECT_FALSE(ended.err.empty()) << name;
    }
}

TEST_F(Disk, AScriptFromAPipeIsRun) {
  ASSERT_EQ(mkfifo((folder_.path / "pipe.lua").c_str(), 0600), 0);
  const Ended ended = run({"run", "pipe.lua"}, {.meanwhile = [&](pid_t) {
                            std::ofstream(folder_.path / "pipe.lua") << "print 'from a pipe'";
                          }});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.out, "from a pipe\n");
}

TEST_F(Disk, MemoryThatIsDeniedIsAnErrorOfTheScriptOrTheRun) {
  constexpr rlim_t megabyte = 1U << 20U;  // of address space: the program itself takes 300
  for (const std::string& script :
       {std::string("local t = {} for k = 1, 1e9 do t[k] = k end"),
        std::string("local x = ('x'):rep(1e9)"),
        std::string("local t = {} while true do t[#t + 1] = ('x'):rep(1e6 + #t) end"),
        test::scene + "t = {} while true do t[#t + 1] = simulate(p, { spacing = 0.2*mm }) end",
        test::scene +
            "s = simulate(p, { spacing = 0.2*mm }) t = {} while true do t[#t + 1] = s:fork() end",
        test::scene + "simulate(p, { spacing = 0.01*mm })"}) {
    const Ended ended = run_script(script, {.limits = {{RLIMIT_AS, 700 * megabyte}}});
    EXPECT_THAT(ended.code, testing::AnyOf(1, 3, 4)) << script << ended.err;
    EXPECT_THAT(ended.err, HasSubstr("error: ")) << script;
  }
}

TEST_F(Disk, FewOpenFilesAreAnErrorOfFiles) {
  const std::string many =
      "local t = {} for k = 1, 100 do t[k] = assert(io.open(k .. '.txt', 'w')) "
      "end";
  EXPECT_EQ(run_script(many, {.limits = {{RLIMIT_NOFILE, 32}}}).code, 3);
  for (const std::string& script : {film, record}) {
    const Ended ended = run_script(script, {.limits = {{RLIMIT_NOFILE, 4}}});
    EXPECT_THAT(ended.code, testing::AnyOf(0, 1, 5)) << ended.err;
  }
}

TEST_F(Disk, ACheckWritesNothing) {
  const Ended ended = [&] {
    write("a.lua", test::scene + R"(
      s:movie { "a.mp4", every = 1*us } s:record { "a.h5", every = 1*us } s:frame { "a.png" }
      s:run(2*us) show(s) s:script "typed.lua"
      local f = io.open("new/a.txt", "w") f:write("x") f:close()
      io.output("b.txt") io.write("x") io.close() io.output(io.stdout)
      io.open("c.txt", "a"):close() io.open("d.txt", "w+"):close()
      contact_sheet { "e.png", pictures = { "a.png" } }
      s:fork():frame { "f.png" } s:quasistatic { duration = 1*us, increments = 2 } s:relax() s:close())");
    return run({"check", "a.lua"});
  }();
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_FALSE(fs::exists(folder_.path / "out"));
  EXPECT_EQ(run({"check", "a.lua", "-o", "here"}).code, 0);
  EXPECT_FALSE(fs::exists(folder_.path / "here"));
  EXPECT_EQ(run({"run", "a.lua", "--help"}).code, 0);
  EXPECT_FALSE(fs::exists(folder_.path / "out"));
}

TEST_F(Disk, ACheckOfATrustedScriptChangesNothing) {
  write("precious.txt", "gold");
  for (const std::string act :
       {"os.remove 'precious.txt'", "os.rename('precious.txt', 'b.txt')",
        "pcall(os.execute, 'touch b.txt')", "pcall(io.popen, 'touch b.txt')",
        "io.open('precious.txt', 'w'):close()", "io.output(arg[0]) io.write 'x'"}) {
    write("a.lua", act);
    const Ended ended = run({"check", "a.lua", "--trust"});
    EXPECT_EQ(ended.code, 0) << act << ended.err;
    EXPECT_EQ(test::Program::text_of(folder_.path / "precious.txt"), "gold") << act;
    EXPECT_EQ(test::Program::text_of(folder_.path / "a.lua"), act);
    EXPECT_FALSE(fs::exists(folder_.path / "b.txt")) << act;
  }
}

TEST_F(Disk, RunFilesThatAreNoneAreErrorsOfFiles) {
  write("empty.h5", "");
  write("text.h5", "no run file");
  write("short.h5", "\x89HDF\r\n\x1a\n");
  fs::create_directory(folder_.path / "folder.h5");
  for (const char* name : {"missing.h5", "empty.h5", "text.h5", "short.h5", "folder.h5"}) {
    const Ended ended = run({"render", name});
    EXPECT_EQ(ended.code, 5) << name << ended.err;
    EXPECT_THAT(ended.err, HasSubstr(name));
  }
}

}  // namespace
}  // namespace hackle
