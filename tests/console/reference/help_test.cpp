// SPDX-License-Identifier: MIT
#include "console/reference/help.hpp"

#include <regex>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "console/reference/reference.hpp"
#include "console/reference/search.hpp"
#include "console/reference/tour.hpp"
#include "console/reference/vocabulary.hpp"
#include "console/scripts.hpp"
#include "measure/scalar.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

// Returns the output of help.
std::string printed(const std::string& call) {
  Console console(test::quiet());
  console.evaluate("shown = ''; print = function(text) shown = text end");
  console.evaluate(call);
  return console.evaluate("shown").at(0);
}

TEST(Help, ListsTheSpecimensThatAreInstalled) {
  const std::string text = printed("help 'specimens'");
  EXPECT_THAT(text, HasSubstr("require \"specimens.compact_tension\""));
  EXPECT_THAT(text, HasSubstr("\n  dog_bone           the dumbbell for tension"));
  EXPECT_THAT(text, testing::Not(HasSubstr("\n  parts ")));
}

TEST(Help, AloneIsATourThatRuns) {
  const std::string text = printed("help()");
  const test::Folder folder;
  Console console(test::quiet(folder.path));
  console.evaluate("print = function() end");
  for (const std::string_view line : tour_lines()) {
    EXPECT_THAT(text, HasSubstr("\n  " + std::string(line)));
    EXPECT_NO_THROW(console.evaluate(std::string(line))) << line;
  }
  EXPECT_TRUE(std::filesystem::exists(folder.path / "crack.png"));
}

TEST(Help, FitsAnyTerminal) {
  std::vector<std::string> calls{"help()", "help 'functions'", "help 'units'", "help 'materials'",
                                 "help 'fields'"};
  for (const FunctionDoc* doc : all_docs()) calls.push_back(fmt::format("help '{}'", doc->name));
  for (const std::string& call : calls) {
    std::istringstream lines(printed(call));
    for (std::string line; std::getline(lines, line);) {
      const bool code = line.find('"') != std::string::npos;  // examples are not wrapped
      EXPECT_TRUE(code || line.size() <= reference_width) << call << ": " << line;
    }
  }
}

TEST(Help, ListsEveryFunction) {
  const std::string text = printed("help 'functions'");
  for (const FunctionDoc* doc : all_docs())
    EXPECT_THAT(text, HasSubstr("  " + call_name(*doc) + " "));
}

TEST(Help, ListsEveryFieldOfPicturesAndTellsOfEach) {
  const std::string list = printed("help 'fields'");
  for (const Scalar& scalar : scalars()) {
    EXPECT_THAT(list, HasSubstr(fmt::format("\n  {} ", scalar.name)));
    const std::string page = printed(fmt::format("help '{}'", scalar.name));
    EXPECT_THAT(std::regex_replace(page, std::regex("\n +"), " "), HasSubstr(scalar.sentence));
  }
}

TEST(Help, OnAFunctionShowsItsOptionsExampleAndNeighbours) {
  const std::string text = printed("help \"movie\"");
  EXPECT_THAT(text, HasSubstr("s:movie { file, every, fps, profile, crf, hold, fallback,"));
  EXPECT_THAT(text,
              testing::ContainsRegex("width +integer +between 320 and 7680 px; default 1280"));
  EXPECT_THAT(text, HasSubstr("\nexample:\n  s:movie {"));
  EXPECT_THAT(text, HasSubstr("\nsee also: frame, record"));
}

TEST(Help, TakesFunctionsAndObjectsToo) {
  const std::string make = "p = plate { width = 1, height = 1, material = 'duran50' }";
  EXPECT_EQ(printed("help(simulate)"), printed("help 'simulate'"));
  EXPECT_THAT(printed(make + " help(p.notch)"), HasSubstr("p:notch { at, "));
  EXPECT_THAT(printed(make + " help(p)"), HasSubstr("plate: A plate with its cracks"));
  EXPECT_THAT(printed(make + " help(p)"), testing::ContainsRegex("p:traction +Pulls"));
  EXPECT_THAT(printed(make + " help(simulate(p, { spacing = 0.1 }))"), HasSubstr("s.energy"));
}

TEST(Help, OnAnOptionNamesTheFunctionsThatTakeIt) {
  EXPECT_THAT(printed("help 'horizon'"), HasSubstr("horizon, an option of simulate\n"));
  EXPECT_THAT(printed("help 'fps'"),
              HasSubstr("fps, an option of side_by_side, s:movie, r:movie\n"));
  EXPECT_THAT(printed("help 'edge'"), HasSubstr("an option of p:traction, s:traction\n"));
}

