// SPDX-License-Identifier: MIT
// hackle study on a small plate.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "app/program.hpp"
#include "base/files.hpp"

namespace hackle::test {

// 800 nodes, in which a crack begins to run.
inline constexpr auto small_plate = R"(
local o = options { load = 12*MPa, spacing = 1*mm, horizon = 3*mm, time = 12*us }
local p = plate { width = 40*mm, height = 20*mm, material = "duran50" }
p:crack    { from = {0, 10*mm}, to = {20*mm, 10*mm} }
p:traction { edge = "top",    stress = {0,  o.load} }
p:traction { edge = "bottom", stress = {0, -o.load} }
p:nofail   { edge = "top",    depth = o.horizon }
p:nofail   { edge = "bottom", depth = o.horizon }
local s = simulate(p, { spacing = o.spacing, horizon = o.horizon })
s:run(o.time)
print "a word of the script"
)";

class StudiedPlate : public testing::Test {
 protected:
  StudiedPlate() { write_text(folder_.path / "a.lua", small_plate); }
  Ended study(const std::string& kind, std::vector<std::string> words) const {
    words.insert(words.begin(), {"study", kind, "a.lua", "-o", "out"});
    return program_.run(words);
  }
  nlohmann::json told(const std::string& kind, std::vector<std::string> words) const {
    words.emplace_back("--json");
    const Ended ended = study(kind, words);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return nlohmann::json::parse(ended.out);
  }
  bool exists(const std::string& name) const {
    return std::filesystem::exists(folder_.path / "out" / name);
  }

  Folder folder_;
  Program program_{folder_};
};

}  // namespace hackle::test
