// SPDX-License-Identifier: MIT
#include "console/prompt/completion.hpp"

#include <set>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "base/files.hpp"
#include "console/reference/vocabulary.hpp"
#include "console/scripts.hpp"

namespace hackle {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::vector<std::string> texts_of(const Completion& completion) {
  std::vector<std::string> texts;
  for (const Candidate& candidate : completion.candidates) texts.push_back(candidate.text);
  return texts;
}

class CompletionTest : public testing::Test {
 protected:
  CompletionTest() {
    console_.evaluate(test::scene + test::recorded);
    console_.evaluate(R"(
      t = { alpha = 1, beta = print, ["not a name"] = 2, inner = { gamma = 3 } }
      word = "text"
      called = 0
      local spy = function() called = called + 1 return {} end
      trap = setmetatable({ own = 1 }, { __index = spy, __len = spy, __pairs = spy, __call = spy })
      child = setmetatable({ own = 1 }, { __index = { inherited = 1 } })
      ring = {} setmetatable(ring, { __index = ring })
      mt = getmetatable(ring) mt.__index = setmetatable({ a = 1 }, mt)
      sim = simulate
      simulate_twice = function() end)");
  }

  std::vector<std::string> offered(const std::string& text) {
    return texts_of(console_.complete(text));
  }
  std::string completed(const std::string& text) {
    return text + console_.complete(text).insertion();
  }

