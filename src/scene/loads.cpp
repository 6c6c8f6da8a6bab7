// SPDX-License-Identifier: MIT
#include "scene/loads.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "base/text.hpp"
#include "scene/check_members.hpp"

namespace hackle {
namespace {

void check_part(const RimPart& angles, const char* who, Problems& problems) {
  if (!angles) return;
  const double turn = std::abs(angles->y() - angles->x());
  if (turn > 0.0 && turn <= 2.0 * std::numbers::pi + 1e-9) return;
  problems.add(fmt::format("{}: the arc goes {:.4g} degrees", who, turn * 180.0 / std::numbers::pi),
               "angles = {from, to} must differ by at most 360*deg, and not by 0");
}

void check_place(const Traction& traction, Problems& problems) {
  if (traction.edge.has_value() == !traction.rim.empty())
    problems.add("traction: it is not clear where it acts",
                 "give edge, or rim, the name of a hole, a notch or an outline");
  else if (traction.edge && traction.angles)
    problems.add("traction: angles are of a rim, and an edge is given",
                 "give rim and angles, or an edge alone");
  else if (!traction.edge && traction.depth != 0.0)
    problems.add("traction: depth is of an edge, and a rim is given", "leave it out");
}

void check_guided(const Guided& guided, std::string_view who, Problems& problems) {
  check_members(guided, who, problems);
  if (guided.guide != Guide::force) return;
  if (guided.value.isZero(0.0))
    problems.add(fmt::format("{}: its force is 0, which has no direction", who),
                 "give a force, or leave it out: it then stands still");
}

}  // namespace

void check(const Loads& loads, Problems& problems) {
  for_each_list(loads, [&](const auto& list) {
    for (const auto& load : list) check_members(load, problems);
  });
  for_each_guided(loads, [&](const auto& body) {
    check_guided(body.guided, description_of<std::remove_cvref_t<decltype(body)>>.noun, problems);
  });
  for (const Traction& traction : loads.tractions) {
    check_place(traction, problems);
    check_part(traction.angles, "traction", problems);
  }
  for (const Pressure& pressure : loads.pressures)
    check_part(pressure.angles, "pressure", problems);
  check_members(loads, problems);
}

double spring_stiffness(const Loads& loads) {
  double sum = 0.0;
  for_each_list(loads, [&](const auto& list) {
    if constexpr (requires { spring_stiffness(list.front()); })
      for (const auto& load : list) sum += spring_stiffness(load);
  });
  return sum;
}

std::string describe(const Loads& loads) {
  std::string text;
  for_each_list(loads, [&](const auto& list) {
    using Load = typename std::remove_cvref_t<decltype(list)>::value_type;
    text += counted(list.size(), std::string(description_of<Load>.counted).c_str());
  });
  return text + (loads.damping > 0.0 || loads.stiffness_damping > 0.0 ? ", damping" : "");
}

}  // namespace hackle
