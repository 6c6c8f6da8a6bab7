// SPDX-License-Identifier: MIT
#include "scene/material.hpp"

#include <cmath>

#include <fmt/format.h>

#include "base/units.hpp"

namespace hackle {
namespace {

void require_positive(const char* key, double value, const char* unit, Problems& problems) {
  if (std::isfinite(value) && value > 0.0) return;
  problems.add(fmt::format("material: {} is {}, it must be above 0{}{}", key, value,
                           *unit == 0 ? "" : " ", unit));
}

// The critical stretch is given or follows from the fracture energy.
void check_toughness(const Material& material, Problems& problems) {
  if (material.s0 == 0.0) return require_positive("G0", material.G0, "J/m2", problems);
  require_positive("s0", material.s0, "", problems);
  if (material.s0 >= 1.0)
    problems.add(fmt::format("material: s0 is {}, it must be below 1", material.s0));
  if (material.G0 != 0.0)
    problems.add("material: both G0 and s0 are given", "give one: each follows from the other");
}

std::string toughness(const Material& material) {
  return material.s0 > 0.0 ? "s0 " + shortest(material.s0)
                           : fmt::format("G0 {} J/m2", shortest(material.G0));
}

}  // namespace

void check(const Material& material, Problems& problems) {
  require_positive("E", material.E, "Pa", problems);
  require_positive("rho", material.rho, "kg/m3", problems);
  check_toughness(material, problems);
  if (!(material.alpha >= 0.0 && material.alpha < 1.0))
    problems.add(
        fmt::format("material: alpha is {}, it must be at least 0 and below 1", material.alpha));
  if (!(material.alphaT >= 0.0 && std::isfinite(material.alphaT)))
    problems.add(
        fmt::format("material: alphaT is {} 1/K, it must be at least 0 1/K", material.alphaT),
        "glass has 3e-6 to 9e-6, steel 12e-6");
  if (!(material.fringe >= 0.0 && std::isfinite(material.fringe)))
    problems.add(
        fmt::format("material: fringe is {} N/m, it must be at least 0 N/m", material.fringe),
        "glass has 140e3 to 210e3, Homalite-100 22e3");
  if (!(material.nu > -1.0 && material.nu < 0.5))
    problems.add(fmt::format("material: nu is {}, it must lie between -1 and 0.5", material.nu));
}

std::string describe(const Material& material) {
  return fmt::format("{} (E {}, rho {} kg/m3, {}{}{})", material.name, quantity(material.E, "Pa"),
                     shortest(material.rho), toughness(material),
                     material.alpha > 0.0 ? ", alpha " + shortest(material.alpha) : "",
                     material.alphaT > 0.0 ? ", alphaT " + shortest(material.alphaT) + " 1/K" : "");
}

}  // namespace hackle
