// SPDX-License-Identifier: MIT
// A list has everything that a script can reach; an addition must be reviewed.
#include "console/lua/standard_library.hpp"

#include <fstream>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "console/reference/vocabulary.hpp"
#include "console/scripts.hpp"

namespace hackle {
namespace {

// Breadth first from _G through tables and metatables, in the order of names; counts functions
// only.
const std::string walk = R"(
local seen, found, queue = {}, {}, { { "_G", _G }, { "string metatable", getmetatable "" },
  { "file metatable", getmetatable(io.stdout) }, { "_ENV metatable", getmetatable(_G) } }
local function visit(name, value)
  if type(value) == "function" and not seen[value] then found[#found + 1] = name end
  if (type(value) == "function" or type(value) == "table") and not seen[value] then
    seen[value] = true
    if type(value) == "table" then queue[#queue + 1] = { name, value } end
  end
end
while #queue > 0 do
  local name, value = table.unpack(table.remove(queue, 1))
  if type(value) == "table" then
    seen[value] = true
    local keys = {}
    for key, inner in next, value do keys[#keys + 1] = tostring(key) visit("", nil) end
    table.sort(keys)
    for _, key in ipairs(keys) do
      local inner = rawget(value, key)
      if inner == nil then inner = rawget(value, math.tointeger(key)) end
      visit((name == "_G" and "" or name .. ".") .. key, inner)
    end
    if type(getmetatable(value)) == "table" then visit(name .. " metatable", getmetatable(value)) end
  end
end
table.sort(found)
return table.concat(found, "\n")
)";

// Returns the names of all reachable functions, one per line.
std::string reached() {
  Console console(test::quiet());
  std::string names = console.evaluate(fmt::format("(function() {} end)()", walk)).at(0) + "\n";
  for (const TypeDoc* type : all_types())
    for (const Function& method : type->methods)
      names += std::string(type->name) + ":" + std::string(method.doc->name) + "\n";
  return names;
}

TEST(StandardLibrary, GivesAScriptWhatIsListedAndNothingElse) {
  const auto list = std::filesystem::path(HACKLE_SOURCE_FOLDER) / "tests/console/reachable.txt";
  std::ifstream file(list);
  const std::string listed{std::istreambuf_iterator<char>(file), {}};
  const std::string now = reached();
  if (now != listed)
    std::ofstream(std::filesystem::path(testing::TempDir()) / "reachable.txt") << now;
  EXPECT_EQ(now, listed) << "if that is meant, copy " << testing::TempDir() << "reachable.txt to "
                         << list;
}

TEST(StandardLibrary, IsWholeForATrustedScript) {
  EXPECT_EQ(test::message_of("assert(os.execute and io.popen and debug.sethook and string.dump and "
                             "package.loadlib and #package.searchers == 4 and os.getenv)",
                             test::trusted()),
            "");
}

}  // namespace
}  // namespace hackle
