// SPDX-License-Identifier: MIT
#include "console/schema/schema.hpp"

#include <algorithm>
#include <cstdlib>
#include <set>

#include <gmock/gmock.h>

#include "console/language/picture_options.hpp"
#include "console/reference/see_also.hpp"
#include "console/reference/vocabulary.hpp"
#include "console/scripts.hpp"

namespace hackle {
namespace {

bool is_sentence(std::string_view text) {
  return text.size() > 4 && text.ends_with('.') &&
         std::isupper(static_cast<unsigned char>(text[0]));
}

TEST(Schema, EveryFunctionAndOptionHasASentence) {
  for (const FunctionDoc* doc : all_docs()) {
    EXPECT_TRUE(is_sentence(doc->sentence)) << doc->name;
    for (const Option& option : doc->options)
      EXPECT_TRUE(is_sentence(option.sentence)) << doc->name << ", " << option.name;
  }
}

TEST(Schema, EveryFieldAndTypeIsExplained) {
  for (const TypeDoc* type : all_types()) {
    EXPECT_TRUE(is_sentence(type->sentence)) << type->name;
    for (const Property& field : type->fields) {
      EXPECT_TRUE(field.sentence.ends_with('.')) << field.name;
      EXPECT_NE(field.push, nullptr) << field.name;
    }
  }
}

TEST(Schema, NamesOfOptionsDifferAndChoicesAreNotEmpty) {
  for (const FunctionDoc* doc : all_docs()) {
    std::set<std::string_view> names;
    for (const Option& option : doc->options) {
      EXPECT_TRUE(names.insert(option.name).second) << doc->name << ", " << option.name;
      EXPECT_EQ(option.type == OptionType::choice, !option.choices.empty()) << option.name;
    }
  }
}

TEST(Schema, WhatIsNotRequiredSaysItsDefaultOrIsOneWayOfSeveral) {
  for (const FunctionDoc* doc : all_docs())
    for (const Option& option : doc->options) {
      const int said =
          int{option.required} + int{!option.fallback.empty()} + int{option.alternative};
      EXPECT_EQ(said, 1) << doc->name << ", " << option.name;
    }
}

TEST(Schema, EveryExampleRuns) {
  const test::Folder folder;
  for (const FunctionDoc* doc : all_docs()) {
    if (doc->name.starts_with("study.")) continue;  // they need the program: tests/app
    EXPECT_EQ(
        test::message_of(test::scene + test::recorded + "s = simulate(p, { spacing = 0.5*mm })\n" +
                             std::string(doc->example),
                         test::quiet(folder.path)),
        "")
        << doc->name;
  }
}

TEST(Schema, EveryUnitIsOneThatIsUsed) {
  const std::set<std::string_view> known{"",     "m",     "s",     "Pa",   "N/m3", "m/s", "K",
                                         "1/K",  "kg/m3", "kg/m",  "N/m",  "1/s",  "px",  "pt",
                                         "J/m2", "rad",   "steps", "N/m6", "N/m4"};
  for (const FunctionDoc* doc : all_docs())
    for (const Option& option : doc->options)
      EXPECT_TRUE(known.contains(option.unit)) << doc->name << ", " << option.name;
}

TEST(Schema, EveryRangeHoldsSomethingAndTheDefaultToo) {
  for (const FunctionDoc* doc : all_docs())
    for (const Option& option : doc->options) {
      EXPECT_LT(option.range.min, option.range.max) << doc->name << ", " << option.name;
      const std::string text(option.fallback);
      char* end = nullptr;
      const double value = std::strtod(text.c_str(), &end);
      const bool number = !text.empty() && *end == '\0';
      EXPECT_TRUE(!number || option.range.holds(value)) << doc->name << ", " << option.name;
      const bool depends = option.fallback == suits_the_field || option.fallback == suits_the_theme;
      const bool choice = option.type == OptionType::choice && !text.empty() && !depends;
      EXPECT_TRUE(!choice || std::ranges::count(option.choices, text) == 1)
          << doc->name << ", " << option.name;
    }
}

TEST(Schema, EveryTypeThatTheCheckerDoesNotKnowHasItsOwnReader) {
  const std::set<OptionType> own{OptionType::markers, OptionType::recordings, OptionType::material,
                                 OptionType::areas, OptionType::reading};
  for (const FunctionDoc* doc : all_docs())
    for (const Option& option : doc->options)
      EXPECT_TRUE(option.read != nullptr || !own.contains(option.type))
          << doc->name << ", " << option.name;
}

TEST(Schema, EveryFunctionHasNeighboursThatExist) {
  std::set<std::string_view> names;
  for (const FunctionDoc* doc : all_docs()) names.insert(doc->name);
  for (const FunctionDoc* doc : all_docs()) {
    EXPECT_FALSE(see_also(doc->name).empty()) << doc->name;
    for (const std::string_view name : see_also(doc->name))
      EXPECT_TRUE(names.contains(name)) << doc->name << ": " << name;
  }
}

TEST(Schema, SignaturesReadAsCalls) {
  const Option file{.name = "file"}, every{.name = "every"};
  const std::array options{file, every};
  EXPECT_EQ(signature({.name = "movie", .owner = "s", .options = options}),
            "s:movie { file, every }");
  EXPECT_EQ(signature({.name = "f", .leading = "p", .options = options}), "f(p, { file, every })");
  EXPECT_EQ(signature({.name = "run", .owner = "s", .call = Call::values, .options = options}),
            "s:run(file, every)");
}

TEST(Schema, RangesSayWhetherTheirEndsBelong) {
  EXPECT_EQ(range_text({.name = "x", .unit = "m", .range = above(0.0)}), "above 0 m");
  EXPECT_EQ(range_text({.name = "x", .range = at_least(1.0)}), "at least 1");
  EXPECT_EQ(range_text({.name = "x", .unit = "px", .range = between(2.0, 8.0)}),
            "between 2 and 8 px");
  EXPECT_FALSE(above(0.0).holds(0.0));
  EXPECT_TRUE(at_least(0.0).holds(0.0));
}

}  // namespace
}  // namespace hackle
