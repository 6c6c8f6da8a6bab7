// SPDX-License-Identifier: MIT
#include "console/help_binding.hpp"

#include <gmock/gmock.h>

#include "console/reference.hpp"
#include "console/scripts.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

// What help prints.
std::string printed(const std::string& call) {
  Console console(test::quiet());
  console.evaluate("shown = ''; print = function(text) shown = text end");
  console.evaluate(call);
  return console.evaluate("shown").at(0);
}

TEST(Help, AloneListsEverything) {
  const std::string text = printed("help()");
  for (const Function& function : all_functions())
    EXPECT_THAT(text, HasSubstr(signature(*function.doc)));
  for (const TypeDoc* type : all_types())
    for (const Function& method : type->methods)
      EXPECT_THAT(text, HasSubstr(std::string(method.doc->sentence)));
}

TEST(Help, OnAFunctionShowsItsOptionsAndExample) {
  const std::string text = printed("help \"movie\"");
  EXPECT_THAT(text, HasSubstr("s:movie { file, field, every, zoom, width, fps }"));
  EXPECT_THAT(text,
              testing::ContainsRegex("width +integer +between 320 and 7680 px +default 1280"));
  EXPECT_THAT(text, HasSubstr("example: s:movie {"));
}

TEST(Help, TakesFunctionsAndObjectsToo) {
  const std::string make = "p = plate { width = 1, height = 1, material = 'duran50' }";
  EXPECT_EQ(printed("help(simulate)"), printed("help 'simulate'"));
  EXPECT_EQ(printed(make + " help(p.crack)"), printed("help 'crack'"));
  EXPECT_THAT(printed(make + " help(p)"), HasSubstr("p:traction { edge, stress, depth, time }"));
}

TEST(Help, OnSomethingUnknownSuggests) {
  EXPECT_THAT(test::message_of("help 'crak'"), HasSubstr("(did you mean 'crack'?)"));
  EXPECT_THAT(test::message_of("help(print)"), HasSubstr("not one of Hackle's"));
}

}  // namespace
}  // namespace hackle
