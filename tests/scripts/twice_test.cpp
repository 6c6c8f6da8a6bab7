// SPDX-License-Identifier: MIT
// Every ready-made script must do the same in two processes: the same states and files, to the bit.
// Scenes are solved on lattices twice as coarse as intended.
#include <algorithm>
#include <cstdlib>
#include <map>
#include <regex>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/program.hpp"
#include "base/error.hpp"
#include "base/files.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;

const fs::path scripts = fs::path(HACKLE_SOURCE_FOLDER) / "scripts";

// Returns false for a sheet of other scripts' output, for modules, and for what studies run.
bool stands_alone(const fs::path& script) {
  return script.filename() != "contact_sheet.lua" && script.filename() != "dxf.lua" &&
         script.filename() != "watch.lua" && script.parent_path().filename() != "validation" &&
         script.parent_path().filename() != "specimens" &&
         script.parent_path().filename() != "dxf" &&
         script.parent_path().filename() != "envelope" &&
         script.parent_path().filename() != "study";
}

std::vector<fs::path> ready_scripts() {
  std::vector<fs::path> found;
  for (const auto& entry : fs::recursive_directory_iterator(scripts))
    if (entry.path().extension() == ".lua" && stands_alone(entry.path()))
      found.push_back(entry.path());
  std::ranges::sort(found);
  return found;
}

// Returns the spacing and horizon that a script declares, doubled: "--set", "spacing=0.001", ...
std::vector<std::string> coarser(const std::string& help) {
  std::vector<std::string> words;
  for (const char* option : {"spacing", "horizon"}) {
    std::smatch match;
    const std::regex line(fmt::format("\\n  {} = ([0-9.e-]+)", option));
    if (!std::regex_search(help, match, line)) continue;
    words.insert(words.end(),
                 {"--set", fmt::format("{}={:.17g}", option, 2.0 * std::stod(match[1]))});
  }
  return words;
}

// A run file stores when it was begun.
std::string without_date(const std::string& content) {
  static const std::regex date("20[0-9]{2}-[0-9]{2}-[0-9]{2}T[0-9]{2}:[0-9]{2}:[0-9]{2}Z");
  return std::regex_replace(content, date, "");
}

struct Left {
  std::vector<std::string> hashes;           // of the states
  std::map<std::string, std::string> files;  // name to content
};

Left run(const fs::path& script) {
  const test::Folder folder;
  const test::Program program(folder);
  std::vector<std::string> words{"run", script.string(), "--json", "-q", "-o", "out"};
  std::vector<std::string> coarse = words;
  for (const std::string& word : coarser(program.run({"run", script.string(), "--help"}).out))
    coarse.push_back(word);
  test::Ended ended = program.run(coarse);
  // Its frames are closer together than the steps of a coarse plate.
  if (ended.code == static_cast<int>(ErrorKind::refused)) ended = program.run(words);
  EXPECT_EQ(ended.code, 0) << script << "\n" << ended.err;
  Left left;
  const auto json = nlohmann::json::parse(ended.out);
  const auto all = json.contains("simulations") ? json["simulations"] : nlohmann::json{json};
  for (const auto& summary : all) left.hashes.push_back(summary.at("hash"));
  if (fs::exists(folder.path / "out"))
    for (const auto& entry : fs::recursive_directory_iterator(folder.path / "out"))
      if (entry.is_regular_file())
        left.files[fs::relative(entry.path(), folder.path).string()] =
            without_date(read_text(entry.path()));
  return left;
}

class EveryScript : public testing::TestWithParam<fs::path> {};

// Those of the gallery film much: every change runs the others.
bool is_for_the_night(const fs::path& script) {
  return script.parent_path().filename() == "gallery" &&
         std::getenv("HACKLE_ALL_SCRIPTS") == nullptr;  // NOLINT(concurrency-mt-unsafe)
}

TEST_P(EveryScript, DoesTheSameTwice) {
  if (is_for_the_night(GetParam())) GTEST_SKIP() << "with HACKLE_ALL_SCRIPTS, as in .ci/nightly";
  const Left one = run(GetParam()), other = run(GetParam());
  EXPECT_EQ(one.hashes, other.hashes);
  ASSERT_EQ(one.files.size(), other.files.size());
  for (const auto& [name, content] : one.files) {
    ASSERT_TRUE(other.files.contains(name)) << name;
    EXPECT_TRUE(content == other.files.at(name)) << name << " differs";
  }
}

INSTANTIATE_TEST_SUITE_P(Scripts, EveryScript, testing::ValuesIn(ready_scripts()),
                         [](const auto& given) { return given.param.stem().string(); });

// `pairs` over texts, with loads applied to one node in its order.
TEST(Pairs, GiveOneHashInEveryProcess) {
  const test::Folder folder;
  const test::Program program(folder);
  write_text(folder.path / "a.lua", R"(
local p = plate { width = 20*mm, height = 10*mm, material = "duran50" }
local loads = { alpha = 1.1*MPa, beta = 2.3*MPa, gamma = 0.7*MPa, delta = 3.1*MPa, eps = 0.9*MPa }
for name, v in pairs(loads) do p:traction { edge = "top", stress = {v/3, v} } end
p:clamp { edge = "bottom", depth = 1*mm }
local s = simulate(p, { spacing = 0.5*mm })
s:run(5*us)
local names = {}
for name in next, loads do names[#names + 1] = name end
print(table.concat(names, " "), tostring(loads), s.hash))");
  const std::string first = program.run({"run", "a.lua", "-q"}).out;
  EXPECT_EQ(first.substr(0, first.find('\t')), "alpha beta delta eps gamma");
  for (int k = 1; k < 8; ++k) EXPECT_EQ(program.run({"run", "a.lua", "-q"}).out, first);
}

}  // namespace
}  // namespace hackle
