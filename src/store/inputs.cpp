// SPDX-License-Identifier: MIT
#include "store/inputs.hpp"

#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace hackle {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Vec2& vector) {
  return Json::array({vector.x(), vector.y()});
}

// Every noun is taken apart by structured bindings, so that a member that is added to it and not
// written breaks the build.
Json to_json(const Material& material) {
  const auto& [name, E, rho, nu, G0, alpha, alphaT, fringe, s0] = material;
  return {{"name", name},        {"E_Pa", E},      {"rho_kg_m3", rho},     {"nu", nu},
          {"G0_J_m2", G0},       {"alpha", alpha}, {"alphaT_1_K", alphaT}, {"s0", s0},
          {"fringe_N_m", fringe}};
}

Json to_json(const std::vector<Vec2>& points) {
  Json list = Json::array();
  for (const Vec2& point : points) list.push_back(to_json(point));
  return list;
}

// How many cells in a row are outside, then inside, and so on: "12 3 40". A text, because a list
// would take a line for each.
std::string run_lengths(const std::vector<std::uint8_t>& cells) {
  std::string text;
  std::uint8_t value = 0;
  std::int64_t length = 0;
  const auto end_run = [&] { fmt::format_to(std::back_inserter(text), "{} ", length); };
  for (const std::uint8_t cell : cells) {
    if (cell != value) {
      end_run();
      value = cell;
      length = 0;
    }
    ++length;
  }
  end_run();
  text.pop_back();
  return text;
}

Json members(const Ellipse& ellipse) {
  const auto& [centre, radii, angle] = ellipse;
  return {{"centre_m", to_json(centre)}, {"radii_m", to_json(radii)}, {"angle", angle}};
}

Json members(const Polygon& polygon) {
  const auto& [points] = polygon;
  return {{"points_m", to_json(points)}};
}

Json members(const Capsule& slot) {
  const auto& [axis, radius] = slot;
  const auto& [from, to] = axis;
  return {{"from_m", to_json(from)}, {"to_m", to_json(to)}, {"radius_m", radius}};
}

Json members(const Bitmap& bitmap) {
  const auto& [least, most, columns, rows, inside] = bitmap;
  return {{"from_m", to_json(least)},
          {"to_m", to_json(most)},
          {"columns", columns},
          {"rows", rows},
          {"run_lengths", run_lengths(inside)}};
}

Json to_json(const Shape& shape) {
  Json json = {{"kind", kind_of(shape)}};
  std::visit([&](const auto& kind) { json.update(members(kind)); }, shape);
  return json;
}

Json to_json(const Region& region) {
  return region ? to_json(*region) : Json("plate");
}

// What cannot be written down but as the text that made it, which is in the script.
Json function_json(const std::string& text) {
  return {{"function", text}};
}

Json to_json(const Course& course) {
  if (course.is_constant()) return "constant";
  return course.is_function() ? function_json(course.describe()) : to_json(course.points());
}

Json to_json(const VectorField& field) {
  return field.is_constant() ? to_json(field.constant()) : function_json("of place");
}

Json to_json(const ScalarField& field) {
  return field.is_constant() ? Json(field.constant()) : function_json("of place");
}

Json to_json(const Cutout& cutout) {
  const auto& [shape, name] = cutout;
  return {{"name", name}, {"shape", to_json(shape)}};
}

Json to_json(const Inclusion& inclusion) {
  const auto& [shape, material] = inclusion;
  return {{"shape", to_json(shape)}, {"material", to_json(material)}};
}

Json to_json(const Crack& crack) {
  const auto& [points, born] = crack;
  return {{"points_m", to_json(points)}, {"born", born == Born::broken ? "broken" : "absent"}};
}

Json to_json(const Traction& load) {
  const auto& [edge, stress, depth, course] = load;
  return {{"edge", name_of(edge)},
          {"stress_Pa", to_json(stress)},
          {"depth_m", depth},
          {"time", to_json(course)}};
}

Json to_json(const Pressure& load) {
  const auto& [rim, pressure, course] = load;
  return {{"rim", rim}, {"pressure_Pa", pressure}, {"time", to_json(course)}};
}

Json to_json(const BodyForce& load) {
  const auto& [region, force, course] = load;
  return {{"region", to_json(region)}, {"force_N_m3", to_json(force)}, {"time", to_json(course)}};
}

Json to_json(const Support& load) {
  const auto& [region, kind, value, along_x, along_y, course] = load;
  const bool velocity = kind == Support::Kind::velocity;
  return {{"region", to_json(region)},
          {velocity ? "velocity_m_s" : "displacement_m", to_json(value)},
          {"along_x", along_x},
          {"along_y", along_y},
          {"time", to_json(course)}};
}

