// SPDX-License-Identifier: MIT
#include "study/trade_axes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "base/units.hpp"
#include "lattice/numerics.hpp"

namespace hackle {
namespace {

constexpr double usual_alpha = 0.02;  // of the paper's own runs

// A choice among the names of an enumeration, without the present one.
template <class Enum>
TradeAxis choice(const std::string& key, const std::string& now) {
  TradeAxis axis{.name = key};
  for (const std::string_view name : enum_names<Enum>)
    if (name != now) axis.values.push_back(simulated(key, std::string(name)));
  return axis;
}

bool is_allowed(double m) {
  return m >= min_m && m <= max_m;
}

// m stays.
TradeAxis spacings(const SceneNumerics& scene) {
  TradeAxis axis{.name = "spacing", .of_lattice = true};
  for (const double factor : {2.0, std::numbers::sqrt2, 1.0 / std::numbers::sqrt2, 0.5})
    axis.values.push_back(spaced(factor * scene.spacing, scene.m()));
  return axis;
}

// The horizon stays, and the spacing follows.
TradeAxis numbers_of_neighbours(const SceneNumerics& scene) {
  TradeAxis axis{.name = "m", .of_lattice = true};
  for (const double m : {2.0, 3.0, 4.0, 5.0, 6.0})
    if (std::abs(m - scene.m()) > 0.01) axis.values.push_back(spaced(scene.horizon / m, m));
  return axis;
}

// The spacing stays.
TradeAxis horizons(const SceneNumerics& scene) {
  TradeAxis axis{.name = "horizon", .of_lattice = true};
  for (const double m : {2.0, 3.0, 6.0})
    if (std::abs(m - scene.m()) > 0.01 && is_allowed(m))
      axis.values.push_back(spaced(scene.spacing, m));
  return axis;
}

TradeAxis steps(const SceneNumerics& scene) {
  TradeAxis axis{.name = "step", .exact_by_itself = true};
  for (const double safety : {0.45, 0.7, 0.9, 0.97})
    if (std::abs(safety - scene.safety) > 0.01)
      axis.values.push_back(joined(simulated("safety", shortest(safety)), scene.own_step()));
  return axis;
}

TradeAxis flag(const std::string& key, bool now) {
  return {.name = key, .values = {simulated(key, now ? "false" : "true")}, .exact_by_itself = true};
}

TradeAxis fidelities(const SceneNumerics& scene) {
  TradeAxis axis{.name = "fidelity", .exact_by_itself = true};
  for (const double fidelity : {0.0, 0.25, 0.5})
    if (fidelity != scene.fidelity)
      axis.values.push_back(simulated("fidelity", shortest(fidelity)));
  return axis;
}

TradeAxis history(const SceneNumerics& scene) {
  return {.name = "history",
          .values = {{{"material.alpha", scene.alpha > 0.0 ? "0" : shortest(usual_alpha)}}},
          .of_model = scene.alpha == 0.0};
}

// The calibration of the paper is inconsistent, and no choice for others.
TradeAxis constants(const SceneNumerics& scene) {
  TradeAxis axis = choice<Constants>("constants", scene.constants);
  std::erase(axis.values, simulated("constants", "paper"));
  return axis;
}

struct Refinement {
  double spacing = 1.0, m = 1.0, step = 1.0;
  double cost() const { return spacing * spacing * spacing * m * m * step; }
};

Settings refined(const SceneNumerics& scene, const Refinement& by) {
  const double m = std::min(max_m, std::round(scene.m() * by.m));
  Settings all = spaced(scene.spacing / by.spacing, by.m > 1.0 ? m : scene.m());
  all =
      joined(all, joined(simulated("safety", shortest(scene.safety / by.step)), scene.own_step()));
  all = joined(all, joined(simulated("precision", "f64"), simulated("fidelity", "0")));
  return joined(all, joined(simulated("fused", "false"), simulated("constants", "lattice")));
}

}  // namespace

bool TradeAxis::has(const Settings& settings) const {
  return std::ranges::find(values, settings) != values.end();
}

std::vector<TradeAxis> trade_axes(const SceneNumerics& scene) {
  TradeAxis precision = choice<Precision>("precision", scene.precision);
  precision.exact_by_itself = true;
  return {precision,
          flag("fused", scene.fused),
          fidelities(scene),
          steps(scene),
          spacings(scene),
          numbers_of_neighbours(scene),
          horizons(scene),
          choice<Quadrature>("quadrature", scene.quadrature),
          choice<Surface>("surface", scene.surface),
          choice<Breaking>("breaking", scene.breaking),
          constants(scene),
          choice<Micromodulus>("micromodulus", scene.micromodulus),
          history(scene)};
}

std::vector<Settings> reference_settings(const SceneNumerics& scene, double most) {
  constexpr std::array refinements{
      Refinement{2.0, 1.5, 2.0}, Refinement{2.0, 1.5, 1.0}, Refinement{2.0, 1.0, 1.0},
      Refinement{std::numbers::sqrt2, 1.25, 1.0}, Refinement{std::numbers::sqrt2, 1.0, 1.0}};
  const auto affordable =
      std::ranges::find_if(refinements, [&](const Refinement& by) { return by.cost() <= most; });
  const Settings fine =
      refined(scene, affordable == refinements.end() ? refinements.back() : *affordable);
  const Settings area = simulated("quadrature", "area"), energy = simulated("surface", "energy");
  return {joined(fine, joined(area, energy)), joined(fine, area), fine};
}

}  // namespace hackle