  test::Folder folder_;
  Console console_{test::quiet(folder_.path)};
};

struct Row {
  const char* typed;
  const char* completed;  // by one Tab
};

TEST_F(CompletionTest, WhatIsCertainIsAdded) {
  for (const Row& row : std::vector<Row>{
           {"pla", "plate { "},
           {"x = simulate_", "x = simulate_twice("},
           {"func", "function"},
           {"print(t.al", "print(t.alpha"},
           {"t.inner.g", "t.inner.gamma"},
           {"p:cr", "p:crack { "},
           {"p:tr", "p:traction { "},
           {"s:ru", "s:run("},
           {"s:rep", "s:report()"},
           {"s.dt_", "s.dt_limit"},
           {"s.energy.ki", "s.energy.kinetic"},
           {"s.damage.br", "s.damage.broken_bonds"},
           {"help(p.cra", "help(p.crack"},
           {"word:up", "word:upper("},
           {"string.fo", "string.format("},
           {"child.inh", "child.inherited"},
           {"plate { wi", "plate { width = "},
           {"plate{wi", "plate{width = "},
           {"plate { width = 1, h", "plate { width = 1, height = "},
           {"p:crack { bo", "p:crack { born = "},
           {"p:crack { from = {0, 0}; t", "p:crack { from = {0, 0}; to = "},
           {"simulate(p, { ho", "simulate(p, { horizon = "},
           {"sim(p, { ho", "sim(p, { horizon = "},
           {"s:movie { 'a.mp4', fi", "s:movie { 'a.mp4', field = "},
           {"s:frame { field = \"da", "s:frame { field = \"damage\""},
           {"p:crack { born = 'a", "p:crack { born = 'absent'"},
           {"plate { material = \"du", "plate { material = \"duran50\""},
           {"material \"du", "material \"duran50\""},
           {"material('du", "material('duran50'"},
           {"help \"random", "help \"random_cracks\""},
           {"help 'hori", "help 'horizon'"},
           {"s:on { \"ev", "s:on { \"every\""},
           {"plate {\n  width = 100*mm,\n  he", "plate {\n  width = 100*mm,\n  height = "},
           {"local f = function()\n  p:cra", "local f = function()\n  p:crack { "},
           {"local q = plate {}\nq:nofa", "local q = plate {}\nq:nofail { "},
           {"local grade = 1 print(gra", "local grade = 1 print(grade"},
           {"p:crack { from = {0, 0} }:nof", "p:crack { from = {0, 0} }:nofail { "},
           {"p:clamp { edge = \"left\" }:move { vel",
            "p:clamp { edge = \"left\" }:move { velocity = "},
       })
    EXPECT_EQ(completed(row.typed), row.completed);
}

TEST_F(CompletionTest, WithoutAChoiceNothingIsAddedBeyondWhatIsCommon) {
  EXPECT_EQ(completed("p:t"), "p:t");  // traction, temperature
  EXPECT_THAT(offered("p:t"), ElementsAre("temperature", "traction"));
  EXPECT_EQ(completed("p:no"), "p:no");
  EXPECT_THAT(offered("p:no"), ElementsAre("nofail", "notch"));
  EXPECT_EQ(completed("plate { material = \"soda"), "plate { material = \"soda_lime");
}

TEST_F(CompletionTest, NothingIsOfferedWhereNothingIsKnown) {
  for (const char* text :
       {"zzz", "zzz.", "zzz:x", "t.zzz.", "t:al", "p.zzz", "-- p:cr", "--[[ p:cr", "[[ p:cr", "5",
        "0x1", "x = 3.", "help \"zzz", "plate { material = \"zzz", "nil.", "\"a\"..z_"})
    EXPECT_THAT(offered(text), IsEmpty()) << text;
}

TEST_F(CompletionTest, OptionsThatAreGivenAreLeftOut) {
  EXPECT_THAT(offered("plate { "), ElementsAre("height", "material", "outline", "plane", "width"));
  EXPECT_THAT(offered("plate { width = f(1, {a = 2}), "),
              ElementsAre("height", "material", "outline", "plane"));
  EXPECT_THAT(offered("s:movie { \"a.mp4\", "),
              AllOf(Contains("every"), Contains("title"), Contains("zoom"), Not(Contains("file"))));
  EXPECT_THAT(offered("s:movie { "), Contains("file"));
}

TEST_F(CompletionTest, OptionsAreOfferedOnlyWhereTheirNameMayStand) {
  EXPECT_THAT(offered("plate { width = wi"), Not(Contains("width")));
  EXPECT_THAT(offered("p:crack { from = {fr"), Not(Contains("from")));
  EXPECT_THAT(offered("s:on { 'every', call = function(a, ev"), Not(Contains("every")));
  EXPECT_THAT(offered("s:on { call = function() if a then b(c, d) end end, ev"),
              ElementsAre("event", "every"));
  EXPECT_THAT(offered("x = { wi"), Not(Contains("width")));
  EXPECT_THAT(offered("function plate { wi"), Not(Contains("width")));
}

TEST_F(CompletionTest, ChoicesAreOfferedWithTheirQuotes) {
  EXPECT_THAT(offered("plate { plane = "), ElementsAre("\"strain\"", "\"stress\""));
  EXPECT_THAT(offered("plate { material = "), Contains("\"duran50\""));
  EXPECT_THAT(offered("s:on { event = \""),
              ElementsAre("arrest", "arrival", "branch", "break", "coalescence", "damage", "every",
                          "nucleation"));
}

TEST_F(CompletionTest, AFunctionOfTheScriptThatBearsANameOfOursIsNotTakenForIt) {
  console_.evaluate("local ours = plate plate = function() end");
  EXPECT_THAT(offered("plate { wi"), Not(Contains("width")));
}

TEST_F(CompletionTest, ItRunsNothing) {
  for (const char* text : {"trap.", "trap:", "trap.own.", "trap.zzz.", "trap { ", "trap().",
                           "trap:x { a", "trap \"", "#trap."})
    console_.complete(text);
  EXPECT_THAT(offered("trap."), ElementsAre("own"));
  EXPECT_EQ(console_.evaluate("called").at(0), "0");
}

TEST_F(CompletionTest, AnEmptyLineOffersWhatIsOursAndTheUsers) {
  const auto all = offered("");
  for (const char* name : {"plate", "simulate", "help", "p", "s", "t"})
    EXPECT_THAT(all, Contains(name));
  for (const char* name : {"mm", "while"}) EXPECT_THAT(all, Not(Contains(name)));
  EXPECT_THAT(offered("m"), Contains("mm"));
}

TEST_F(CompletionTest, KeysOfFieldsAreThoseOfTheirTables) {
  for (const TypeDoc* type : all_types())
    for (const Property& field : type->fields) {
      if (field.keys.empty()) continue;
      std::string count = fmt::format("n = 0 for k in pairs(s.{}) do n = n + 1 end", field.name);
      console_.evaluate(count);
      EXPECT_EQ(console_.evaluate("n").at(0), std::to_string(field.keys.size())) << field.name;
      for (const std::string_view key : field.keys)
        EXPECT_NE(console_.evaluate(fmt::format("s.{}.{}", field.name, key)).at(0), "nil") << key;
    }
}

TEST_F(CompletionTest, EveryMethodAndOptionCanBeReached) {
  for (const FunctionDoc* doc : all_docs()) {
    const std::string object = doc->owner.empty() ? "" : std::string(doc->owner) + ":";
    const std::string_view last = doc->name.substr(doc->name.rfind('.') + 1);  // of study.trade
    EXPECT_THAT(offered(object + std::string(doc->name)), Contains(last));
    if (doc->call != Call::options) continue;
    const std::string call =
        fmt::format("{}{}{}{{ ", object, doc->name, doc->leading.empty() ? " " : "(p, ");
    for (const Option& option : doc->options)
      EXPECT_THAT(offered(call + std::string(option.name)), Contains(option.name)) << call;
  }
}

TEST_F(CompletionTest, FilesAreOfferedWhereNoChoicesAreKnown) {
  const test::Folder folder;
  std::filesystem::create_directories(folder.path / "pictures");
  write_text(folder.path / "pictures/grain.png", "");
  write_text(folder.path / "pictures/.hidden", "");
  const std::string in = folder.path.string() + "/";
  EXPECT_EQ(completed("p:mask { \"" + in + "pic"), "p:mask { \"" + in + "pictures/");
  EXPECT_EQ(completed("io.open('" + in + "pictures/g"), "io.open('" + in + "pictures/grain.png'");
  EXPECT_THAT(offered("dofile \"" + in + "pictures/"), ElementsAre("grain.png"));
  EXPECT_THAT(offered("dofile \"" + in + "pictures/.h"), ElementsAre(".hidden"));
  EXPECT_THAT(offered("dofile \"" + in + "nowhere/"), IsEmpty());
}

TEST_F(CompletionTest, FilesOfASimulationLieInTheOutputFolder) {
  const test::Folder folder;
  write_text(folder.path / "older.mp4", "");
  Console console(test::quiet(folder.path));
  console.evaluate(test::scene);
  EXPECT_EQ(console.complete("s:movie { \"old").insertion(), "er.mp4\"");
  EXPECT_EQ(console.complete("contact_sheet { \"x\", pictures = { \"a\", \"old").insertion(),
            "er.mp4\"");
}

TEST_F(CompletionTest, AnythingMayBeTyped) {
  const std::string noise =
      "p:crack{from={0,'a\"[[ --]] ) } ] end function if ~= .. ... \\ \xC3\xA9 5e+";
  for (std::size_t begin = 0; begin < noise.size(); ++begin)
    for (std::size_t size = 0; begin + size <= noise.size(); ++size)
      EXPECT_NO_THROW(console_.complete(noise.substr(begin, size)));
}

TEST(Columns, FillTheWidthAndAreCut) {
  const std::vector<Candidate> list{{"a", ""}, {"bbb", ""}, {"c", ""}, {"d", ""}, {"e", ""}};
  EXPECT_EQ(in_columns(list, 15, 100), "a    c    e\nbbb  d\n");
  EXPECT_EQ(in_columns(list, 1, 100), "a\nbbb\nc\nd\ne\n");
  EXPECT_EQ(in_columns(list, 80, 2), "a    bbb\n... 3 more\n");
}

TEST(Completion, CutsNoCharacterInTwo) {
  const Completion completion{0, {{"\xC3\xA4", ""}, {"\xC3\xB6", ""}}};
  EXPECT_EQ(completion.insertion(), "");
}

}  // namespace
}  // namespace hackle