TEST(Help, KnowsWhatIsBothAFunctionAndAnOption) {
  const std::string text = printed("help 'pressure'");
  EXPECT_THAT(text, HasSubstr("p:pressure { rim"));
  EXPECT_THAT(text, HasSubstr("between two runs: s:pressure"));
  EXPECT_THAT(text, HasSubstr("an option of: p:pressure, s:pressure"));
}

TEST(Help, KnowsEveryTopic) {
  for (const std::string& topic : topics()) EXPECT_NE(printed("help '" + topic + "'"), "") << topic;
}

TEST(Help, ListsUnitsAndMaterials) {
  EXPECT_THAT(printed("help 'units'"), HasSubstr("stress  Pa, kPa, MPa, GPa"));
  EXPECT_THAT(printed("help 'MPa'"), HasSubstr("a unit of stress"));
  EXPECT_THAT(printed("help 'materials'"), testing::ContainsRegex("duran50 +Duran 50 glass"));
}

TEST(Help, SearchesForWordsThatAreNoNames) {
  EXPECT_THAT(printed("help 'restart'"), HasSubstr("\n  s:rewind "));
  EXPECT_THAT(printed("help 'csv'"), HasSubstr("\n  points (option) "));
  EXPECT_THAT(printed("help 'Rayleigh SPEED'"), HasSubstr("\n  s.c_R "));
  EXPECT_THAT(printed("help 'critical stretch'"), HasSubstr("\n  s.s0 "));
  EXPECT_THAT(test::message_of("help 'rayleigh zebra'"), HasSubstr("nothing is known of"));
  EXPECT_THAT(test::message_of("help ''"), HasSubstr("nothing is known of"));
  EXPECT_THAT(test::message_of("help '%'"), HasSubstr("nothing is known of"));
}

// Other words lead to a name that there is: who renames one must rename it there too.
TEST(Help, SearchKnowsOtherWords) {
  struct Other {
    const char *name, *word;
  };
  for (const Other& other : {Other{"plate", "sheet"},        Other{"crack", "precrack"},
                             Other{"notch", "slot"},         Other{"hole", "cavity"},
                             Other{"mask", "image"},         Other{"keep", "outline"},
                             Other{"points", "csv"},         Other{"inclusion", "fibre"},
                             Other{"traction", "force"},     Other{"clamp", "fix"},
                             Other{"move", "displacement"},  Other{"temperature", "thermal"},
                             Other{"foundation", "spring"},  Other{"impactor", "projectile"},
                             Other{"damping", "viscous"},    Other{"absorb", "nonreflecting"},
                             Other{"contact", "collision"},  Other{"roller", "bending"},
                             Other{"platen", "compression"}, Other{"grade", "gradient"},
                             Other{"simulate", "mesh"},      Other{"spacing", "mesh"},
                             Other{"horizon", "delta"},      Other{"fidelity", "speed"},
                             Other{"precision", "float"},    Other{"relax", "static"},
                             Other{"quasistatic", "static"}, Other{"movie", "film"},
                             Other{"frame", "picture"},      Other{"record", "save"},
                             Other{"recording", "load"},     Other{"fork", "copy"},
                             Other{"rewind", "restart"},     Other{"script", "save"},
                             Other{"report", "summary"},     Other{"cracks", "tip"},
                             Other{"at", "probe"},           Other{"on", "callback"},
                             Other{"options", "parameters"}, Other{"strength", "scatter"},
                             Other{"help", "manual"},        Other{"c_R", "velocity"}})
    EXPECT_THAT(search_reference(other.word),
                testing::ContainsRegex(fmt::format("[ :.]{} ", other.name)))
        << other.word;
}

TEST(Help, SearchSaysHowMuchMoreThereIs) {
  EXPECT_THAT(printed("help 'a'"), testing::ContainsRegex("\n  and [0-9]+ more$"));
}

TEST(Help, OnSomethingUnknownSuggests) {
  EXPECT_THAT(test::message_of("help 'crak'"), HasSubstr("(did you mean 'crack'?)"));
  EXPECT_THAT(test::message_of("help 'horzon'"), HasSubstr("(did you mean 'horizon'?)"));
  EXPECT_THAT(test::message_of("help(print)"), HasSubstr("not one of Hackle's"));
  EXPECT_THAT(test::message_of("help(5)"), HasSubstr("nothing is known of"));
}

}  // namespace
}  // namespace hackle
