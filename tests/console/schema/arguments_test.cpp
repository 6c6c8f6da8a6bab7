// SPDX-License-Identifier: MIT
#include "console/schema/arguments.hpp"

#include <random>

#include <gmock/gmock.h>

#include "console/language/material_binding.hpp"
#include "console/language/plate_binding.hpp"
#include "console/language/scripted_material.hpp"
#include "console/language/scripted_plate.hpp"
#include "console/language/units_binding.hpp"
#include "console/reference/vocabulary.hpp"
#include "console/schema/object_type.hpp"
#include "console/scripts.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

constexpr std::array<std::string_view, 2> colours{"red", "green"};
constexpr std::array options{
    Option{.name = "file", .type = OptionType::text, .positional = true},
    Option{.name = "size", .unit = "m", .range = above(0.0), .required = true},
    Option{.name = "count", .type = OptionType::integer, .range = between(1.0, 9.0)},
    Option{.name = "film", .type = OptionType::flag},
    Option{.name = "place", .type = OptionType::point, .unit = "m"},
    Option{.name = "colour", .type = OptionType::choice, .choices = colours},
    Option{.name = "material", .type = OptionType::material, .read = read_material},
};
constexpr FunctionDoc thing{.name = "thing", .options = options, .example = "thing { size = 1*m }"};

class ArgumentsTest : public testing::Test {
 protected:
  ArgumentsTest() : session_(test::quiet()) {
    set_session(L, &session_);
    open_errors(L);
    open_units(L);
    open_type(L, type_name<Material>, material_type());
    open_type(L, type_name<Plate>, plate_type());
    luaL_openlibs(L);
    open_functions(L, all_functions());
  }

  // Pushes the value of an expression.
  void push(const std::string& expression) {
    ASSERT_EQ(luaL_loadstring(L, ("return " + expression).c_str()), LUA_OK);
    protected_call(L, 0, 1);
  }

  Arguments read(const std::string& expression) {
    push(expression);
    return Arguments::from_table(L, lua_gettop(L), thing);
  }

  std::string problems_of(const std::string& expression) {
    try {
      read(expression).problems.throw_if_any();
      return "";
    } catch (const Error& error) {
      return error.what();
    }
  }

  Session session_;
  LuaState L;
};

TEST_F(ArgumentsTest, ReadsEveryType) {
  const Arguments arguments = read(
      "{ 'a.mp4', size = 2*mm, count = 3.0, film = true, place = {1, 2*m}, colour = 'green', "
      "material = 'duran50' }");
  EXPECT_TRUE(arguments.problems.empty());
  EXPECT_EQ(arguments.text("file"), "a.mp4");
  EXPECT_DOUBLE_EQ(arguments.number("size"), 2e-3);
  EXPECT_EQ(arguments.integer("count"), 3);
  EXPECT_TRUE(arguments.flag("film"));
  EXPECT_EQ(arguments.point("place"), Vec2(1.0, 2.0));
  EXPECT_EQ(arguments.choice<int>("colour"), 1);
  EXPECT_EQ(arguments.text_of_choice("colour", "red"), "green");
  EXPECT_DOUBLE_EQ(arguments.get<Material>("material", {}).E, 65e9);
}

TEST_F(ArgumentsTest, WhatIsLeftOutReadsAsItsFallback) {
  const Arguments arguments = read("{ size = 1 }");
  EXPECT_FALSE(arguments.has("count"));
  EXPECT_EQ(arguments.integer("count", 7), 7);
  EXPECT_EQ(arguments.choice<int>("colour", 1), 1);
  EXPECT_EQ(arguments.text("file", "x"), "x");
}

TEST_F(ArgumentsTest, AnUnknownNameGetsTheNearestAndAll) {
  EXPECT_EQ(
      problems_of("{ size = 1, cuont = 3 }"),
      "thing: unknown option 'cuont' (did you mean 'count'? options: file, size, count, film, "
      "place, colour, material)");
}

TEST_F(ArgumentsTest, AWrongTypeSaysWhatWasGivenAndWhatIsExpected) {
  EXPECT_EQ(problems_of("{ size = '5' }"), "thing: size is the text '5', expected a number in m");
  EXPECT_EQ(problems_of("{ size = 1, film = 1 }"), "thing: film is 1, expected true or false");
  EXPECT_EQ(problems_of("{ size = 1, count = 2.5 }"),
            "thing: count is 2.5, expected a whole number");
  EXPECT_EQ(problems_of("{ size = 1, file = {} }"),
            "thing: file is a table, expected a text in quotes");
  EXPECT_EQ(problems_of("{ size = 1, place = print }"),
            "thing: place is a function, expected {x, y}, two numbers in m");
  EXPECT_EQ(problems_of("{ size = 1, material = plate{width=1,height=1,material='duran50'} }"),
            "thing: material is a plate, expected the name of a material, or material { ... }");
}

