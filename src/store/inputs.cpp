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
  return {{"name", material.name},         {"E_Pa", material.E},
          {"rho_kg_m3", material.rho},     {"nu", material.nu},
          {"G0_J_m2", material.G0},        {"alpha", material.alpha},
          {"alphaT_1_K", material.alphaT}, {"s0", material.s0},
          {"fringe_N_m", material.fringe}};
}

Json to_json(const std::vector<Vec2>& points) {
  Json list = Json::array();
  for (const Vec2& point : points) list.push_back(to_json(point));
  return list;
}

// How many cells in a row are outside, then inside, and so on.
Json run_lengths(const std::vector<std::uint8_t>& cells) {
  Json list = Json::array();
  std::uint8_t value = 0;
  std::int64_t length = 0;
  for (const std::uint8_t cell : cells) {
    if (cell != value) {
      list.push_back(length);
      value = cell;
      length = 0;
    }
    ++length;
  }
  list.push_back(length);
  return list;
}

Json to_json(const Shape& shape) {
  Json json = {{"kind", kind_of(shape)}};
  if (const auto* ellipse = std::get_if<Ellipse>(&shape))
    json.update({{"centre_m", to_json(ellipse->centre)},
                 {"radii_m", to_json(ellipse->radii)},
                 {"angle", ellipse->angle}});
  else if (const auto* polygon = std::get_if<Polygon>(&shape))
    json["points_m"] = to_json(polygon->points);
  else if (const auto* slot = std::get_if<Capsule>(&shape))
    json.update({{"from_m", to_json(slot->axis.from)},
                 {"to_m", to_json(slot->axis.to)},
                 {"radius_m", slot->radius}});
  else if (const auto* bitmap = std::get_if<Bitmap>(&shape))
    json.update({{"from_m", to_json(bitmap->least)},
                 {"to_m", to_json(bitmap->most)},
                 {"columns", bitmap->columns},
                 {"rows", bitmap->rows},
                 {"run_lengths", run_lengths(bitmap->inside)}});
  return json;
}

Json to_json(const Region& region) {
  return region ? to_json(*region) : Json("plate");
}

Json to_json(const Course& course) {
  if (course.is_constant() || course.is_function()) return course.describe();
  return to_json(course.points());
}

Json to_json(const VectorField& field) {
  return field.is_constant() ? to_json(field.constant()) : Json("function");
}

Json to_json(const ScalarField& field) {
  return field.is_constant() ? Json(field.constant()) : Json("function");
}

Json to_json(const Cutout& cutout) {
  return {{"name", cutout.name}, {"shape", to_json(cutout.shape)}};
}

Json to_json(const Inclusion& inclusion) {
  return {{"shape", to_json(inclusion.shape)}, {"material", to_json(inclusion.material)}};
}

Json to_json(const Crack& crack) {
  return {{"points_m", to_json(crack.points)},
          {"born", crack.born == Born::broken ? "broken" : "absent"}};
}

Json to_json(const Traction& load) {
  return {{"edge", name_of(load.edge)},
          {"stress_Pa", to_json(load.stress)},
          {"depth_m", load.depth},
          {"time", to_json(load.course)}};
}

Json to_json(const Pressure& load) {
  return {{"rim", load.rim}, {"pressure_Pa", load.pressure}, {"time", to_json(load.course)}};
}

Json to_json(const BodyForce& load) {
  return {{"region", to_json(load.region)},
          {"force_N_m3", to_json(load.force)},
          {"time", to_json(load.course)}};
}

Json to_json(const Support& load) {
  const bool velocity = load.kind == Support::Kind::velocity;
  return {{"region", to_json(load.region)},
          {velocity ? "velocity_m_s" : "displacement_m", to_json(load.value)},
          {"along_x", load.along_x},
          {"along_y", load.along_y},
          {"time", to_json(load.course)}};
}

Json to_json(const Heating& load) {
  return {{"region", to_json(load.region)},
          {"change_K", to_json(load.change)},
          {"time", to_json(load.course)}};
}

Json to_json(const Impactor& load) {
  return {{"centre_m", to_json(load.centre)},
          {"radius_m", load.radius},
          {"velocity_m_s", to_json(load.velocity)},
          {"mass_kg_m", load.mass}};
}

Json to_json(const Start& start) {
  return {{"region", to_json(start.region)},
          {"displacement_m", to_json(start.displacement)},
          {"velocity_m_s", to_json(start.velocity)}};
}

Json to_json(const std::optional<Scatter>& scatter) {
  if (!scatter) return "none";
  const bool weibull = scatter->kind == Scatter::Kind::weibull;
  return {{"distribution", weibull ? "weibull" : "normal"},
          {weibull ? "modulus" : "deviation", scatter->spread},
          {"correlation_m", scatter->correlation},
          {"seed", scatter->seed}};
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
          {"cutouts", list_of(plate.cutouts)},
          {"inclusions", list_of(plate.inclusions)},
          {"cracks", list_of(plate.cracks)},
          {"tractions", list_of(plate.loads.tractions)},
          {"pressures", list_of(plate.loads.pressures)},
          {"body_forces", list_of(plate.loads.body_forces)},
          {"supports", list_of(plate.loads.supports)},
          {"temperatures", list_of(plate.loads.heatings)},
          {"impactors", list_of(plate.loads.impactors)},
          {"damping_1_s", plate.loads.damping},
          {"starts", list_of(plate.starts)},
          {"no_fail", list_of(plate.no_fail)},
          {"strength", to_json(plate.scatter)}};
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
