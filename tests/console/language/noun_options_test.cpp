// SPDX-License-Identifier: MIT
// Every member of every noun that is described, whatever it is called: through the JSON of a run
// file and through a script. Which nouns there are is read from the source.
#include "console/language/noun_options.hpp"

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "console/language/live_view.hpp"
#include "console/language/picture_options.hpp"
#include "console/lua/error_object.hpp"
#include "console/scripts.hpp"
#include "lattice/numerics.hpp"
#include "output/chart/chart_options.hpp"
#include "output/files/record_options.hpp"
#include "output/files/replay_options.hpp"
#include "output/files/series_options.hpp"
#include "store/noun_reader.hpp"
#include "support/nouns.hpp"

namespace hackle {
namespace {

constexpr int seeds = 24;  // of a choice among four each is then missed once in a thousand times

struct Given {
  template <class T>
  constexpr bool operator()(std::type_identity<T>) const {
    return option_type<T>().has_value() && !std::is_same_v<T, Material>;
  }
};

std::string lua_text(double value) {
  return fmt::format("{:.17g}", value);
}
std::string lua_text(bool value) {
  return value ? "true" : "false";
}
std::string lua_text(const std::string& value) {
  return "'" + value + "'";
}
std::string lua_text(const Vec2& value) {
  return fmt::format("{{{:.17g}, {:.17g}}}", value.x(), value.y());
}
std::string lua_text(const Ends& value) {
  return lua_text(Vec2(value.min, value.max));
}
std::string lua_text(const Zoom& value) {
  return fmt::format("{{{:.17g}, {:.17g}, {:.17g}}}", value.centre.x(), value.centre.y(),
                     value.half_width);
}
std::string lua_text(const Marker& value) {
  return fmt::format("{{{:.17g}, {:.17g}, '{}'}}", value.place.x(), value.place.y(), value.label);
}
std::string lua_text(const Material&) {
  return "'soda_lime'";
}
template <class T>
std::string lua_text(const FieldOfPlace<T>& value) {
  return lua_text(value.constant());
}
template <class T>
requires std::is_enum_v<T> std::string lua_text(T value) {
  return lua_text(std::string(name_of(value)));
}
template <class T>
requires(std::is_integral_v<T> && !std::is_same_v<T, bool>) std::string lua_text(T value) {
  return std::to_string(value);
}
template <class T>
std::string lua_text(const std::optional<T>& value) {
  return lua_text(*value);
}
template <class T>
std::string lua_text(const std::vector<T>& list) {
  std::string text = "{";
  for (const T& entry : list) text += lua_text(entry) + ", ";
  return text + "}";
}
std::string lua_text(const Amplitude& value) {
  return lua_text(value.points());
}

// "name = value, " of every member that is an option.
template <Described Noun>
std::string options_text(const Noun& noun) {
  std::string text;
  const auto add = [&](std::string_view name, const auto& value) {
    text += fmt::format("{} = {}, ", name, lua_text(value));
  };
  for_each_member<Noun>([&](const auto& member) {
    const auto& value = noun.*member.pointer;
    using T = std::remove_cvref_t<decltype(value)>;
    if constexpr (requires { member.kind; }) {
      add(member.names[static_cast<std::size_t>(noun.*member.kind)], value);
    } else if constexpr (option_type<T>().has_value()) {
      add(member.name, value);
    } else if constexpr (Described<T>) {
      if (member.name.empty()) text += options_text(value);
    }
  });
  return text;
}

// A material is read by a function of its own, see Members.OfAMaterial.
template <Described Noun>
void copy_materials(const Noun& from, Noun& to) {
  for_each_member<Noun>([&](const auto& member) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(member.pointer)>, Material Noun::*>)
      to.*member.pointer = from.*member.pointer;
  });
}

template <Described Noun>
void expect_all_described() {
  if constexpr (std::is_aggregate_v<Noun>) {
    EXPECT_EQ(test::count_members<Noun>(), test::count_described<Noun>());
  }
}

template <Described Noun>
void go_through_json(int seed) {
  Noun wanted, found;
  test::NounFiller(seed).fill(wanted, {});
  const std::string text = NounWriter::json_of(wanted).dump();
  NounReader().read(NounReader::Json::parse(text), found);
  EXPECT_TRUE(same(found, wanted)) << text;
}

