// SPDX-License-Identifier: MIT
// Scripts that try to escape. Around the folders of a script lie files that it may neither read nor
// change, and links to them.
#include "console/lua/sandbox.hpp"

#include <algorithm>
#include <fstream>
#include <map>

#include <gmock/gmock.h>

#include "base/files.hpp"
#include "console/scripts.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

constexpr const char* secret = "return 'hidden treasure'";

// scripts/ is the folder of the script and out/ its output folder; everything else is out of
// bounds.
class Jail : public testing::Test {
 protected:
  Jail() {
    for (const char* folder : {"scripts", "out", "outside"}) fs::create_directory(root_ / folder);
    write_text(root_ / "outside/secret.lua", secret);
    write_text(root_ / "scripts/part.lua", "return 42");
    for (const char* folder : {"scripts", "out"}) {
      fs::create_directory_symlink("../outside", root_ / folder / "away");
      fs::create_symlink("../outside/secret.lua", root_ / folder / "link.lua");
      fs::create_symlink("../outside/new", root_ / folder / "dangling");
      fs::create_symlink("dangling", root_ / folder / "twice");
      fs::create_symlink("ring", root_ / folder / "ring");
    }
    // Links placed where Hackle writes temporarily for a.mp4, a.png and a.h5.
    for (const char* name : {".a.partial.mp4", ".a.partial.png", "a.xdmf"})
      fs::create_symlink("../outside/new", root_ / "out" / name);
  }

  ConsoleSettings settings(bool trust = false) const {
    return trust ? test::trusted(root_ / "out") : test::quiet(root_ / "out");
  }

