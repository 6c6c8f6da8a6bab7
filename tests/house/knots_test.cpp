// SPDX-License-Identifier: MIT
// Includes between units of src/ form no cycle (src/README.md). A unit is a .cpp with its .hpp.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace hackle {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

using Units = std::set<std::string>;
using UnitGraph = std::map<std::string, Units>;  // from a unit to the units it includes

std::string without_ending(const fs::path& file) {
  return (file.parent_path() / file.stem()).generic_string();
}

Units units_included_by(const fs::path& file) {
  static const std::regex pattern(R"(^\s*#\s*include\s*"([^"]+)\")");
  Units units;
  std::ifstream text(file);
  std::smatch match;
  for (std::string line; std::getline(text, line);)
    if (std::regex_search(line, match, pattern)) units.insert(without_ending(match[1].str()));
  return units;
}

UnitGraph unit_graph_of(const fs::path& source) {
  UnitGraph graph;
  for (const auto& entry : fs::recursive_directory_iterator(source)) {
    if (entry.path().extension() != ".cpp" && entry.path().extension() != ".hpp") continue;
    const std::string unit = without_ending(fs::relative(entry.path(), source));
    Units& known = graph[unit];
    known.merge(units_included_by(entry.path()));
    known.erase(unit);
  }
  return graph;
}

// Returns all units reached by one include or more.
Units reached_from(const std::string& unit, const UnitGraph& graph) {
  Units reached;
  std::vector<std::string> open{unit};
  while (!open.empty()) {
    const auto found = graph.find(open.back());
    open.pop_back();
    if (found == graph.end()) continue;
    for (const std::string& next : found->second)
      if (reached.insert(next).second) open.push_back(next);
  }
  return reached;
}

// Returns the sets of units that all reach each other.
std::set<Units> knots_of(const UnitGraph& graph) {
  std::map<std::string, Units> reached;
  for (const auto& [unit, included] : graph) reached[unit] = reached_from(unit, graph);
  std::set<Units> knots;
  for (const auto& [unit, forward] : reached) {
    Units knot;
    for (const std::string& other : forward)
      if (reached.contains(other) && reached.at(other).contains(unit)) knot.insert(other);
    if (!knot.empty()) knots.insert(knot);
  }
  return knots;
}

// The kernel is one unit in several headers: its parts call each other inline.
bool is_of_kernel(const std::string& unit) {
  static const std::regex kernel("solver/cpu/(kernel|simd|tile|scratch).*");
  return std::regex_match(unit, kernel);
}

// Makes a folder of small files, each with a name and some includes.
class KnotsOfTree : public testing::Test {
 protected:
  KnotsOfTree() { fs::remove_all(folder_); }
  ~KnotsOfTree() override { fs::remove_all(folder_); }

  void write(const std::string& file, const std::vector<std::string>& includes) {
    fs::create_directories((folder_ / file).parent_path());
    std::ofstream text(folder_ / file);
    text << "#include <vector>\n";
    for (const std::string& include : includes) text << "#include \"" << include << "\"\n";
  }

  std::set<Units> knots() const { return knots_of(unit_graph_of(folder_)); }

 private:
  fs::path folder_ =
      fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(KnotsOfTree, AFileAndItsHeaderAreOneUnit) {
  write("a/one.hpp", {});
  write("a/one.cpp", {"a/one.hpp", "b/two.hpp"});
  write("b/two.hpp", {});
  write("b/two.cpp", {"b/two.hpp"});
  EXPECT_THAT(knots(), IsEmpty());
}

TEST_F(KnotsOfTree, ACircleThroughASourceFileIsOne) {
  write("a/one.hpp", {});
  write("a/one.cpp", {"a/one.hpp", "b/two.hpp"});
  write("b/two.hpp", {"a/one.hpp"});
  write("b/three.hpp", {"b/two.hpp"});
  EXPECT_THAT(knots(), ElementsAre(Units{"a/one", "b/two"}));
}

TEST_F(KnotsOfTree, EachCircleIsFoundOnceAndWhole) {
  write("a/one.hpp", {"a/two.hpp"});
  write("a/two.hpp", {"a/three.hpp"});
  write("a/three.hpp", {"a/one.hpp", "b/four.hpp"});
  write("b/four.hpp", {"b/five.hpp"});
  write("b/five.hpp", {"b/four.hpp"});
  EXPECT_THAT(knots(), ElementsAre(Units{"a/one", "a/three", "a/two"}, Units{"b/five", "b/four"}));
}

TEST(House, NoUnitsIncludeEachOtherInACircle) {
  const UnitGraph graph = unit_graph_of(fs::path(HACKLE_SOURCE_FOLDER) / "src");
  EXPECT_GT(graph.size(), 200U);
  for (const Units& knot : knots_of(graph))
    EXPECT_TRUE(std::ranges::all_of(knot, is_of_kernel))
        << "a circle of includes: " << testing::PrintToString(knot);
}

}  // namespace
}  // namespace hackle
