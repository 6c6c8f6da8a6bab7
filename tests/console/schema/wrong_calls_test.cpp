// SPDX-License-Identifier: MIT
// Calls that are wrong as a whole, of every function and method: wrong objects, wrong numbers of
// values, closed objects, numbers of another magnitude. bad_values_test.cpp tests values of single
// options.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "console/reference/vocabulary.hpp"
#include "console/scripts.hpp"

namespace hackle {
namespace {

using testing::AnyOf;
using testing::HasSubstr;

// A console with p, s and r, and the calls tried in it.
class WrongCalls : public testing::Test {
 protected:
  WrongCalls() : console_(test::quiet(folder_.path)) {
    console_.evaluate(test::scene + test::recorded);
  }

  // Returns the message, which must be an Error with the name of the call.
  std::string refusal(const std::string& call, std::string_view name) {
    ++tried_;
    try {
      console_.evaluate(call);
      ADD_FAILURE() << call << " is taken";
    } catch (const Error& error) {
      EXPECT_THAT(error.kind(), AnyOf(ErrorKind::refused, ErrorKind::script)) << call;
      EXPECT_THAT(error.what(), HasSubstr(std::string(name))) << call;
      for (const Problem& problem : error.problems())
        EXPECT_FALSE(problem.remedy.empty()) << call << ": " << problem.what;
      return error.what();
    }
    return "";
  }

  // Expects the simulation unchanged after all calls, and nothing written beside the recording.
  void expect_untouched() {
    EXPECT_EQ(console_.evaluate("s.time == 0 and s.damage.broken_bonds == 0").at(0), "true");
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path))
      EXPECT_THAT(entry.path().filename().string(), HasSubstr("r."));
  }

  const test::Folder folder_;
  Console console_;
  int tried_ = 0;
};

std::string method_of(const FunctionDoc& doc) {
  return std::string(doc.owner) + "." + std::string(doc.name);
}

TEST_F(WrongCalls, MethodsOnWhatIsNotTheirObject) {
  for (const FunctionDoc* doc : all_docs()) {
    if (doc->owner.empty()) continue;
    for (const char* self :
         {"", "{}", "nil", "5", "'p'", "true", "print", "io.stdout", "p", "s", "r",
          "material { like = 'duran50', name = 'm' }", "coroutine.create(print)"}) {
      if (self == doc->owner) continue;
      const std::string message = refusal(fmt::format("{}({})", method_of(*doc), self), doc->name);
      EXPECT_THAT(message, HasSubstr("it is called with a colon")) << message;
    }
  }
  expect_untouched();
  EXPECT_GE(tried_, 300);
}

TEST_F(WrongCalls, ValuesTooMany) {
  for (const FunctionDoc* doc : all_docs()) {
    if (doc->call == Call::free) continue;
    const std::string who =
        (doc->owner.empty() ? "" : std::string(doc->owner) + ":") + std::string(doc->name);
    std::string given = std::string(doc->leading);
    if (doc->name == "options" || doc->name == "rewind") continue;
    for (std::size_t k = 0; k < (doc->call == Call::values ? doc->options.size() : 1); ++k)
      given += std::string(given.empty() ? "" : ", ") + (doc->call == Call::values ? "nil" : "{}");
    for (const char* more : {"5", "'x'", "{}", "p", "print"})
      EXPECT_THAT(refusal(fmt::format("{}({}{}{})", who, given, given.empty() ? "" : ", ", more),
                          doc->name),
                  HasSubstr("is one value too many"))
          << who;
  }
  expect_untouched();
  EXPECT_GE(tried_, 200);
}

TEST_F(WrongCalls, WhatStandsInsteadOfTheBraces) {
  for (const FunctionDoc* doc : all_docs()) {
    if (doc->call != Call::options || doc->options.empty()) continue;
    const std::string who =
        (doc->owner.empty() ? "" : std::string(doc->owner) + ":") + std::string(doc->name);
    const std::string leading = doc->leading.empty() ? "" : std::string(doc->leading) + ", ";
    for (const std::string instead : {"5", "true", "print", "p", "s", "0/0", "io.stdout"})
      if (who != "load" || instead != "print")  // a function gives it pieces of Lua
        refusal(fmt::format("{}({}{})", who, leading, instead), doc->name);
  }
  expect_untouched();
  EXPECT_GE(tried_, 150);
}

