// SPDX-License-Identifier: MIT
// The rooms of src/ include each other in one direction only (src/README.md).
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "house/rooms.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;

// Libraries that only one room, or one file of it, may use.
const std::map<std::string, std::set<std::string>> rooms_of_library = {
    {"lua.hpp", {"console"}},
    {"lauxlib.h", {"console"}},
    {"GL/", {"render"}},
    {"EGL/", {"render/gl/gl_egl.cpp"}},
    {"cairo", {"render"}},
    {"png.h", {"render"}},
    {"hdf5.h", {"store"}},
    {"zlib.h", {"store"}},
    {"libav", {"movie"}},
    {"libswscale", {"movie"}},
    {"oneapi/", {"solver"}},
    {"CLI/", {"app"}},
    {"mpi.h", {"base/ranks/mpi_ranks.cpp"}},
    {"histedit.h", {"console"}},
    {"editline/", {"console"}},
    {"chafa", {"console/language/preview.cpp"}},
    {"glib", {}},
};

struct Include {
  std::string room, file, target;
};

template <class Visit>
void for_each_include(Visit visit) {
  const std::regex pattern(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
  const fs::path source = fs::path(HACKLE_SOURCE_FOLDER) / "src";
  for (const auto& entry : fs::recursive_directory_iterator(source)) {
    if (entry.path().extension() != ".cpp" && entry.path().extension() != ".hpp") continue;
    const fs::path name = fs::relative(entry.path(), source);
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);) {
      std::smatch match;
      if (std::regex_search(line, match, pattern))
        visit(Include{name.begin()->string(), name.string(), match[1]});
    }
  }
}

TEST(House, EveryRoomIsKnown) {
  for (const auto& entry : fs::directory_iterator(fs::path(HACKLE_SOURCE_FOLDER) / "src")) {
    if (!entry.is_directory()) continue;
    EXPECT_TRUE(may_see.contains(entry.path().filename().string())) << entry.path().filename();
  }
}

TEST(House, NoIncludeRunsAgainstTheArrows) {
  int seen = 0;
  for_each_include([&](const Include& include) {
    const std::string target = include.target.substr(0, include.target.find('/'));
    if (!may_see.contains(target) || target == include.target) return;
    ++seen;
    EXPECT_TRUE(target == include.room || may_see.at(include.room).contains(target))
        << "src/" << include.file << " includes " << include.target;
  });
  EXPECT_GT(seen, 50);
}

TEST(House, LibrariesStayInTheirRooms) {
  for_each_include([&](const Include& include) {
    if (include.file == "app/libraries.cpp") return;  // reports the version of each
    for (const auto& [library, rooms] : rooms_of_library) {
      if (!include.target.starts_with(library)) continue;
      EXPECT_TRUE(rooms.contains(include.room) || rooms.contains(include.file))
          << "src/" << include.file << " includes " << include.target;
    }
  });
}

TEST(House, EveryFileCarriesItsLicence) {
  for (const char* folder : {"src", "tests"})
    for (const auto& entry :
         fs::recursive_directory_iterator(fs::path(HACKLE_SOURCE_FOLDER) / folder)) {
      if (entry.path().extension() != ".cpp" && entry.path().extension() != ".hpp") continue;
      std::ifstream file(entry.path());
      std::string line;
      std::getline(file, line);
      EXPECT_EQ(line, "// SPDX-License-Identifier: MIT") << entry.path();
    }
}

}  // namespace
}  // namespace hackle
