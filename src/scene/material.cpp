// SPDX-License-Identifier: MIT
#include "scene/material.hpp"

#include <fmt/format.h>

#include "base/units.hpp"
#include "scene/check_members.hpp"

namespace hackle {
namespace {

std::string toughness(const Material& material) {
  return material.s0 > 0.0 ? "s0 " + shortest(material.s0)
                           : fmt::format("G0 {} J/m2", shortest(material.G0));
}

}  // namespace

void check(const Material& material, Problems& problems) {
  check_members(material, problems);
  if (material.G0 == 0.0 && material.s0 == 0.0)
    problems.add("material: G0 is missing", "or give the critical stretch, s0");
  if (material.G0 != 0.0 && material.s0 != 0.0)
    problems.add("material: both G0 and s0 are given", "give one: each follows from the other");
}

std::string describe(const Material& material) {
  return fmt::format("{} (E {}, rho {} kg/m3, {}{}{})", material.name, quantity(material.E, "Pa"),
                     shortest(material.rho), toughness(material),
                     material.alpha > 0.0 ? ", alpha " + shortest(material.alpha) : "",
                     material.alphaT > 0.0 ? ", alphaT " + shortest(material.alphaT) + " 1/K" : "");
}

}  // namespace hackle
