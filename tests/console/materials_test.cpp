// SPDX-License-Identifier: MIT
#include "console/materials.hpp"

#include <gmock/gmock.h>

#include "base/files.hpp"
#include "console/scripts.hpp"

namespace hackle {
namespace {

TEST(Materials, Duran50IsThatOfThePaper) {
  const Materials materials(data_file("assets/materials.lua"));
  const Material& glass = materials.find("duran50").material;
  EXPECT_EQ(glass.name, "Duran 50 glass");
  EXPECT_DOUBLE_EQ(glass.E, 65e9);
  EXPECT_DOUBLE_EQ(glass.rho, 2235.0);
  EXPECT_DOUBLE_EQ(glass.nu, 0.2);
  EXPECT_DOUBLE_EQ(glass.G0, 204.0);
}

TEST(Materials, EveryMaterialSaysItsSource) {
  const Materials materials(data_file("assets/materials.lua"));
  for (const KnownMaterial& known : materials.list())
    EXPECT_GT(known.source.size(), 10u) << known.key;
}

TEST(Materials, AnUnknownNameGetsTheNearest) {
  const Materials materials(data_file("assets/materials.lua"));
  try {
    materials.find("duran5");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_THAT(error.what(), testing::HasSubstr("no material 'duran5' (did you mean 'duran50'?)"));
  }
}

TEST(Materials, ALibraryMayGiveAlpha) {
  const test::Folder folder;
  write_text(folder.path / "m.lua",
             "return { a = { title = 'A', E = 1, rho = 1, nu = 0, G0 = 1, alpha = 0.02 },"
             " b = { title = 'B', E = 1, rho = 1, nu = 0, G0 = 1 } }");
  const Materials materials(folder.path / "m.lua");
  EXPECT_EQ(materials.find("a").material.alpha, 0.02);
  EXPECT_EQ(materials.find("b").material.alpha, 0.0);
}

TEST(Materials, ABrokenLibraryIsRefused) {
  const test::Folder folder;
  const auto expect_refused = [&](const std::string& text) {
    write_text(folder.path / "m.lua", text);
    EXPECT_THROW(Materials(folder.path / "m.lua"), Error) << text;
  };
  expect_refused("return 5");
  expect_refused("return { a = 1 }");
  expect_refused("return { a = { title = 'A', E = -1, rho = 1, nu = 0, G0 = 1 } }");
  expect_refused("return { a = { title = 'A', E = 1, rho = 1, nu = 0, G0 = 1, alpha = 1 } }");
  expect_refused("syntax error");
}

TEST(Materials, AScriptCanUseItsOwn) {
  EXPECT_EQ(
      test::message_of("local m = material { E = 3*GPa, rho = 1200, G0 = 300 }\n"
                       "assert(m.E == 3e9 and m.G0 == 300 and m.name == 'own material')\n"
                       "assert(m.alpha == 0)\n"
                       "m = material { E = 3*GPa, rho = 1200, G0 = 300, alpha = 0.25 }\n"
                       "assert(m.alpha == 0.25)\n"
                       "assert(tostring(material 'duran50'):find('Duran 50 glass', 1, true))\n"
                       "plate { width = 1, height = 1, material = m }"),
      "");
}

}  // namespace
}  // namespace hackle
