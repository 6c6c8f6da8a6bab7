// SPDX-License-Identifier: MIT
// No name of an anonymous namespace hides one of a header. Sources of a room share units, where the
// compiler would take the hiding name without a warning, also in a source that means the header's.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "house/rooms.hpp"
#include "house/source_text.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

struct HeaderName {
  fs::path header;  // below src/, beginning with the room
  Declaration declaration;
};
using HeaderNames = std::multimap<std::string, HeaderName>;

std::string room_of(const fs::path& file) {
  return file.begin()->string();
}

bool sees(const std::string& room, const std::string& other) {
  return room == other || (may_see.contains(room) && may_see.at(room).contains(other));
}

// Functions of one name are overloads if their parameters differ.
bool hides(const Declaration& own, const Declaration& other) {
  return !own.is_function || !other.is_function || own.parameters == other.parameters;
}

std::vector<std::string> hidden_by(const fs::path& file, const std::string& source,
                                   const HeaderNames& names) {
  std::vector<std::string> hidden;
  for (const Declaration& own : declarations_of(source)) {
    const auto [begin, end] = names.equal_range(own.name);
    for (auto it = begin; own.is_anonymous && it != end; ++it) {
      const HeaderName& other = it->second;
      if (sees(room_of(file), room_of(other.header)) && hides(own, other.declaration))
        hidden.push_back(own.name + " of src/" + other.header.string());
    }
  }
  return hidden;
}

void add_names(const fs::path& header, const std::string& source, HeaderNames& names) {
  for (const Declaration& declaration : declarations_of(source))
    if (!declaration.is_anonymous) names.emplace(declaration.name, HeaderName{header, declaration});
}

std::map<fs::path, std::string> sources(const std::string& ending) {
  const fs::path folder = fs::path(HACKLE_SOURCE_FOLDER) / "src";
  std::map<fs::path, std::string> texts;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ending) continue;
    std::ifstream file(entry.path());
    texts[fs::relative(entry.path(), folder)] = {std::istreambuf_iterator<char>(file), {}};
  }
  return texts;
}

std::vector<std::string> hidden_in(const std::string& source) {
  HeaderNames names;
  add_names("scene/one.hpp", R"(
    // int in_comment = 1; {
    namespace hackle {
    inline constexpr double limit = 0.5;
    template <class Real> inline constexpr Real range = Real{1};
    struct Plate { int width = 1; };
    int area_of(const Plate& plate, int scale = 2);
    inline int half(int value) { return value / 2; }
    }  // namespace hackle
  )",
            names);
  add_names("console/two.hpp", "namespace hackle { inline constexpr int far = 1; }", names);
  return hidden_by("solver/three.cpp", source, names);
}

TEST(HiddenNames, ConstantsHideConstantsAndFunctions) {
  EXPECT_THAT(hidden_in("namespace hackle { namespace { constexpr int limit{2}; } }"),
              ElementsAre("limit of src/scene/one.hpp"));
  EXPECT_THAT(hidden_in("namespace { const char* const range[] = {\"}\", \"{\"}; }"),
              ElementsAre("range of src/scene/one.hpp"));
  EXPECT_THAT(hidden_in("namespace { constexpr auto half = 0.5; }"),
              ElementsAre("half of src/scene/one.hpp"));
  EXPECT_THAT(hidden_in("void A::f() : b(1) {} namespace { std::atomic<int> limit; }"),
              ElementsAre("limit of src/scene/one.hpp"));
  EXPECT_THAT(hidden_in("namespace { double limit(int x) { return x; } }"),
              ElementsAre("limit of src/scene/one.hpp"));
}

TEST(HiddenNames, FunctionsHideThoseOfTheSameParameters) {
  EXPECT_THAT(hidden_in("namespace { int area_of(const Plate& p, int s) { return s; } }"),
              ElementsAre("area_of of src/scene/one.hpp"));
  EXPECT_THAT(hidden_in("namespace { int area_of(const Disc& disc) { return {}; } }"), IsEmpty());
}

TEST(HiddenNames, MembersLocalsAndNamesOfRoomsThatAreNotSeenHideNothing) {
  EXPECT_THAT(hidden_in("namespace { struct A { int limit = 1; }; void f() { int range = 1; } }"),
              IsEmpty());
  EXPECT_THAT(hidden_in("namespace hackle { constexpr int limit = 1; }"), IsEmpty());
  EXPECT_THAT(hidden_in("namespace { constexpr int far = 1; int in_comment = 2; int width; }"),
              IsEmpty());
}

TEST(House, NoAnonymousNameHidesOneOfAHeader) {
  HeaderNames names;
  for (const auto& [file, source] : sources(".hpp")) add_names(file, source, names);
  EXPECT_GT(names.size(), 500U);
  for (const auto& [file, source] : sources(".cpp"))
    EXPECT_THAT(hidden_by(file, source, names), IsEmpty()) << "in src/" << file.string();
}

}  // namespace
}  // namespace hackle