TEST_F(ArgumentsTest, ARangeNamesKeyValueBoundAndUnit) {
  EXPECT_EQ(problems_of("{ size = -5*mm }"), "thing: size is -5 mm, it must be above 0 m");
  EXPECT_EQ(problems_of("{ size = 1, count = 10 }"),
            "thing: count is 10, it must be between 1 and 9");
}

TEST_F(ArgumentsTest, NanAndInfinityAreRefused) {
  EXPECT_EQ(problems_of("{ size = 0/0 }"), "thing: size is nan, expected a finite number in m");
  EXPECT_EQ(problems_of("{ size = 1/0 }"), "thing: size is inf, expected a finite number in m");
  EXPECT_THAT(problems_of("{ size = 1, place = {0, 0/0} }"), HasSubstr("place is {0, nan}"));
}

TEST_F(ArgumentsTest, APointIsTwoNumbersAndNothingElse) {
  for (const char* bad : {"{}", "{1}", "{1, 2, 3}", "{1, '2'}", "{x = 1, y = 2}", "{1, 2, z = 3}"})
    EXPECT_THAT(problems_of(std::string("{ size = 1, place = ") + bad + " }"),
                HasSubstr("place is not a pair of numbers"))
        << bad;
}

TEST_F(ArgumentsTest, AChoiceNamesTheNearestAndAll) {
  EXPECT_EQ(problems_of("{ size = 1, colour = 'gren' }"),
            "thing: colour is 'gren' (did you mean 'green'?), expected one of red, green");
}

TEST_F(ArgumentsTest, AMissingValueIsNamed) {
  EXPECT_EQ(problems_of("{}"), "thing: size is missing (a number in m)");
}

TEST_F(ArgumentsTest, AllProblemsComeTogether) {
  const std::string text = problems_of("{ count = 0, film = 'yes', hue = 1, 'a', 'b' }");
  for (const char* part : {"size is missing", "count is 0", "film is the text 'yes'",
                           "unknown option 'hue'", "the text 'b' stands in the braces"})
    EXPECT_THAT(text, HasSubstr(part));
}

TEST_F(ArgumentsTest, ATextStandsForThePositionalOptionAlone) {
  EXPECT_EQ(problems_of("'a.mp4'"), "thing: size is missing (a number in m)");
  EXPECT_EQ(problems_of("{ 'a', file = 'b', size = 1 }"), "thing: file is given twice");
}

TEST_F(ArgumentsTest, WhatIsNoTableIsExplained) {
  EXPECT_EQ(problems_of("7"),
            "thing: expected options in braces, got 7 (as in thing { size = 1*m })");
  EXPECT_THAT(problems_of("nil"), HasSubstr("got nothing"));
}

TEST_F(ArgumentsTest, ValuesAreCheckedInOrder) {
  static constexpr std::array values{Option{.name = "a", .required = true},
                                     Option{.name = "b", .type = OptionType::integer}};
  static constexpr FunctionDoc f{.name = "f", .call = Call::values, .options = values};
  push("1.5");
  push("2");
  EXPECT_EQ(Arguments::from_values(L, 1, f).integer("b"), 2);
  push("3");
  EXPECT_FALSE(Arguments::from_values(L, 1, f).problems.empty());
  lua_settop(L, 0);
  EXPECT_FALSE(Arguments::from_values(L, 1, f).problems.empty());
}

// Passes random values and names to every schema: nothing may crash, and accepted values must
// satisfy the schema.
class Fuzz {
 public:
  Fuzz(lua_State* L, unsigned seed) : L_(L), random_(seed) {}

  int below(int limit) { return std::uniform_int_distribution<int>(0, limit - 1)(random_); }

  void push_text() {
    static constexpr std::array texts{"",      "duran50", "top",       "broken",   "damage", "full",
                                      "a.mp4", "lattice", "no\0thing", "\xff\xfe", "%s%n"};
    lua_pushstring(L_, texts[static_cast<std::size_t>(below(texts.size()))]);
  }

  void push_number() {
    static constexpr std::array numbers{0.0,
                                        -1.0,
                                        1.0,
                                        0.5,
                                        1e-3,
                                        1e308,
                                        -1e308,
                                        1e-308,
                                        640.0,
                                        1e19,
                                        std::numeric_limits<double>::infinity(),
                                        std::numeric_limits<double>::quiet_NaN()};
    lua_pushnumber(L_, numbers[static_cast<std::size_t>(below(numbers.size()))]);
  }

  void push_table(int depth) {
    lua_newtable(L_);
    for (int i = below(4); i > 0; --i) {
      push_value(depth + 1);
      lua_rawseti(L_, -2, below(4));
    }
  }

