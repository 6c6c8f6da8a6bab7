// SPDX-License-Identifier: MIT
#include "store/inputs_reader.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"

namespace hackle {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::int64_t most_cells = std::int64_t{1} << 24;  // of a picture

[[noreturn]] void refuse(const std::string& what) {
  throw Error(ErrorKind::files, "the inputs of the run cannot be read: " + what);
}

double number(const Json& json, const char* name) {
  return json.at(name).get<double>();
}

Vec2 vector(const Json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>()};
}

std::vector<Vec2> points(const Json& json) {
  std::vector<Vec2> list;
  for (const Json& point : json) list.push_back(vector(point));
  return list;
}

// The enumerator whose place is that of its name.
template <class Enum, class Names>
Enum choice(const Json& json, const char* name, const Names& names) {
  const auto text = json.at(name).get<std::string>();
  const auto found = std::ranges::find(names, text);
  if (found == names.end()) refuse(fmt::format("{} is '{}'", name, text));
  return static_cast<Enum>(found - names.begin());
}

Material material(const Json& json) {
  Material material;
  material.name = json.at("name").get<std::string>();
  material.E = number(json, "E_Pa");
  material.rho = number(json, "rho_kg_m3");
  material.nu = number(json, "nu");
  material.G0 = number(json, "G0_J_m2");
  material.alpha = number(json, "alpha");
  material.alphaT = number(json, "alphaT_1_K");
  material.s0 = number(json, "s0");
  material.fringe = number(json, "fringe_N_m");
  return material;
}

// From how many cells in a row are outside, then inside, and so on.
std::vector<std::uint8_t> cells(const Json& run_lengths, std::int64_t count) {
  if (count < 0 || count > most_cells) refuse("a picture is too large");
  std::vector<std::uint8_t> list;
  std::uint8_t value = 0;
  for (const Json& entry : run_lengths) {
    const auto length = entry.get<std::int64_t>();
    const auto room = count - static_cast<std::int64_t>(list.size());
    if (length < 0 || length > room) refuse("a picture has too many cells");
    list.insert(list.end(), static_cast<std::size_t>(length), value);
    value = value == 0 ? 1 : 0;
  }
  if (static_cast<std::int64_t>(list.size()) != count) refuse("a picture has too few cells");
  return list;
}

Bitmap bitmap(const Json& json) {
  Bitmap bitmap{vector(json.at("from_m")),
                vector(json.at("to_m")),
                json.at("columns").get<int>(),
                json.at("rows").get<int>(),
                {}};
  const auto count = std::int64_t{bitmap.columns} * bitmap.rows;
  bitmap.inside = cells(json.at("run_lengths"), count);
  return bitmap;
}

Shape shape(const Json& json) {
  const auto kind = json.at("kind").get<std::string>();
  if (kind == "ellipse")
    return Ellipse{vector(json.at("centre_m")), vector(json.at("radii_m")), number(json, "angle")};
  if (kind == "polygon") return Polygon{points(json.at("points_m"))};
  if (kind == "slot")
    return Capsule{{vector(json.at("from_m")), vector(json.at("to_m"))}, number(json, "radius_m")};
  if (kind == "picture") return bitmap(json);
  refuse(fmt::format("there is no shape '{}'", kind));
}

Crack crack(const Json& json) {
  const bool broken = json.at("born").get<std::string>() == "broken";
  return {points(json.at("points_m")), broken ? Born::broken : Born::absent};
}

std::optional<Scatter> scatter(const Json& json) {
  if (json.is_string()) return std::nullopt;
  Scatter scatter;
  const bool weibull = json.at("distribution").get<std::string>() == "weibull";
  scatter.kind = weibull ? Scatter::Kind::weibull : Scatter::Kind::normal;
  scatter.spread = number(json, weibull ? "modulus" : "deviation");
  scatter.correlation = number(json, "correlation_m");
  scatter.seed = json.at("seed").get<std::int64_t>();
  return scatter;
}

Plate plate(const Json& json) {
  Plate plate;
  plate.width = number(json, "width_m");
  plate.height = number(json, "height_m");
  plate.material = material(json.at("material"));
  plate.plane = choice<Plane>(json, "plane", plane_names);
  for (const Json& entry : json.at("cutouts"))
    plate.cutouts.push_back({shape(entry.at("shape")), entry.at("name").get<std::string>()});
  for (const Json& entry : json.at("inclusions"))
    plate.inclusions.push_back({shape(entry.at("shape")), material(entry.at("material"))});
  for (const Json& entry : json.at("cracks")) plate.cracks.push_back(crack(entry));
  for (const Json& entry : json.at("no_fail")) plate.no_fail.push_back(shape(entry));
  plate.scatter = scatter(json.at("strength"));
  return plate;
}

Numerics numerics(const Json& json) {
  Numerics numerics;
  numerics.spacing = number(json, "spacing_m");
  numerics.horizon = number(json, "horizon_m");
  numerics.quadrature = choice<Quadrature>(json, "quadrature", quadrature_names);
  numerics.micromodulus = choice<Micromodulus>(json, "micromodulus", micromodulus_names);
  numerics.constants = choice<Constants>(json, "constants", constants_names);
  numerics.breaking = choice<Breaking>(json, "breaking", breaking_names);
  numerics.step = number(json, "step_s");
  numerics.force_step = true;
  return numerics;
}

}  // namespace

Inputs read_inputs(const std::string& text) {
  try {
    const Json json = Json::parse(text);
    return {plate(json.at("plate")), numerics(json.at("numerics"))};
  } catch (const Json::exception& error) {
    refuse(error.what());
  }
}

}  // namespace hackle
