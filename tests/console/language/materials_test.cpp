// SPDX-License-Identifier: MIT
#include "console/language/materials.hpp"

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

// All values differ.
TEST(Materials, EveryValueOfALibraryReachesItsMember) {
  const test::Folder folder;
  write_text(folder.path / "m.lua",
             "return { a = { title = 'A', E = 1, rho = 2, nu = 0.3, G0 = 4, alpha = 0.05, alphaT = "
             "6, fringe = 7, source = 'a book' },"
             " b = { title = 'B', E = 1, rho = 2, nu = 0.3, s0 = 0.08, source = 'a paper' } }");
  const Materials materials(folder.path / "m.lua");
  EXPECT_EQ(materials.find("a").material, (Material{"A", 1, 2, 0.3, 4, 0.05, 6, 7, 0}));
  EXPECT_EQ(materials.find("a").source, "a book");
  EXPECT_EQ(materials.find("b").material, (Material{"B", 1, 2, 0.3, 0, 0, 0, 0, 0.08}));
}

// The library written down a second time, from its sources.
TEST(Materials, AreThoseOfTheirSources) {
  struct Known {
    const char* key;
    double E, rho, nu, G0, alphaT, fringe;
  };
  const Known known[] = {{"alumina", 370e9, 3980, 0.22, 24, 7.5e-6, 0},
                         {"borden_glass", 32e9, 2450, 0.2, 3, 0, 0},
                         {"duran50", 65e9, 2235, 0.2, 204, 0, 136.5e3},
                         {"homalite100", 4.55e9, 1230, 0.31, 38.46, 0, 22e3},
                         {"maraging_steel", 190e9, 8000, 0.3, 22130, 0, 0},
                         {"pmma", 3.09e9, 1180, 0.35, 300, 0, 0},
                         {"soda_lime", 72e9, 2440, 0.22, 3.8, 0, 0},
                         {"soda_lime_branching", 72e9, 2440, 0.22, 135, 0, 0}};
  const Materials materials(data_file("assets/materials.lua"));
  ASSERT_EQ(materials.list().size(), std::size(known));
  for (const Known& one : known) {
    const Material& found = materials.find(one.key).material;
    EXPECT_DOUBLE_EQ(found.E, one.E) << one.key;
    EXPECT_EQ(found.rho, one.rho) << one.key;
    EXPECT_EQ(found.nu, one.nu) << one.key;
    EXPECT_DOUBLE_EQ(found.G0, one.G0) << one.key;
    EXPECT_EQ(found.alphaT, one.alphaT) << one.key;
    EXPECT_EQ(found.fringe, one.fringe) << one.key;
    EXPECT_EQ(found.alpha, 0.0) << one.key;
  }
}

}  // namespace
}  // namespace hackle
