// SPDX-License-Identifier: MIT
#include "output/features.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "lattice/needs.hpp"

namespace hackle {
namespace {

// Whether forces change in time, or nodes are led.
bool loads_vary(const Loads& loads) {
  const auto varies = [](const auto& load) { return !load.amplitude.is_constant(); };
  return !loads.supports.empty() || std::ranges::any_of(loads.tractions, varies) ||
         std::ranges::any_of(loads.pressures, varies) ||
         std::ranges::any_of(loads.body_forces, varies);
}

}  // namespace

std::vector<Stage> stages(const Simulation& simulation) {
  const Plate& plate = simulation.plate();
  const StepSeconds& seconds = simulation.step_seconds();
  const double all = simulation.solve_seconds();
  std::vector<Stage> list;
  const auto add = [&](bool present, const char* name, double taken) {
    if (present) list.push_back({name, all > 0.0 ? std::clamp(taken / all, 0.0, 1.0) : 0.0});
  };
  add(true, "kernel", all - seconds.sum());
  add(plate.loads.damping > 0.0, "damping", seconds.damping);
  add(!plate.loads.thermal_loads.empty(), "heat", seconds.heat);
  add(loads_vary(plate.loads), "varying loads", seconds.loads.others());
  add(plate.contact.has_value(), "contact", seconds.loads.contact);
  add(!plate.loads.impactors.empty(), "impactors", seconds.loads.impact);
  return list;
}

std::vector<std::string> kernel_features(const Simulation& simulation) {
  const Numerics& numerics = simulation.numerics();
  const Needs needs = needs_of(simulation.lattice(), !simulation.thermal_strain().empty());
  std::vector<std::string> list;
  const auto add = [&](bool present, std::string name) {
    if (present) list.push_back(std::move(name));
  };
  add(needs.zones, "no-fail zones");
  add(needs.mixed, fmt::format("{} materials", simulation.lattice().materials.size()));
  add(needs.scattered, "scatter of strength");
  add(needs.history, "alpha");
  add(needs.heated, "thermal strain");
  add(numerics.fidelity > 0.0, fmt::format("fidelity {:g}", numerics.fidelity));
  add(numerics.fused, "fused arithmetic");
  return list;
}

std::string describe_features(const Simulation& simulation) {
  const auto text_of = [](const Stage& stage) {
    return fmt::format("{} {:.1f} %", stage.name, 100.0 * stage.share);
  };
  const std::vector<Stage> list = stages(simulation);
  const std::vector<std::string> inside = kernel_features(simulation);
  std::string text = text_of(list.front());
  if (!inside.empty()) text += fmt::format(" ({})", fmt::join(inside, ", "));
  for (std::size_t k = 1; k < list.size(); ++k) text += ", " + text_of(list[k]);
  return text;
}

}  // namespace hackle
