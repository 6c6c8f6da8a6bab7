// SPDX-License-Identifier: MIT
// Every ready-made scene must have a header with its expected result, a line in scripts/README.md
// and a test.
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/files.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;

const fs::path root = HACKLE_SOURCE_FOLDER;

const std::vector<const char*> tested{"samples", "benchmarks", "gallery", "specimens"};
// hackle validate itself tests the last ones.
const std::vector<const char*> every_one{"samples", "benchmarks", "gallery", "specimens",
                                         "validation"};

// Returns "samples/hole.lua" and all others.
std::vector<std::string> scenes(const std::vector<const char*>& folders) {
  std::vector<std::string> names;
  for (const char* folder : folders)
    for (const auto& file : fs::directory_iterator(root / "scripts" / folder))
      if (file.path().extension() == ".lua" && file.path().stem() != "parts")
        names.push_back(std::string(folder) + "/" + file.path().filename().string());
  return names;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// Returns the comment lines at the top of a script.
std::string header_of(const std::string& text) {
  std::smatch found;
  return std::regex_search(text, found, std::regex("^(--[^\n]*\n)+")) ? found.str() : "";
}

TEST(Scenes, SayWhatTheyAreAndWhatToExpect) {
  for (const std::string& name : scenes(every_one)) {
    const std::string header = header_of(read_text(root / "scripts" / name));
    EXPECT_TRUE(header.starts_with("-- " + fs::path(name).filename().string() + ": ")) << name;
    EXPECT_TRUE(contains(header, "-- Expected: ")) << name;
    const std::string module = "require \"specimens." + fs::path(name).stem().string() + "\"";
    EXPECT_TRUE(contains(header, "hackle run scripts/" + name) || contains(header, module)) << name;
  }
}

// Modules expect nothing themselves.
TEST(Scenes, SayItAsExpectations) {
  for (const std::string& name : scenes({"samples", "benchmarks", "gallery", "validation"}))
    EXPECT_TRUE(contains(read_text(root / "scripts" / name), "expect {")) << name;
}

TEST(Scenes, StandInTheReadme) {
  const std::string readme = read_text(root / "scripts" / "README.md");
  for (const std::string& name : scenes(every_one))
    EXPECT_TRUE(contains(readme, "(" + name + ")")) << name;
}

TEST(Scenes, HaveATest) {
  std::string tests;
  for (const auto& file : fs::directory_iterator(root / "tests" / "scripts"))
    tests += read_text(file.path());
  ASSERT_GE(scenes(tested).size(), 20U);
  for (const std::string& name : scenes(tested)) {
    const std::string module = fs::path(name).stem().string();
    EXPECT_TRUE(contains(tests, "\"" + name + "\"") || contains(tests, "{\"" + module + "\""))
        << name;
  }
}

}  // namespace
}  // namespace hackle
