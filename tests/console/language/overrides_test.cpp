// SPDX-License-Identifier: MIT
// --set simulate.KEY, material.KEY and movie.KEY.
#include "console/language/overrides.hpp"

#include <filesystem>
#include <map>
#include <string>

#include <gmock/gmock.h>

#include "console/scripts.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

const std::string script = R"(
p = plate { width = 10*mm, height = 4*mm, material = "duran50" }
s = simulate(p, { spacing = 1*mm, horizon = 3*mm, precision = "f64", step = 50*ns })
)";

ConsoleSettings with(std::map<std::string, std::string> overrides,
                     const std::filesystem::path& folder = "unused") {
  ConsoleSettings settings = test::quiet(folder);
  settings.overrides = std::move(overrides);
  return settings;
}

Summary summary_with(const std::map<std::string, std::string>& overrides) {
  Console console(with(overrides));
  console.run_text(script, "test.lua");
  return console.simulations().at(0);
}

TEST(Overrides, ReplaceWhatTheScriptGivesSimulate) {
  const Summary summary = summary_with({{"simulate.spacing", "0.5mm"},
                                        {"simulate.precision", "f32"},
                                        {"simulate.safety", "0.5"},
                                        {"simulate.fused", "false"}});
  EXPECT_DOUBLE_EQ(summary.numerics.spacing, 0.5e-3);
  EXPECT_DOUBLE_EQ(summary.numerics.horizon, 3e-3);
  EXPECT_EQ(summary.precision, "f32");
  EXPECT_EQ(summary.numerics.safety, 0.5);
  EXPECT_EQ(summary.nodes, 160);
}

TEST(Overrides, TakeAwayWhatTheScriptGives) {
  EXPECT_TRUE(summary_with({}).numerics.step.has_value());
  EXPECT_FALSE(summary_with({{"simulate.step", "default"}}).numerics.step.has_value());
}

TEST(Overrides, ReplaceMembersOfTheMaterial) {
  const Summary summary = summary_with({{"material.G0", "100"}, {"material.E", "70GPa"}});
  EXPECT_DOUBLE_EQ(summary.material.G0, 100.0);
  EXPECT_DOUBLE_EQ(summary.material.E, 70e9);
  EXPECT_DOUBLE_EQ(summary.material.rho, 2235.0);
  const Summary stretched = summary_with({{"material.s0", "0.001"}});
  EXPECT_EQ(stretched.material.s0, 0.001);
  EXPECT_EQ(stretched.material.G0, 0.0) << "one strength replaces the other";
}

TEST(Overrides, LeaveTheScriptsOwnTableAsItIs) {
  Console console(with({{"simulate.spacing", "0.5mm"}}));
  console.run_text(
      "p = plate { width = 10*mm, height = 4*mm, material = 'duran50' }\n"
      "t = { spacing = 1*mm }\ns = simulate(p, t)\nassert(t.spacing == 1*mm)\n"
      "assert(p.material.E == 65*GPa)",
      "test.lua");
}

TEST(Overrides, TellNamesAndValuesThatCannotBe) {
  const auto told = [](const std::map<std::string, std::string>& overrides) {
    return test::message_of(script, with(overrides));
  };
  EXPECT_THAT(told({{"simulate.spcing", "1mm"}}), HasSubstr("(did you mean 'spacing'?"));
  EXPECT_THAT(told({{"simulate.spacing", "-1mm"}}), HasSubstr("spacing"));
  EXPECT_THAT(told({{"simulate.precision", "f16"}}), HasSubstr("f16"));
  EXPECT_THAT(told({{"material.G", "1"}}), HasSubstr("a material has no 'G'"));
  EXPECT_THAT(told({{"material.E", "-1"}}), HasSubstr("E is -1 Pa"));
  EXPECT_THAT(told({{"material.E", "stiff"}}), HasSubstr("not a finite number"));
  EXPECT_THAT(told({{"material.E", "1/0"}}), HasSubstr("not a finite number"));
}

TEST(Overrides, AreForMoviesToo) {
  const test::Folder folder;
  const std::string film =
      script + "s:movie { 'a.gif', every = 0.1*us, width = 400 }\ns:run(0.2*us)";
  EXPECT_EQ(test::message_of(film, with({{"movie.width", "320"}}, folder.path)), "");
  EXPECT_THAT(test::message_of(film, with({{"movie.width", "2"}}, folder.path)),
              HasSubstr("width"));
}

TEST(Bare, MakesNoMoviePictureOrRecord) {
  const test::Folder folder;
  ConsoleSettings settings = test::quiet(folder.path);
  settings.only_verdicts = settings.no_pictures = true;
  Console console(settings);
  console.run_text(script +
                       "s:movie { 'a.gif', every = 0.1*us }\ns:record { 'a.h5', every = 0.1*us }\n"
                       "s:frame { 'a.png' }\nshow(s)\ns:log { 'a.csv', every = 0.1*us }\n"
                       "s:run(0.2*us)",
                   "test.lua");
  console.close_all();
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path))
    if (entry.path().filename().string().front() != '.')
      names.push_back(entry.path().filename().string());
  EXPECT_THAT(names, testing::ElementsAre("a.csv"));
}

}  // namespace
}  // namespace hackle
