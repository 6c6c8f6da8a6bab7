// SPDX-License-Identifier: MIT
#include "store/inputs.hpp"

#include <nlohmann/json.hpp>

namespace hackle {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Vec2& vector) {
  return Json::array({vector.x(), vector.y()});
}

Json to_json(const Material& material) {
  return {{"name", material.name}, {"E_Pa", material.E},     {"rho_kg_m3", material.rho},
          {"nu", material.nu},     {"G0_J_m2", material.G0}, {"alpha", material.alpha}};
}

Json to_json(const Crack& crack) {
  return {{"from_m", to_json(crack.from)},
          {"to_m", to_json(crack.to)},
          {"born", crack.born == Born::broken ? "broken" : "absent"}};
}

Json to_json(const Traction& traction) {
  return {{"edge", name_of(traction.edge)}, {"stress_Pa", to_json(traction.stress)}};
}

Json to_json(const NoFail& zone) {
  return {{"from_m", to_json(zone.least)}, {"to_m", to_json(zone.most)}};
}

template <class T>
Json list_of(const std::vector<T>& things) {
  Json list = Json::array();
  for (const T& thing : things) list.push_back(to_json(thing));
  return list;
}

Json to_json(const Plate& plate) {
  return {{"width_m", plate.width},
          {"height_m", plate.height},
          {"material", to_json(plate.material)},
          {"plane", plane_names[static_cast<std::size_t>(plate.plane)]},
          {"cracks", list_of(plate.cracks)},
          {"tractions", list_of(plate.tractions)},
          {"no_fail", list_of(plate.no_fail)}};
}

Json numerics_of(const Simulation& simulation) {
  const Numerics& numerics = simulation.numerics();
  const Lattice& lattice = simulation.lattice();
  return {{"spacing_m", numerics.spacing},
          {"horizon_m", numerics.horizon_or_default()},
          {"nx", lattice.grid.nx},
          {"ny", lattice.grid.ny},
          {"quadrature", quadrature_names[static_cast<std::size_t>(numerics.quadrature)]},
          {"micromodulus", micromodulus_names[static_cast<std::size_t>(numerics.micromodulus)]},
          {"constants", constants_names[static_cast<std::size_t>(numerics.constants)]},
          {"fused", numerics.fused},
          {"fidelity", numerics.fidelity},
          {"breaking", breaking_names[static_cast<std::size_t>(numerics.breaking)]},
          {"precision", precision_names[static_cast<std::size_t>(numerics.precision)]},
          {"micromodulus_N_m6", lattice.calibration.c},
          {"critical_stretch", lattice.calibration.s0},
          {"step_s", simulation.dt()},
          {"step_limit_s", lattice.step_limit}};
}

}  // namespace

std::string inputs_of(const Simulation& simulation) {
  const Json inputs = {{"plate", to_json(simulation.plate())},
                       {"numerics", numerics_of(simulation)}};
  // The name of a material may hold bytes that are no UTF-8.
  return inputs.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace hackle