template <Described Noun>
void go_through_script(int seed) {
  Session session(test::quiet());
  LuaState L;
  set_session(L, &session);
  Noun wanted;
  test::NounFiller(seed).fill_members<Given>(wanted);
  const std::string script = "return { " + options_text(wanted) + "}";
  ASSERT_EQ(luaL_loadstring(L, script.c_str()), LUA_OK) << script;
  protected_call(L, 0, 1);
  auto options = options_of<Noun>;
  for (Option& option : options)  // its function asks for the one that goes with the kind
    if (option.alternative) option.required = false;
  const FunctionDoc doc{.name = description_of<Noun>.noun, .options = options};
  const Arguments arguments = Arguments::from_table(L, 1, doc);
  ASSERT_TRUE(arguments.problems.empty())
      << arguments.problems.list().front().what << " " << script;
  const Noun found = noun_of<Noun>(arguments);
  copy_materials(found, wanted);
  EXPECT_TRUE(same(found, wanted)) << script;
}

struct Trip {
  const char* name;
  void (*all_described)();
  void (*json)(int seed);
  void (*script)(int seed);
};

template <Described Noun>
constexpr Trip trip(const char* name) {
  return {name, expect_all_described<Noun>, go_through_json<Noun>, go_through_script<Noun>};
}

const Trip trips[] = {
    trip<Absorber>("Absorber"),
    trip<BodyForce>("BodyForce"),
    trip<Bitmap>("Bitmap"),
    trip<Capsule>("Capsule"),
    trip<ChartOptions>("ChartOptions"),
    trip<Contact>("Contact"),
    trip<Crack>("Crack"),
    trip<Cutout>("Cutout"),
    trip<Ellipse>("Ellipse"),
    trip<Ends>("Ends"),
    trip<Foundation>("Foundation"),
    trip<Guided>("Guided"),
    trip<Impactor>("Impactor"),
    trip<Inclusion>("Inclusion"),
    trip<InitialCondition>("InitialCondition"),
    trip<Loads>("Loads"),
    trip<Marker>("Marker"),
    trip<Material>("Material"),
    trip<Moments>("Moments"),
    trip<MovieOptions>("MovieOptions"),
    trip<Numerics>("Numerics"),
    trip<Outline>("Outline"),
    trip<OverlayOptions>("OverlayOptions"),
    trip<PictureOptions>("PictureOptions"),
    trip<Plate>("Plate"),
    trip<Platen>("Platen"),
    trip<Polygon>("Polygon"),
    trip<Pressure>("Pressure"),
    trip<RecordOptions>("RecordOptions"),
    trip<Ring>("Ring"),
    trip<Roller>("Roller"),
    trip<Scatter>("Scatter"),
    trip<Segment>("Segment"),
    trip<SeriesOptions>("SeriesOptions"),
    trip<SheetOptions>("SheetOptions"),
    trip<ShownRecord>("ShownRecord"),
    trip<SideBySideOptions>("SideBySideOptions"),
    trip<Support>("Support"),
    trip<ThermalLoad>("ThermalLoad"),
    trip<Traction>("Traction"),
    trip<WatchOptions>("WatchOptions"),
    trip<Zoom>("Zoom"),
};

// The nouns that have a description somewhere in the source.
std::set<std::string> described_in_source() {
  std::set<std::string> names;
  const std::regex pattern("auto description_of<(\\w+)> =");
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(HACKLE_SOURCE_FOLDER "/src")) {
    if (entry.path().extension() != ".hpp") continue;
    std::ifstream file(entry.path());
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    for (std::sregex_iterator found(text.begin(), text.end(), pattern), end; found != end; ++found)
      names.insert((*found)[1]);
  }
  return names;
}

TEST(DescribedNouns, AreAllTestedHere) {
  std::set<std::string> names;
  for (const Trip& one : trips) names.insert(one.name);
  EXPECT_EQ(names, described_in_source());
}

TEST(DescribedNouns, DescribeEveryMember) {
  for (const Trip& one : trips) {
    SCOPED_TRACE(one.name);
    one.all_described();
  }
}

TEST(DescribedNouns, ComeBackFromJson) {
  for (const Trip& one : trips)
    for (int seed = 0; seed < seeds; ++seed) {
      SCOPED_TRACE(one.name);
      one.json(seed);
    }
}

TEST(DescribedNouns, ComeBackFromAScript) {
  for (const Trip& one : trips)
    for (int seed = 0; seed < seeds; ++seed) {
      SCOPED_TRACE(one.name);
      one.script(seed);
    }
}

// The comparison itself sees every member.
TEST(DescribedNouns, AreNotTheSameWhenOneMemberDiffers) {
  PictureOptions one, other;
  EXPECT_TRUE(same(one, other));
  other.overlay.markers = {{{0.0, 1.0}, "a"}};
  EXPECT_FALSE(same(one, other));
  one.overlay.markers = {{{0.0, 1.0}, "b"}};
  EXPECT_FALSE(same(one, other));
  one.overlay.markers.front().label = "a";
  EXPECT_TRUE(same(one, other));
  Support moved, held;
  moved.kind = Support::Kind::velocity;
  EXPECT_FALSE(same(moved, held));
}

}  // namespace
}  // namespace hackle