Json to_json(const Heating& load) {
  const auto& [region, change, course] = load;
  return {{"region", to_json(region)}, {"change_K", to_json(change)}, {"time", to_json(course)}};
}

Json to_json(const Impactor& load) {
  const auto& [centre, radius, velocity, mass] = load;
  return {{"centre_m", to_json(centre)},
          {"radius_m", radius},
          {"velocity_m_s", to_json(velocity)},
          {"mass_kg_m", mass}};
}

Json to_json(const Start& start) {
  const auto& [region, displacement, velocity] = start;
  return {{"region", to_json(region)},
          {"displacement_m", to_json(displacement)},
          {"velocity_m_s", to_json(velocity)}};
}

Json to_json(const Scatter& scatter) {
  const auto& [kind, spread, correlation, seed] = scatter;
  const bool weibull = kind == Scatter::Kind::weibull;
  return {{"distribution", weibull ? "weibull" : "normal"},
          {weibull ? "modulus" : "deviation", spread},
          {"correlation_m", correlation},
          {"seed", seed}};
}

Json to_json(const Contact& contact) {
  const auto& [stiffness, reach] = contact;
  return {{"stiffness", stiffness}, {"reach", reach}};
}

template <class T>
Json to_json(const std::optional<T>& thing) {
  return thing ? to_json(*thing) : Json("none");
}

template <class T>
Json list_of(const std::vector<T>& things) {
  Json list = Json::array();
  for (const T& thing : things) list.push_back(to_json(thing));
  return list;
}

Json to_json(const Plate& plate) {
  const auto& [width, height, material, plane, cutouts, inclusions, cracks, no_fail, starts,
               scatter, contact, loads] = plate;
  const auto& [tractions, pressures, body_forces, supports, heatings, impactors, damping] = loads;
  return {{"width_m", width},
          {"height_m", height},
          {"material", to_json(material)},
          {"plane", plane_names[static_cast<std::size_t>(plane)]},
          {"cutouts", list_of(cutouts)},
          {"inclusions", list_of(inclusions)},
          {"cracks", list_of(cracks)},
          {"tractions", list_of(tractions)},
          {"pressures", list_of(pressures)},
          {"body_forces", list_of(body_forces)},
          {"supports", list_of(supports)},
          {"temperatures", list_of(heatings)},
          {"impactors", list_of(impactors)},
          {"damping_1_s", damping},
          {"contact", to_json(contact)},
          {"starts", list_of(starts)},
          {"no_fail", list_of(no_fail)},
          {"strength", to_json(scatter)}};
}

Json to_json(const Numerics& numerics) {
  const auto& [spacing, horizon, quadrature, micromodulus, constants, breaking, precision, fused,
               fidelity, step, force_step] = numerics;
  return {{"spacing_m", spacing},
          {"horizon_m", horizon},
          {"quadrature", quadrature_names[static_cast<std::size_t>(quadrature)]},
          {"micromodulus", micromodulus_names[static_cast<std::size_t>(micromodulus)]},
          {"constants", constants_names[static_cast<std::size_t>(constants)]},
          {"breaking", breaking_names[static_cast<std::size_t>(breaking)]},
          {"precision", precision_names[static_cast<std::size_t>(precision)]},
          {"fused", fused},
          {"fidelity", fidelity},
          {"step_s", step ? Json(*step) : Json("default")},
          {"force_step", force_step}};
}

// What is left open is as the run took it.
Json resolved(const Simulation& simulation) {
  const Lattice& lattice = simulation.lattice();
  Numerics numerics = simulation.numerics();
  numerics.horizon = numerics.horizon_or_default();
  Json json = to_json(numerics);
  json["asked_step_s"] = json["step_s"];
  json["step_s"] = simulation.dt();
  json.update({{"nx", lattice.grid.nx},
               {"ny", lattice.grid.ny},
               {"micromodulus_N_m6", lattice.calibration.c},
               {"critical_stretch", lattice.calibration.s0},
               {"step_limit_s", lattice.step_limit}});
  return json;
}

std::string text_of(const Plate& plate, Json numerics) {
  const Json inputs = {{"plate", to_json(plate)}, {"numerics", std::move(numerics)}};
  // The name of a material may hold bytes that are no UTF-8.
  return inputs.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string inputs_of(const Simulation& simulation) {
  return text_of(simulation.plate(), resolved(simulation));
}

std::string inputs_of(const Plate& plate, const Numerics& numerics) {
  return text_of(plate, to_json(numerics));
}

}  // namespace hackle
