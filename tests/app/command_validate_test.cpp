// SPDX-License-Identifier: MIT
// hackle validate, and what hackle run says of expectations.
#include "app/command_validate.hpp"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "app/program.hpp"
#include "app/validation.hpp"
#include "app/validation_chart.hpp"
#include "app/validation_page.hpp"
#include "base/error.hpp"
#include "base/files.hpp"
#include "base/markup.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::filesystem::path source = HACKLE_SOURCE_FOLDER;

const std::string mixed = R"(-- mixed.lua: three checks. And more.
expect { "height", unit = "m", got = 2, value = 2.5, tolerance = 1, source = "book" }
expect { "width", got = nil, min = 1, source = "pap<er", confirmed = false, reason = "known" }
expect { "depth", source = "book", unsupported = true, reason = "flat" }
)";

class ValidateTest : public testing::Test {
 protected:
  ValidateTest() {
    write_text(folder_.path / "mixed.lua", mixed);
    write_text(folder_.path / "good.lua",
               "expect { 'a', got = 1, value = 1, source = 'b' }\nprint 'never seen'\n");
    write_text(folder_.path / "broken.lua",
               "expect { 'a', got = 1, value = 1, source = 'b' }\nerror('oh no')\n");
  }
  std::string text(const char* file) { return read_text(folder_.path / file); }

  test::Folder folder_;
  test::Program program_{folder_};
};

TEST_F(ValidateTest, PrintsVerdictsAndCountsThem) {
  const auto ended = program_.run({"validate", "mixed.lua", "good.lua"});
  EXPECT_EQ(ended.code, 1) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("mixed: Three checks  ("));
  EXPECT_THAT(ended.out, HasSubstr("  pass  height: 2 m, expected 2.5 m within 1 m (book)\n"));
  EXPECT_THAT(ended.out,
              HasSubstr("width: nothing, expected at least 1 (pap<er (unconfirmed)): known"));
  EXPECT_THAT(ended.out, HasSubstr("\n2 pass, 1 fail, 1 unsupported\n"));
  EXPECT_THAT(ended.out, Not(HasSubstr("never seen")));
  EXPECT_EQ(program_.run({"validate", "-q", "good.lua"}).code, 0);
}

TEST_F(ValidateTest, AScriptThatFailsIsARowAndNotTheEnd) {
  const auto ended = program_.run({"validate", "--json", "broken.lua", "good.lua"});
  EXPECT_EQ(ended.code, 1);
  const auto json = nlohmann::json::parse(ended.out);
  EXPECT_EQ(json["schema"], 1);
  ASSERT_EQ(json["checks"].size(), 3U);
  EXPECT_EQ(json["checks"][0]["verdict"], "pass");
  EXPECT_EQ(json["checks"][1]["verdict"], "fail");
  EXPECT_THAT(json["checks"][1]["reason"].get<std::string>(), HasSubstr("oh no"));
  EXPECT_EQ(json["checks"][2]["name"], "good");
  for (const char* key :
       {"name", "quantity", "unit", "expected", "source", "got", "tolerance", "verdict"})
    EXPECT_TRUE(json["checks"][0].contains(key)) << key;
}

TEST_F(ValidateTest, WritesOnePageThatNeedsNothingElse) {
  program_.run({"validate", "-q", "-o", "there", "mixed.lua"});
  const std::string page = text("there/validate.html");
  EXPECT_THAT(page, HasSubstr("pap&lt;er"));
  EXPECT_THAT(page, HasSubstr("<b class=\"unsupported\">1</b>"));
  EXPECT_THAT(page, HasSubstr("<svg class=\"bar\""));
  for (const char* outside : {"src=\"http", "href=\"http", "<script", "@import", "url("})
    EXPECT_THAT(page, Not(HasSubstr(outside)));
}

