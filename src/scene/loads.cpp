// SPDX-License-Identifier: MIT
#include "scene/loads.hpp"

#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/text.hpp"

namespace hackle {
namespace {

constexpr std::array<std::pair<std::string_view, Edge>, 4> edges{
    {{"left", Edge::left}, {"right", Edge::right}, {"bottom", Edge::bottom}, {"top", Edge::top}}};

void check_finite(const std::string& what, const Vec2& value, const char* unit,
                  Problems& problems) {
  if (!value.allFinite())
    problems.add(
        fmt::format("{} is {{{}, {}}} {}, it must be finite", what, value.x(), value.y(), unit));
}

void check_positive(const std::string& what, double value, const char* unit, Problems& problems) {
  if (!(value > 0.0 && std::isfinite(value)))
    problems.add(fmt::format("{} is {} {}, it must be above 0", what, value, unit));
}

void check_region(const Region& region, const std::string& who, Problems& problems) {
  if (region) check(*region, who, problems);
}

}  // namespace

std::string_view name_of(Edge edge) {
  for (const auto& [name, value] : edges)
    if (value == edge) return name;
  return "?";
}

std::optional<Edge> edge_named(std::string_view name) {
  for (const auto& [known, value] : edges)
    if (known == name) return value;
  return std::nullopt;
}

void check(const Traction& traction, Problems& problems) {
  check_finite(fmt::format("traction: stress on the {} edge", name_of(traction.edge)),
               traction.stress.constant(), "Pa", problems);
  if (!(traction.depth >= 0.0 && std::isfinite(traction.depth)))
    problems.add(fmt::format("traction: depth is {} m, it must be at least 0 m", traction.depth));
  check(traction.course, "traction", problems);
}

void check(const Pressure& pressure, Problems& problems) {
  check_finite("pressure: pressure", Vec2(pressure.pressure, 0.0), "Pa", problems);
  check(pressure.course, "pressure", problems);
}

void check(const BodyForce& force, Problems& problems) {
  check_region(force.region, "body_force", problems);
  check_finite("body_force: force", force.force.constant(), "N/m3", problems);
  check(force.course, "body_force", problems);
}

void check(const Support& support, Problems& problems) {
  check_region(support.region, "support", problems);
  check_finite("support: its motion", support.value.constant(),
               support.kind == Support::Kind::velocity ? "m/s" : "m", problems);
  check(support.course, "support", problems);
}

void check(const Heating& heating, Problems& problems) {
  check_region(heating.region, "temperature", problems);
  check_finite("temperature: change", Vec2(heating.change.constant(), 0.0), "K", problems);
  check(heating.course, "temperature", problems);
}

void check(const Impactor& impactor, Problems& problems) {
  check_positive("impactor: radius", impactor.radius, "m", problems);
  check_positive("impactor: mass", impactor.mass, "kg/m", problems);
  check_finite("impactor: centre", impactor.centre, "m", problems);
  check_finite("impactor: velocity", impactor.velocity, "m/s", problems);
}

void check(const Loads& loads, Problems& problems) {
  for (const Traction& load : loads.tractions) check(load, problems);
  for (const Pressure& load : loads.pressures) check(load, problems);
  for (const BodyForce& load : loads.body_forces) check(load, problems);
  for (const Support& load : loads.supports) check(load, problems);
  for (const Heating& load : loads.heatings) check(load, problems);
  for (const Impactor& load : loads.impactors) check(load, problems);
  if (!(loads.damping >= 0.0 && std::isfinite(loads.damping)))
    problems.add(fmt::format("damping is {} 1/s, it must be at least 0 1/s", loads.damping));
}

std::string describe(const Loads& loads) {
  return counted(loads.tractions.size(), "traction") + counted(loads.pressures.size(), "pressure") +
         counted(loads.body_forces.size(), "body force") +
         counted(loads.supports.size(), "support") +
         counted(loads.heatings.size(), "temperature change") +
         counted(loads.impactors.size(), "impactor") + (loads.damping > 0.0 ? ", damping" : "");
}

}  // namespace hackle