TEST_F(WrongCalls, NamesThatNothingHas) {
  for (const TypeDoc* type : all_types()) {
    const char* object = type->name == "plate"        ? "p"
                         : type->name == "simulation" ? "s"
                         : type->name == "recording"  ? "r"
                                                      : nullptr;
    if (object == nullptr) continue;
    for (const Function& method : type->methods) {
      std::string wrong(method.doc->name);
      wrong += "_x";
      EXPECT_THAT(refusal(fmt::format("{}:{} {{}}", object, wrong), wrong),
                  HasSubstr(fmt::format("{} has no '{}'", type->name, wrong)));
      refusal(fmt::format("{}.{} = 5", object, method.doc->name), type->name);
    }
    for (const char* key : {"[5]", "[true]", "[{}]", "[print]", "[0/0]", "[p]", "['']", "['\\0']"})
      refusal(fmt::format("return {}{}", object, key), type->name);
  }
  expect_untouched();
  EXPECT_GE(tried_, 100);
}

// Sizes far beyond any plate, and forgotten units: refused, or accepted and correct, but never a
// crash, a hang or nan. Functions that paint, make movies or solve at once are left out.
bool is_quick(const FunctionDoc& doc) {
  for (const char* slow : {"movie", "record", "side_by_side", "contact_sheet", "show", "watch",
                           "frame", "quasistatic", "relax"})
    if (doc.name == slow) return false;
  return doc.call == Call::options;
}

TEST(Magnitudes, AreRefusedOrRight) {
  const test::Folder folder;
  int tried = 0;
  for (const FunctionDoc* doc : all_docs()) {
    if (!is_quick(*doc)) continue;
    Console console(test::quiet(folder.path));
    const std::string who =
        (doc->owner.empty() ? "" : std::string(doc->owner) + ":") + std::string(doc->name);
    const std::string leading = doc->leading.empty() ? "" : std::string(doc->leading) + ", ";
    for (const Option& option : doc->options) {
      if (option.type != OptionType::number) continue;
      for (const char* value :
           {"1e-320", "1e-200", "1e-30", "1e-9", "1e9", "1e200", "1.7e308", "-1e-320", "-1e30"}) {
        ++tried;
        console.evaluate(test::scene);
        if (doc->owner == "r") console.evaluate(test::recorded);
        if (doc->owner == "v") console.evaluate("v = s:values 'damage'");
        try {
          console.evaluate(fmt::format("{}({}{{ {} = {} }})", who, leading, option.name, value));
        } catch (const Error& error) {
          EXPECT_THAT(error.kind(), AnyOf(ErrorKind::refused, ErrorKind::script))
              << who << " " << option.name << " = " << value << ": " << error.what();
          EXPECT_THAT(error.what(), HasSubstr(std::string(doc->name)));
        }
        EXPECT_EQ(console.evaluate("s.energy.strain == s.energy.strain").at(0), "true");
      }
    }
  }
  EXPECT_GE(tried, 300);
}

TEST(ClosedObjects, AreRefusedByName) {
  const test::Folder folder;
  Console console(test::quiet(folder.path));
  console.evaluate(test::scene + "s:record { 'c.h5', every = 1*us } s:run(1*us) s:close()");
  for (const char* call :
       {"s:run(1*us)", "s:step(1)", "s:relax {}", "s:quasistatic { duration = 1*us }",
        "s:start(1*us)", "s:record { 'd.h5', every = 1*us }",
        "s:movie { 'd.mp4', every = 1*us }"}) {
    try {
      console.evaluate(call);
      ADD_FAILURE() << call << " is taken";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::refused) << call;
      EXPECT_THAT(error.what(), HasSubstr("closed")) << call;
    }
  }
}

}  // namespace
}  // namespace hackle
