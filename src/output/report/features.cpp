// SPDX-License-Identifier: MIT
#include "output/report/features.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "lattice/needs.hpp"

namespace hackle {
std::vector<Stage> stages(const Simulation& simulation) {
  const double all = simulation.solve_seconds();
  const auto share = [all](double taken) {
    return all > 0.0 ? std::clamp(taken / all, 0.0, 1.0) : 0.0;
  };
  std::vector<Stage> list{{"kernel", 1.0}};
  double terms = 0.0;
  for (const auto& [name, seconds] : simulation.term_seconds()) {
    list.push_back({name, share(seconds)});
    terms += seconds;
  }
  list.front().share = share(all - terms);
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
  add(differ(simulation.lattice().materials),
      fmt::format("{} materials", simulation.lattice().materials.size()));
  add(needs.surfaced, fmt::format("surface {}", name_of(numerics.surface)));
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