  // Returns the message of running the script.
  std::string said(const std::string& script, bool trust = false) const {
    write_text(root_ / "scripts/main.lua", "local root = '" + root_.string() + "'\n" + script);
    try {
      Console console(settings(trust));
      console.run_file(root_ / "scripts/main.lua");
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

  // Runs Lua code that must fail, or return nothing, and must not reveal the secret.
  void expect_held(const std::string& attempt) const {
    const std::string script = "local ok, value = pcall(function() " + attempt +
                               " end)\n"
                               "assert(not (ok and value), 'GOT OUT')\nerror(value or 'held')";
    EXPECT_THAT(said(script), testing::AllOf(Not(HasSubstr("GOT OUT")), Not(HasSubstr("treasure")),
                                             Not(HasSubstr("root:x")), Not(testing::IsEmpty())))
        << attempt;
    EXPECT_EQ(read_text(root_ / "outside/secret.lua"), secret) << attempt;
    const fs::directory_iterator outside(root_ / "outside");
    EXPECT_EQ(std::distance(begin(outside), end(outside)), 1) << attempt;
  }

  test::Folder folder_;
  fs::path root_ = folder_.path;
};

// Paths that lead out, as Lua expressions.
const std::vector<std::string> ways_out{"'../outside/secret.lua'",
                                        "'nowhere/../../outside/secret.lua'",
                                        "root .. '/outside/secret.lua'",
                                        "root .. '/out/../outside/secret.lua'",
                                        "root .. '/scripts/away/secret.lua'",
                                        "root .. '/out/away/secret.lua'",
                                        "'away/secret.lua'",
                                        "'away/../outside/secret.lua'",
                                        "'link.lua'",
                                        "'ring'",
                                        "root .. '/out/ring'",
                                        "'part.lua\\0/../../outside/secret.lua'",
                                        "''",
                                        "'/etc/passwd'",
                                        "'/proc/self/environ'",
                                        "'/proc/self/root/etc/passwd'",
                                        "'/proc/self/fd/0'",
                                        "'/dev/stdin'",
                                        "'/dev/zero'"};

TEST_F(Jail, NoFileOutsideIsRead) {
  for (const std::string& path : ways_out)
    for (const std::string reading :
         {"return io.open(%):read('a')", "return io.open(%, 'rb'):read('a')",
          "return io.lines(%)()", "for line in io.lines(%) do return line end",
          "io.input(%) return io.read('a')", "return dofile(%)", "return loadfile(%)",
          "return loadfile(%, 'bt', {})", "return loadfile(%)()",
          "package.path = % return require 'x'", "return package.searchpath('x', %)",
          "p = plate { width = 1, height = 1, material = 'duran50' } return p:mask { % }",
          "contact_sheet { 'b.png', pictures = { % } } return true"}) {
      std::string attempt = reading;
      attempt.replace(attempt.find('%'), 1, path);
      expect_held(attempt);
    }
}

TEST_F(Jail, NoFileOutsideIsWritten) {
  std::vector<std::string> paths = ways_out;
  for (const char* path : {"'dangling'", "'twice'", "'away/new'", "'../new'", "'../scripts/new'",
                           "root .. '/scripts/main.lua'", "'x/../../outside/new'"})
    paths.emplace_back(path);
  for (const std::string& path : paths)
    for (const std::string writing :
         {"return io.open(%, 'w')", "return io.open(%, 'a')", "return io.open(%, 'r+')",
          "return io.open(%, 'w+b')", "io.output(%) io.write('x') return true",
          "s:frame { % } return true", "s:movie { %, every = 1*us } s:run(1*us) s:close() return 1",
          "s:record { %, every = 1*us } s:run(1*us) s:close() return true",
          "contact_sheet { %, pictures = { 'b.png' } } return true"}) {
      std::string attempt = test::scene + writing;
      attempt.replace(attempt.find('%'), 1, path);
      expect_held(attempt);
    }
}

TEST_F(Jail, NamesOnTheWayToAFileAreLookedAt) {
  expect_held(test::scene + "s:frame { 'a.png' } return true");
  expect_held(test::scene + "s:movie { 'a.mp4', every = 1*us } s:run(1*us) s:close() return true");
  expect_held(test::scene + "s:record { 'a.h5', every = 1*us } s:run(1*us) s:close() return true");
}

// Ways out of the library, and values that could break the functions that take them.
const std::vector<const char*> attempts{
    "return os.execute('true')", "return io.popen('true')", "return os.remove('part.lua')",
    "return os.rename('part.lua', 'x')", "return os.tmpname()", "return io.tmpfile()",
    "return os.getenv('HOME')", "return os.setlocale('C')", "return package.loadlib('x', '*')",
    "package.cpath = '/usr/lib/?.so' return require 'socket'", "return package.searchers[3]",
    "return debug.getregistry()", "return debug.getinfo(1)", "return debug.sethook",
    "return debug.getupvalue(io.open, 1)", "return getmetatable(io.stdout).__gc",
    "return getmetatable(io.stdout).__index", "return string.dump(function() end)",
    "return load('\\27Lua', 'x', 'b')", "return load('\\27Lua', 'x', 'bt')",
    "return load(function() return '\\27LuaT' end)", "return load('\\27Lua')",
    // Lua stores its libraries where they could be found again.
    "return package.loaded.os.execute", "return package.loaded.debug.sethook",
    "return package.loaded._G.io.popen", "package.loaded.os = nil return require('os').execute",
    "package.loaded.debug = nil return require 'debug'",
    "package.preload.x = function() return os.execute end return type(require 'x') == "
    "'function'",
    "package.searchers = nil return require 'part'",
    "return setmetatable({}, { __gc = function() end })",
    "local m = {} setmetatable({}, m) m.__gc = print return setmetatable({}, m)",
    "return getmetatable(plate { width = 1, height = 1, material = 'duran50' }).__gc",
    "return rawset(getmetatable(''), '__metatable', 1).__index.dump",
    "return require '../outside/secret'", "return require '...outside.secret'",
    "return coroutine.wrap(function() return io.open('../outside/secret.lua') end)()",
    "return select(2, pcall(load, string.rep('(', 1e6))) .. nil",
    "return string.rep('x', 1e9):rep(1e9)", "return table.concat({}, 'x', 1, 1e18)",
    "return string.format('%1000000d', 1)", "return ('x'):rep(-1):len() > 0",
    "local function f() return 1 + f() end return f()",
    "local function f() return coroutine.wrap(f)() end return f()",
    "return string.gsub(('x'):rep(1e5), ('(x)'):rep(40), '')",
    "return string.find(('a'):rep(3e5), ('.-'):rep(3e5) .. 'b')",
    "return tostring(setmetatable({}, { __tostring = function(t) return tostring(t) end }))",
    "local t = setmetatable({}, {}) getmetatable(t).__index = t return t.x",
    "local t <close> = setmetatable({}, { __close = function() error 'closing' end })",
    "return table.unpack({}, 1, 1e8)", "return #table.pack(('x'):byte(1, -1, 0)) > 1",
    "return utf8.char(table.unpack({}, 1, 300))",
    // Functions of older versions, and of Lua's internals.
    "return loadstring", "return setfenv", "return getfenv", "return module", "return unpack",
    "return package.loadlib", "return package.cpath", "return debug.setmetatable('', {})",
    "return debug.setupvalue", "return debug.upvaluejoin", "return debug.getlocal(1, 1)",
    "return debug.getuservalue", "return string.dump", "return io.popen", "return os.getenv",
    "return require 'os.execute'", "return require '/etc/passwd'",
    "package.path = '/etc/?' return require 'passwd'",
    "package.path = '../outside/?.lua' return require 'secret'",
    "package.preload.y = loadfile return require 'y'()",
    // Texts and patterns.
    "return ('x'):rep(1e8):rep(1e8)", "return string.pack('s1', ('x'):rep(300))",
    "return string.unpack('s8', ('\\255'):rep(8))", "return ('x'):find('%')",
    "return ('x'):find('[a')", "return ('x'):find(('('):rep(33))", "return ('x'):gsub('x', '%2')",
    "return utf8.codepoint('\\xff')", "return utf8.char(-1)", "return os.date('%Ez')",
    "return os.time { year = 1e100 }", "return math.random(0, -1)",
    // Programs.
    "return load('goto nowhere')", "return load('::a:: ::a::')",
    "return load(string.rep('do ', 1e5))",
    "return load('return ' .. string.rep('not ', 1e6) .. '1')",
    "return load('local x <const> = 1 x = 2')", "return load(('x'):rep(1e6) .. '=')",
    "for i = 1, 10, 0 do end",
    // Tables.
    "local t = {} t[0/0] = 1", "return table.unpack({}, 1, 1e7)", "return table.insert({}, 5, 1)",
    "return table.move({ 1 }, 1, math.maxinteger, 2)", "return next({}, 'x')",
    "return setmetatable({}, 1)", "return setmetatable('x', {})",
    // Errors that fail themselves.
    "error(setmetatable({}, { __tostring = function() error 'again' end }))",
    "error(setmetatable({}, { __tostring = function() return 1 end }))",
    "error(setmetatable({}, { __name = 5 }))", "error()",
    "xpcall(error, function() error 'again' end)", "local t <close> = 5",
    "coroutine.close(coroutine.running())",
    "coroutine.wrap(function() coroutine.close(coroutine.running()) end)()",
    "local c c = coroutine.wrap(function() c() end) c()",
    // Our objects.
    "setmetatable(mine, {}) return true", "getmetatable(mine).__index = 1 return true",
    "rawset(mine, 'x', 1) return true", "return rawget(mine, 'x')", "return rawlen(mine)",
    "return mine + 1", "return mine .. 'x'", "return #mine", "return mine < mine",
    "mine() return true", "mine.hole(io.stdout, {}) return true", "mine.hole({}, {}) return true",
    "io.stdout.write(mine, 'x') return true", "simulate(io.stdout, { spacing = 1 }) return true",
    "return mine[mine]", "mine[mine] = 1 return true", "for k in pairs(mine) do return k end",
    "for k in ipairs(mine) do return k end", "return next(mine)", "return table.unpack(mine)",
    // Files.
    "local f = io.open('x.txt', 'w') f:close() f:write('x') return true",
    "return io.lines('part.lua', 'x')()", "return io.open('part.lua', 'rw')",
    "return io.open('part.lua', 'r'):write('x')"};

TEST_F(Jail, NothingOfLuaLeadsOut) {
  const std::string begun = "mine = plate { width = 1*mm, height = 1*mm, material = 'duran50' }\n";
  for (const char* attempt : attempts) expect_held(begun + attempt);
  EXPECT_GE(attempts.size(), 120U);
}

TEST_F(Jail, AGlobalTableThatFailsDoesNotReachThePrompt) {
  Console console(settings());
  console.evaluate(
      "setmetatable(_G, { __newindex = function() error 'no' end,"
      " __index = function() error 'no' end })");
  EXPECT_EQ(console.evaluate("1 + 1").at(0), "2");
  EXPECT_EQ(console.evaluate("rawget(_G, '_')").at(0), "2");
}

TEST_F(Jail, WhatIsInBoundsIsReached) {
  EXPECT_THAT(said(R"(
    assert(require 'part' == 42 and dofile 'part.lua' == 42 and loadfile('part.lua')() == 42)
    assert(loadfile('part.lua', 't', {})() == 42 and load('return 1')() == 1)
    assert(load('return x', 'x', 'b', { x = 3 })() == 3)
    assert(package.searchpath('part', package.path):find('part.lua', 1, true))
    assert(io.open('nothing') == nil and loadfile 'nothing' == nil)
    assert(io.open('part.lua'):read 'a' == 'return 42' and io.lines('part.lua')() == 'return 42')
    io.input('part.lua') assert(io.read 'a' == 'return 42') io.input(io.stdin)
    local file = io.open('new/notes.txt', 'w') file:write('one\n') file:close()
    assert(io.open('new/notes.txt'):read 'a' == 'one\n')
    assert(io.open(root .. '/out/new/notes.txt'):read 'a' == 'one\n')
    io.output('more.txt') io.write('two') io.close() io.output(io.stdout)
    assert(io.open('more.txt'):read 'a' == 'two')
    local p = plate { width = 10*mm, height = 10*mm, material = 'duran50' }
    p:mask { 'drawn.png', remove = 'light' }
  )"),
              HasSubstr("main.lua:16: cannot read the picture"));  // it does not exist
}

TEST_F(Jail, AFileThatTheCommandLineNamesIsRead) {
  write_text(root_ / "scripts/main.lua", "assert(dofile(...) == 'hidden treasure')");
  const std::string named = (root_ / "outside/secret.lua").string();
  Console(settings()).run_file(root_ / "scripts/main.lua", {named});
  EXPECT_THROW(Console(settings()).run_file(root_ / "scripts/main.lua", {named + "x"}), Error);
}

TEST_F(Jail, TrustLiftsIt) {
  EXPECT_EQ(said("assert(dofile('../outside/secret.lua') == 'hidden treasure')\n"
                 "assert(load(string.dump(function() return 1 end))() == 1)\n"
                 "io.open('../outside/new', 'w'):close()",
                 true),
            "");
  EXPECT_TRUE(fs::exists(root_ / "outside/new"));
}

// When everything is destroyed at once, finalizers of our objects run before those of a script.
TEST_F(Jail, FinalizersOfATrustedScriptFindNothingThatIsGone) {
  const std::string keep = test::scene + "t.s, t.p, t.run, t.simulate = s, p, s.run, simulate\n";
  EXPECT_EQ(said("local t = setmetatable({}, { __gc = function(t)\n"
                 "  pcall(t.run, t.s, 1e-6) pcall(t.simulate, t.p, { spacing = 1 })\n"
                 "  pcall(function() return t.s.time + t.p.width end) end })\n" +
                     keep + "t, s, p = nil collectgarbage() collectgarbage()",
                 true),
            "");
  EXPECT_EQ(
      said("local t = setmetatable({}, { __gc = function(t)\n"
           "  pcall(function() return t.s.time end) pcall(function() return t.p.x end) end })\n" +
               keep,
           true),
      "");
}

TEST_F(Jail, TheOutputFolderMayNotLeadElsewhere) {
  const fs::path before = fs::current_path();
  fs::create_directory_symlink("outside", root_ / "out/main");
  fs::create_directory(root_ / "here");
  fs::create_directory_symlink("../outside", root_ / "here/out");
  fs::current_path(root_ / "here");
  write_text("main.lua", "io.open('new', 'w')");
  write_text("...lua", "io.open('new', 'w')");
  for (const char* script : {"main.lua", "...lua"}) {
    ConsoleSettings by_default = settings();
    by_default.output_folder.clear();
    EXPECT_THROW(Console(by_default).run_file(script), Error) << script;
  }
  fs::current_path(before);
}

}  // namespace
}  // namespace hackle
