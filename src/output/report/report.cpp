// SPDX-License-Identifier: MIT
#include "output/report/report.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include <fmt/format.h>

#include "base/units.hpp"
#include "output/report/features.hpp"
#include "output/report/ligament_remark.hpp"
#include "output/report/shape_remarks.hpp"
#include "scene/waves.hpp"
#include "solver/f32_range.hpp"

namespace hackle {
namespace {

// Returns " (15 200 of material)" if cut-outs removed some nodes.
std::string material_text(const Lattice& lattice) {
  const auto removed = std::ranges::count(lattice.material, Lattice::void_node);
  if (removed == 0) return "";
  return fmt::format(" ({} of material)",
                     grouped(static_cast<std::int64_t>(lattice.grid.nodes()) - removed));
}

// Returns a line for each sentence.
std::string account_lines(const std::vector<std::string>& account) {
  std::string lines;
  for (const std::string& sentence : account)
    lines += fmt::format("\n  {}{}", lines.empty() ? "account  " : "         ", sentence);
  return lines;
}

std::string lattice_line(const Simulation& simulation, const Summary& summary) {
  const Numerics& numerics = simulation.numerics();
  return fmt::format("{} nodes{}, {} bonds; spacing {}, horizon {} (m = {:.4g}); {} quadrature",
                     grouped(summary.nodes), material_text(simulation.lattice()),
                     grouped(summary.bonds), quantity(numerics.spacing, "m"),
                     quantity(numerics.horizon_or_default(), "m"), simulation.lattice().family.m(),
                     name_of(numerics.quadrature));
}

std::string model_line(const Simulation& simulation) {
  const Lattice& lattice = simulation.lattice();
  const Material& material = simulation.plate().material;
  const Moduli& moduli = lattice.calibration.moduli;
  const WaveSpeeds waves = wave_speeds(moduli.E, moduli.nu, lattice.rho, simulation.plate().plane);
  return fmt::format(
      "plane {}, {} constants, {} micromodulus: E {} (material {}), nu {:.3f} (material {:.3g}), "
      "G0 {} "
      "(material {}), s0 {:.4g}; "
      "c_R {:.0f} m/s",
      name_of(simulation.plate().plane), name_of(simulation.numerics().constants),
      name_of(simulation.numerics().micromodulus), quantity(moduli.E, "Pa"),
      quantity(material.E, "Pa"), moduli.nu, material.nu, quantity(lattice.calibration.G0, "J/m2"),
      quantity(material.G0, "J/m2"), lattice.calibration.s0, waves.rayleigh);
}

std::string time_line(const Summary& summary) {
  return fmt::format("{} in {} steps of {} (limit {})", quantity(summary.time, "s"),
                     grouped(summary.steps), quantity(summary.dt, "s"),
                     quantity(summary.dt_limit, "s"));
}

std::string damage_line(const Summary& summary) {
  return fmt::format("{} bonds broken since the start, largest damage of a node {:.2f}",
                     grouped(summary.damage.broken_bonds), summary.damage.max);
}

// Returns "roller 1", or "support 1 (grip)".
std::string spoken_name(const Reaction& one) {
  const std::string plain = fmt::format("{} {}", one.who, one.number);
  return one.name == fmt::format("{}{}", one.who, one.number)
             ? plain
             : fmt::format("{} ({})", plain, one.name);
}

// Returns "\n  forces   ..." with the force of the plate on each body, support and foundation, or
// "".
std::string reactions_line(const std::vector<Reaction>& reactions) {
  std::string line;
  for (const Reaction& one : reactions)
    line += fmt::format("{}{} at ({}, {}) bears ({:.4g}, {:.4g}) N/m, moment {:.4g} N",
                        line.empty() ? "\n  forces   " : "; ", spoken_name(one),
                        quantity(one.centre.x(), "m"), quantity(one.centre.y(), "m"), one.force.x(),
                        one.force.y(), one.moment);
  return line;
}

std::string energy_line(const Energy& energy) {
  const double share = energy.external != 0.0 ? 100.0 * energy.residual() / energy.external : 0.0;
  return fmt::format(
      "{:.4g} J/m put in = {:.4g} kinetic + {:.4g} strain + {:.4g} broken{}{}{}; residual {:.2g} %",
      energy.external, energy.kinetic, energy.strain, energy.broken,
      energy.damped > 0.0 ? fmt::format(" + {:.4g} damped", energy.damped) : "",
      energy.released != 0.0 ? fmt::format(" + {:.4g} released", energy.released) : "",
      energy.contact > 0.0 ? fmt::format(" + {:.4g} in contacts", energy.contact) : "", share);
}

std::string wall_line(const Simulation& simulation, const Summary& summary) {
  std::string line =
      fmt::format("solve {:.2f} s on {} thread{}, {:.3g} M node-steps/s ({} {})",
                  summary.wall.solve, summary.threads, summary.threads == 1 ? "" : "s",
                  summary.node_steps_per_second() * 1e-6, summary.precision,
                  instruction_set_names[static_cast<std::size_t>(simulation.instruction_set())]);
  const auto add = [&](const char* stage, double seconds) {
    if (seconds > 0.0) line += fmt::format("; {} {:.2f} s", stage, seconds);
  };
  add("render", summary.wall.render);
  add("encode", summary.wall.encode);
  add("store", summary.wall.store);
  return line;
}

std::string tiles_line(const Summary& summary) {
  const auto all = std::accumulate(summary.paths.begin(), summary.paths.end(), std::int64_t{0});
  std::string line;
  for (std::size_t path = 0; path < summary.paths.size(); ++path) {
    if (summary.paths[path] == 0) continue;
    line +=
        fmt::format("{}{} {:.1f} %", line.empty() ? "" : ", ", path_names[path],
                    100.0 * static_cast<double>(summary.paths[path]) / static_cast<double>(all));
  }
  return line.empty() ? "no step yet" : line;
}

// A material whose critical stretch is given has no fracture energy of its own to compare with.
std::optional<std::string> constants_remark(const Simulation& simulation) {
  const Material& material = simulation.plate().material;
  const Calibration& calibration = simulation.lattice().calibration;
  const double E = calibration.moduli.E / material.E;
  const double G0 = material.G0 > 0.0 ? calibration.G0 / material.G0 : 1.0;
  if (std::abs(E - 1.0) <= 1e-6 && std::abs(G0 - 1.0) <= 1e-6) return std::nullopt;
  const std::string constants(name_of(simulation.numerics().constants));
  if (material.G0 == 0.0)
    return fmt::format("{} constants give {:.3f} of the material's E on this lattice", constants,
                       E);
  return fmt::format(
      "{} constants give {:.3f} of the material's E and {:.3f} of its G0 on this lattice",
      constants, E, G0);
}

}  // namespace

std::string report(const Simulation& simulation, const Summary& summary) {
  return fmt::format(
      "{}{}\n  lattice  {}\n  model    {}\n  time     {}\n  damage   {}\n  energy   {}{}\n  steps  "
      "  "
      "{}\n  tiles    "
      "{}\n  wall     {}\n  state    {}{}",
      describe(simulation.plate()), account_lines(summary.account),
      lattice_line(simulation, summary), model_line(simulation), time_line(summary),
      damage_line(summary), energy_line(summary.energy), reactions_line(summary.reactions),
      describe_features(simulation), tiles_line(summary), wall_line(simulation, summary),
      summary.hash, summary.budget ? "\n  budget   " + describe(*summary.budget) : "");
}

std::vector<std::string> remarks(const Simulation& simulation) {
  std::vector<std::string> list;
  const Plate& plate = simulation.plate();
  const Grid& grid = simulation.lattice().grid;
  const double width = grid.nx * grid.dx, height = grid.ny * grid.dx;
  if (std::abs(width - plate.width) > 1e-6 * grid.dx ||
      std::abs(height - plate.height) > 1e-6 * grid.dx)
    list.push_back(
        fmt::format("the lattice is {} x {}: the plate is not a whole number of spacings",
                    quantity(width, "m"), quantity(height, "m")));
  constexpr double unlikely = 10.0;  // m, for a thin brittle plate
  if (const double size = std::max(plate.width, plate.height); size >= unlikely)
    list.push_back(fmt::format("the plate is {} long: lengths are in metres, as in {}*mm",
                               quantity(size, "m"), size));
  if (simulation.widened_at())
    list.push_back(fmt::format(
        "from {} on it was solved in f64: displacements of {:.2g} spacings are too large for f32",
        quantity(*simulation.widened_at(), "s"),
        spread_of(simulation.state(), simulation.lattice().material).half.maxCoeff()));
  for (std::string& remark : shape_remarks(plate, simulation.lattice()))
    list.push_back(std::move(remark));
  if (auto remark = ligament_remark(simulation)) list.push_back(std::move(*remark));
  if (auto remark = constants_remark(simulation)) list.push_back(*std::move(remark));
  return list;
}

}  // namespace hackle
