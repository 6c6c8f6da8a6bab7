// SPDX-License-Identifier: MIT
// Bad input is refused by name, with the right kind, before anything is written.
#include <gmock/gmock.h>
#include <unistd.h>

#include "base/files.hpp"
#include "console/scripts.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string film = "s:movie { 'a.mp4', every = 1*us }\ns:run(1*us)";

// Returns the message of the refusal; expects that nothing was written.
std::string refusal(const std::string& script, ErrorKind kind) {
  const test::Folder folder;
  const auto out = folder.path / "out";
  const auto failure = test::failure_of(script, test::quiet(out));
  EXPECT_FALSE(std::filesystem::exists(out)) << script;
  if (!failure) return "not refused";
  EXPECT_EQ(failure->kind(), kind) << failure->what();
  return failure->what();
}

std::string simulate(const std::string& options) {
  return refusal(test::plate_p + "s = simulate(p, " + options + ")\n" + film, ErrorKind::refused);
}

TEST(Refusal, AFileThatIsMissing) {
  Console console(test::quiet());
  try {
    console.run_file("/nowhere/at_all.lua");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::files);
    EXPECT_THAT(error.what(), HasSubstr("cannot read '/nowhere/at_all.lua'"));
  }
}

TEST(Refusal, ASyntaxErrorHasFileAndLine) {
  EXPECT_THAT(refusal("local a = 1\nlocal b = = 2", ErrorKind::script), StartsWith("test.lua:2:"));
}

TEST(Refusal, CompiledLua) {
  EXPECT_THAT(refusal("\x1bLua", ErrorKind::script), HasSubstr("binary chunk"));
}

TEST(Refusal, AnUnknownKey) {
  EXPECT_THAT(
      simulate("{ spacng = 1*mm }"),
      testing::AllOf(HasSubstr("test.lua:2: simulate: unknown option 'spacng' (did you mean "
                               "'spacing'?"),
                     HasSubstr("spacing is missing (a number in m)")));
}

TEST(Refusal, AWrongType) {
  EXPECT_THAT(simulate("{ spacing = '1 mm' }"),
              HasSubstr("simulate: spacing is the text '1 mm', expected a number in m"));
}

TEST(Refusal, ANegativeSize) {
  EXPECT_THAT(
      refusal("plate { width = -100*mm, height = 1, material = 'duran50' }", ErrorKind::refused),
      HasSubstr("plate: width is -100 mm, it must be above 0 m"));
}

TEST(Refusal, Nan) {
  EXPECT_THAT(
      refusal("plate { width = 0/0, height = 1, material = 'duran50' }", ErrorKind::refused),
      HasSubstr("plate: width is nan, expected a finite number in m"));
}

TEST(Refusal, ASpacingLargerThanThePlate) {
  EXPECT_THAT(simulate("{ spacing = 50*mm }"),
              HasSubstr("simulate: spacing 50 mm is larger than the plate (100 mm x 40 mm)"));
}

TEST(Refusal, AHorizonUnderTwoSpacings) {
  EXPECT_THAT(simulate("{ spacing = 1*mm, horizon = 1.5*mm }"),
              HasSubstr("simulate: horizon 1.5 mm is under 2 spacings of 1 mm"));
}

TEST(Refusal, ABadStepHidesNoOtherProblem) {
  EXPECT_THAT(simulate("{ spacing = 1*mm, horizon = 1.5*mm, step = -1*ns, fidelity = 2 }"),
              testing::AllOf(HasSubstr("step is -1 ns, it must be above 0 s"),
                             HasSubstr("fidelity is 2, it must be between 0 and 1"),
                             HasSubstr("horizon 1.5 mm is under 2 spacings of 1 mm")));
}

TEST(Refusal, AStepIsNotJudgedByOptionsThatWereNotMeant) {
  // 1 us is too long for any lattice of this spacing, but this one is not known.
  EXPECT_THAT(simulate("{ spacing = 1*mm, horizon = 'far', step = 1*us }"),
              testing::AllOf(HasSubstr("horizon is the text 'far'"),
                             testing::Not(HasSubstr("stability limit"))));
}

TEST(Refusal, ThePapersConstantsInPlaneStrain) {
  const std::string thick =
      "p = plate { width = 100*mm, height = 40*mm, material = 'duran50', plane = 'strain' }\n";
  EXPECT_THAT(
      refusal(thick + "simulate(p, { spacing = 1*mm, constants = 'paper' })", ErrorKind::refused),
      HasSubstr("constants = \"paper\" are for plane stress"));
  EXPECT_THAT(simulate("{ spacing = 1*mm, constants = 'paper', micromodulus = 'conical' }"),
              HasSubstr("a constant micromodulus"));
}

TEST(Refusal, FidelityWithAHistory) {
  EXPECT_THAT(refusal("m = material { E = 65*GPa, rho = 2235, G0 = 204, alpha = 0.25 }\n"
                      "p = plate { width = 100*mm, height = 40*mm, material = m }\n"
                      "simulate(p, { spacing = 1*mm, fidelity = 0.3 })",
                      ErrorKind::refused),
              HasSubstr("fidelity is 0.3 and the material's alpha 0.25"));
}

TEST(Refusal, AnUnknownQuadratureOrPlane) {
  EXPECT_THAT(simulate("{ spacing = 1*mm, quadrature = 'centroids' }"),
              HasSubstr("quadrature is 'centroids' (did you mean 'centroid'?)"));
  EXPECT_THAT(refusal("plate { width = 1, height = 1, material = 'duran50', plane = 'strian' }",
                      ErrorKind::refused),
              HasSubstr("plane is 'strian' (did you mean 'strain'?)"));
}

TEST(Refusal, ACrackOutsideThePlate) {
  EXPECT_THAT(refusal(test::plate_p + "p:crack { from = {0, 50*mm}, to = {50*mm, 20*mm} }",
                      ErrorKind::refused),
              HasSubstr("crack: 'from' (0 m, 50 mm) lies outside the plate"));
}

TEST(Refusal, APlateOfMoreNodesThanMemory) {
  EXPECT_THAT(simulate("{ spacing = 0.1*um }"),
              testing::ContainsRegex("nodes need .* of memory, .* are free .*would fit"));
}

TEST(Refusal, AFolderThatCannotBeWritten) {
  const test::Folder folder;
  write_text(folder.path / "file", "");
  const auto failure =
      test::failure_of(test::plate_p + "s = simulate(p, { spacing = 2*mm })\n" + film,
                       test::quiet(folder.path / "file/out"));
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->kind(), ErrorKind::files);
  EXPECT_THAT(failure->what(), HasSubstr("is not a folder"));
}

TEST(Refusal, AFolderThatWasTakenAwayBeforeTheRun) {
  const test::Folder folder;
  const std::string name = (folder.path / "out").string();
  const auto failure = test::failure_of(
      test::plate_p + "s = simulate(p, { spacing = 2*mm })\ns:movie { 'a.mp4', every = 1*us }\n" +
          "io.open('" + name + "', 'w'):close()\ns:run(1*us)",
      test::trusted(name));
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->kind(), ErrorKind::files);
  EXPECT_THAT(failure->what(), HasSubstr("test.lua:5: cannot write"));
}

}  // namespace
}  // namespace hackle