  void push_value(int depth = 0) {
    switch (below(depth > 3 ? 5 : 9)) {
      case 0:
        return lua_pushnil(L_);
      case 1:
        return lua_pushboolean(L_, below(2));
      case 2:
        return push_number();
      case 3:
        return lua_pushinteger(L_, below(2000) - 1000);
      case 4:
        return push_text();
      case 5:
        return push_table(depth);
      case 6:
        return lua_pushcfunction(L_, lua_error);
      case 7:
        lua_newthread(L_);
        return;
      default:
        lua_newuserdatauv(L_, 8, 1);
    }
  }

  void push_name(const FunctionDoc& doc) {
    if (doc.options.empty() || below(8) == 0) return push_value_as_key();
    std::string name(
        doc.options[static_cast<std::size_t>(below(static_cast<int>(doc.options.size())))].name);
    if (below(6) == 0) name[0] = static_cast<char>(below(256));
    lua_pushlstring(L_, name.data(), name.size());
  }

  // Neither nil nor nan may be a key.
  void push_value_as_key() {
    push_value();
    const bool nan = lua_type(L_, -1) == LUA_TNUMBER && std::isnan(lua_tonumber(L_, -1));
    if (!lua_isnil(L_, -1) && !nan) return;
    lua_pop(L_, 1);
    lua_pushinteger(L_, below(4));
  }

  void push_arguments(const FunctionDoc& doc) {
    if (below(20) == 0) return push_value();
    lua_newtable(L_);
    for (int i = below(10); i > 0; --i) {
      push_name(doc);
      push_value();
      lua_rawset(L_, -3);
    }
  }

 private:
  lua_State* L_;
  std::mt19937 random_;
};

void expect_promises_kept(const FunctionDoc& doc, const Arguments& arguments) {
  for (const Option& option : doc.options) {
    const bool needed = option.required && (option.unless.empty() || !arguments.has(option.unless));
    EXPECT_TRUE(arguments.has(option.name) || !needed) << doc.name << option.name;
    if (!arguments.has(option.name)) continue;
    if (option.type == OptionType::number) {
      EXPECT_TRUE(std::isfinite(arguments.number(option.name)));
      EXPECT_TRUE(option.range.holds(arguments.number(option.name)));
    } else if (option.type == OptionType::point) {
      EXPECT_TRUE(arguments.point(option.name).allFinite());
    } else if (option.type == OptionType::text) {
      EXPECT_NE(arguments.text(option.name), "");
    }
  }
}

const FunctionDoc& doc_named(std::string_view name) {
  for (const Function& function : all_functions())
    if (function.doc->name == name) return *function.doc;
  for (const Function& method : plate_type().methods)
    if (method.doc->name == name) return *method.doc;
  throw std::out_of_range(std::string(name));
}

TEST_F(ArgumentsTest, RandomValuesNeverCrashAndNeverSlipThrough) {
  Fuzz fuzz(L, 20100);
  std::vector<const FunctionDoc*> docs{&thing};
  for (const Function& function : all_functions()) docs.push_back(function.doc);
  for (const TypeDoc* type : all_types())
    for (const Function& method : type->methods) docs.push_back(method.doc);
  int accepted = 0;
  for (int round = 0; round < 2000; ++round)
    for (const FunctionDoc* each : docs) {
      lua_settop(L, 0);
      fuzz.push_arguments(*each);
      try {
        const Arguments arguments = each->call == Call::values ? Arguments::from_values(L, 1, *each)
                                                               : Arguments::from_table(L, 1, *each);
        if (!arguments.problems.empty()) continue;
        ++accepted;
        expect_promises_kept(*each, arguments);
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::refused) << error.what();
      }
    }
  EXPECT_GT(accepted, 100);  // otherwise the fuzz would test only refusals
}

TEST_F(ArgumentsTest, BoundFunctionsSurviveRandomCalls) {
  Fuzz fuzz(L, 1915);
  const std::string make = "plate { width = 1, height = 1, material = 'duran50' }";
  for (int round = 0; round < 2000; ++round)
    for (const char* name : {"plate", "material", "options", "crack", "traction", "nofail"}) {
      lua_settop(L, 0);
      if (lua_getglobal(L, name) == LUA_TNIL) {
        lua_pop(L, 1);
        push(make);
        lua_getfield(L, -1, name);
        lua_insert(L, -2);
      }
      fuzz.push_arguments(doc_named(name));
      try {
        protected_call(L, lua_gettop(L) - 1, 0);
      } catch (const Error& error) {
        EXPECT_THAT(error.kind(), testing::AnyOf(ErrorKind::refused, ErrorKind::script));
        EXPECT_STRNE(error.what(), "");
      }
    }
}

}  // namespace
}  // namespace hackle