TEST_F(ValidateTest, RewritesTablesBetweenTheirMarks) {
  write_text(folder_.path / "a.md",
             "before\n<!-- hackle validate: table -->\nold\n<!-- end -->\nmiddle\n"
             "<!-- hackle validate: summary -->\n<!-- end -->\nafter\n");
  program_.run({"validate", "-q", "--update", "a.md", "mixed.lua"});
  const std::string first = text("a.md");
  EXPECT_THAT(first, HasSubstr("| `mixed` | height | 2.5 m | 1 m | 2 m | book | pass |\n"));
  EXPECT_THAT(first,
              HasSubstr("| `mixed` | Three checks | 3 | 1 | fail: width; unsupported: depth |\n"));
  EXPECT_THAT(first, testing::StartsWith("before\n<!--"));
  EXPECT_THAT(first, testing::EndsWith("<!-- end -->\nafter\n"));
  EXPECT_THAT(first, Not(HasSubstr("old")));
  program_.run({"validate", "-q", "--update", "a.md", "mixed.lua"});
  EXPECT_EQ(text("a.md"), first);
  write_text(folder_.path / "b.md", "nothing");
  const auto refused = program_.run({"validate", "--update", "b.md", "mixed.lua"});
  EXPECT_EQ(refused.code, 5);
  EXPECT_THAT(refused.err, HasSubstr("'b.md' has no place for the table"));
  EXPECT_EQ(refused.out, "");
}

TEST_F(ValidateTest, AnUnknownNameGetsTheNearest) {
  const auto ended = program_.run({"validate", "grifith"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("no check 'grifith' (did you mean 'griffith'?)"));
}

TEST_F(ValidateTest, RunTellsVerdictsAndSucceeds) {
  const auto ended = program_.run({"run", "mixed.lua"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.out, HasSubstr("pass  height"));
  const auto quiet = program_.run({"run", "-q", "mixed.lua"});
  EXPECT_THAT(quiet.out, testing::StartsWith("fail  width"));
  const auto json = nlohmann::json::parse(program_.run({"run", "--json", "mixed.lua"}).out);
  EXPECT_EQ(json["expectations"].size(), 3U);
  EXPECT_EQ(json["expectations"][2]["verdict"], "unsupported");
}

// A handful of quick scripts as they ship; all of them belong to the nightly run.
TEST_F(ValidateTest, ReadyScriptsHold) {
  const auto ended =
      program_.run({"validate", "--quick", "--json", "lattice", "patch_test", "single_bond"});
  EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
  const auto checks = nlohmann::json::parse(ended.out)["checks"];
  EXPECT_GE(checks.size(), 10U);
  const std::string table = read_text(source / "tests/README.md");
  for (const auto& check : checks) {
    EXPECT_EQ(check["verdict"], "pass") << check;
    const std::string name = check["name"], quantity = check["quantity"];
    EXPECT_TRUE(table.find("| `" + name + "` | " + markdown(quantity) + " |") != std::string::npos)
        << name << ", " << quantity << ": hackle validate --update tests/README.md";
  }
}

TEST(ValidationScripts, AreNamedOnceAndTheQuickOnesAreAmongThem) {
  std::vector<std::string> names;
  for (const ValidationScript& script : validation_scripts({}, false)) names.push_back(script.name);
  for (const ValidationScript& script : validation_scripts({}, true))
    EXPECT_EQ(std::ranges::count(names, script.name), 1) << script.name;
  EXPECT_GE(names.size(), 20U);
  const std::string summary = read_text(source / "README.md");
  for (const std::string& name : names)
    EXPECT_TRUE(summary.find("| `" + name + "` |") != std::string::npos)
        << name << ": hackle validate --update README.md";
  EXPECT_GE(validation_scripts({}, true).size(), 6U);
}

TEST(ValidationChart, DrawsAPointForEveryPlace) {
  Expectation e;
  e.quantity = "u";
  e.unit = "m";
  e.curve = {"x < y", {0, 1, 2}, {0, 1e-3, 4e-3}, {0, 1.1e-3, 3.9e-3}};
  const std::string svg = curve_chart(e);
  std::size_t dots = 0;
  for (std::size_t at = svg.find("<circle"); at != std::string::npos;
       at = svg.find("<circle", at + 1))
    ++dots;
  EXPECT_EQ(dots, 3U);
  EXPECT_THAT(svg, HasSubstr("u in mm"));
  EXPECT_THAT(svg, HasSubstr("x &lt; y"));
  e.got = 1;
  EXPECT_EQ(bounds_chart(e), "");
  e.expected = 2;
  e.tolerance = 1;
  EXPECT_THAT(bounds_chart(e), HasSubstr("cx=\"22.5\""));  // at the lower bound
}

}  // namespace
}  // namespace hackle
