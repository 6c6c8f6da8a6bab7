// SPDX-License-Identifier: MIT
#include "console/language/material_binding.hpp"

#include <gmock/gmock.h>

#include "console/scripts.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

TEST(MaterialBinding, DerivesFromAnother) {
  EXPECT_EQ(test::message_of("local m = material { like = 'duran50', G0 = 8, alphaT = 3e-6 }\n"
                             "assert(m.name == 'like Duran 50 glass', m.name)\n"
                             "assert(m.E == 65*GPa and m.rho == 2235 and m.nu == 0.2)\n"
                             "assert(m.G0 == 8 and m.alphaT == 3e-6)\n"
                             "local n = material { like = m, name = 'n', s0 = 1e-3 }\n"
                             "assert(n.name == 'n' and n.s0 == 1e-3 and n.G0 == 0)\n"
                             "local o = material { like = n, G0 = 5 }\n"
                             "assert(o.s0 == 0 and o.G0 == 5 and o.alphaT == 3e-6)"),
            "");
}

TEST(MaterialBinding, ACriticalStretchIsEnough) {
  EXPECT_EQ(test::message_of("local m = material { E = 65*GPa, rho = 2235, s0 = 1e-3 }\n"
                             "local p = plate { width = 20*mm, height = 20*mm, material = m }\n"
                             "simulate(p, { spacing = 1*mm })"),
            "");
}

TEST(MaterialBinding, EveryMaterialOfTheLibraryIsKnown) {
  EXPECT_EQ(
      test::message_of("for _, name in ipairs { 'duran50', 'soda_lime', 'homalite100', 'pmma',"
                       " 'soda_lime_branching', 'maraging_steel', 'borden_glass', 'alumina' }"
                       " do material(name) end\n"
                       "assert(material('soda_lime').G0 == 3.8)\n"
                       "assert(material('alumina').alphaT == 7.5e-6)"),
      "");
}

TEST(MaterialBinding, RefusesWhatMakesNoSense) {
  for (const char* options :
       {"", "E = 1, rho = 1", "E = 1, G0 = 1", "rho = 1, G0 = 1",
        "E = 1, rho = 1, G0 = 1, s0 = 0.1", "like = 'duran50', G0 = 1, s0 = 0.1", "like = 'duran5'",
        "like = 5", "like = {}", "like = 'duran50', s0 = 0", "like = 'duran50', s0 = 1",
        "like = 'duran50', s0 = 0/0", "like = 'duran50', alphaT = -1",
        "like = 'duran50', alphaT = 1/0", "like = 'duran50', alphaT = 'a'",
        "like = 'duran50', E = -1"})
    EXPECT_THAT(test::message_of(std::string("material { ") + options + " }"),
                HasSubstr("material"))
        << options;
}

}  // namespace
}  // namespace hackle
