// SPDX-License-Identifier: MIT
#include "store/inputs_reader.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "base/text.hpp"

namespace hackle {
namespace {

using Json = nlohmann::ordered_json;

constexpr int most_depth = 16;
// Sixteen bytes each, of a text that has two at least: of a crack they are nine.
constexpr std::int64_t most_values = 8'000'000;
constexpr std::int64_t most_cells = std::int64_t{1} << 24;  // of a picture, as when it was read
constexpr std::int64_t most_cells_in_all = 4 * most_cells;

[[noreturn]] void refuse(const std::string& what) {
  throw Error(ErrorKind::files, "the inputs of the run cannot be read: " + what);
}

void stop_if_interrupted() {
  if (interrupted())
    throw Error(ErrorKind::interrupted, "interrupted while the inputs of a run were read");
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
  if (found == names.end()) refuse(fmt::format("{} is none of {}", name, comma_list(names)));
  return static_cast<Enum>(found - names.begin());
}

bool is_function(const Json& json) {
  return json.is_object() || json == "function";
}

[[noreturn]] void refuse_function() {
  throw Error(ErrorKind::files, "functions of a script are not in its run file",
              "run the script again");
}

VectorField vector_field(const Json& json) {
  if (is_function(json)) return VectorField([](const Vec2&) -> Vec2 { refuse_function(); });
  return vector(json);
}

ScalarField scalar_field(const Json& json) {
  if (is_function(json)) return ScalarField([](const Vec2&) -> double { refuse_function(); });
  return json.get<double>();
}

Course course(const Json& json) {
  if (json == "constant") return {};
  if (json.is_array()) return Course(points(json));
  const Json& text = json.is_object() ? json.at("function") : json;
  return Course([](double) -> double { refuse_function(); }, text.get<std::string>());
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

// The numbers of "12 3 40".
std::vector<std::int64_t> lengths_in(const std::string& text) {
  std::vector<std::int64_t> list;
  const char* const end = text.data() + text.size();
  for (const char* at = text.data(); at < end; ++at) {
    std::int64_t length = 0;
    const auto [rest, failure] = std::from_chars(at, end, length);
    if (failure != std::errc() || (rest != end && *rest != ' ')) refuse("a picture is no picture");
    list.push_back(length);
    at = rest;
  }
  return list;
}

// Counts the cells of all pictures.
class Cells {
 public:
  // From how many cells in a row are outside, then inside, and so on; a text or a list.
  std::vector<std::uint8_t> read(const Json& run_lengths, std::int64_t count) {
    if (count < 0 || count > most_cells) refuse("a picture is too large");
    if ((all_ += count) > most_cells_in_all) refuse("its pictures are too many");
    stop_if_interrupted();
    const auto lengths = run_lengths.is_string()
                             ? lengths_in(run_lengths.get_ref<const std::string&>())
                             : run_lengths.get<std::vector<std::int64_t>>();
    return cells(lengths, count);
  }

 private:
  static std::vector<std::uint8_t> cells(const std::vector<std::int64_t>& lengths,
                                         std::int64_t count) {
    std::vector<std::uint8_t> list;
    std::uint8_t value = 0;
    for (const std::int64_t length : lengths) {
      const auto room = count - static_cast<std::int64_t>(list.size());
      if (length < 0 || length > room) refuse("a picture has too many cells");
      list.insert(list.end(), static_cast<std::size_t>(length), value);
      value = value == 0 ? 1 : 0;
    }
    if (static_cast<std::int64_t>(list.size()) != count) refuse("a picture has too few cells");
    return list;
  }

  std::int64_t all_ = 0;
};

Bitmap bitmap(const Json& json, Cells& cells) {
  Bitmap bitmap{vector(json.at("from_m")),
                vector(json.at("to_m")),
                json.at("columns").get<int>(),
                json.at("rows").get<int>(),
                {}};
  if (bitmap.columns < 1 || bitmap.rows < 1) refuse("a picture has no cells");
  const auto count = std::int64_t{bitmap.columns} * bitmap.rows;
  bitmap.inside = cells.read(json.at("run_lengths"), count);
  return bitmap;
}

Shape shape(const Json& json, Cells& cells) {
  const auto kind = json.at("kind").get<std::string>();
  if (kind == "ellipse")
    return Ellipse{vector(json.at("centre_m")), vector(json.at("radii_m")), number(json, "angle")};
  if (kind == "polygon") return Polygon{points(json.at("points_m"))};
  if (kind == "slot")
    return Capsule{{vector(json.at("from_m")), vector(json.at("to_m"))}, number(json, "radius_m")};
  if (kind == "picture") return bitmap(json, cells);
  refuse("a shape is none of ellipse, polygon, slot, picture");
}

Region region(const Json& json, Cells& cells) {
  if (json.is_string()) return std::nullopt;
  return shape(json, cells);
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

std::optional<Contact> contact(const Json& plate) {
  if (!plate.contains("contact") || plate.at("contact").is_string()) return std::nullopt;
  const Json& json = plate.at("contact");
  return Contact{number(json, "stiffness"), number(json, "reach")};
}

Traction traction(const Json& json) {
  const std::optional<Edge> edge = edge_named(json.at("edge").get<std::string>());
  if (!edge) refuse("an edge is none of left, right, bottom, top");
  return {*edge, vector_field(json.at("stress_Pa")), number(json, "depth_m"),
          course(json.at("time"))};
}

Support support(const Json& json, Cells& cells) {
  const bool velocity = json.contains("velocity_m_s");
  return {region(json.at("region"), cells),
          velocity ? Support::Kind::velocity : Support::Kind::displacement,
          vector_field(json.at(velocity ? "velocity_m_s" : "displacement_m")),
          json.at("along_x").get<bool>(),
          json.at("along_y").get<bool>(),
          course(json.at("time"))};
}

Loads loads(const Json& json, Cells& cells) {
  Loads loads;
  for (const Json& load : json.at("tractions")) loads.tractions.push_back(traction(load));
  for (const Json& load : json.at("pressures"))
    loads.pressures.push_back(
        {load.at("rim").get<std::string>(), number(load, "pressure_Pa"), course(load.at("time"))});
  for (const Json& load : json.at("body_forces"))
    loads.body_forces.push_back({region(load.at("region"), cells),
                                 vector_field(load.at("force_N_m3")), course(load.at("time"))});
  for (const Json& load : json.at("supports")) loads.supports.push_back(support(load, cells));
  for (const Json& load : json.at("temperatures"))
    loads.heatings.push_back({region(load.at("region"), cells), scalar_field(load.at("change_K")),
                              course(load.at("time"))});
  for (const Json& load : json.at("impactors"))
    loads.impactors.push_back({vector(load.at("centre_m")), number(load, "radius_m"),
                               vector(load.at("velocity_m_s")), number(load, "mass_kg_m")});
  loads.damping = number(json, "damping_1_s");
  return loads;
}

Plate plate(const Json& json) {
  Plate plate;
  Cells cells;
  plate.width = number(json, "width_m");
  plate.height = number(json, "height_m");
  plate.material = material(json.at("material"));
  plate.plane = choice<Plane>(json, "plane", plane_names);
  for (const Json& entry : json.at("cutouts"))
    plate.cutouts.push_back({shape(entry.at("shape"), cells), entry.at("name").get<std::string>()});
  for (const Json& entry : json.at("inclusions"))
    plate.inclusions.push_back({shape(entry.at("shape"), cells), material(entry.at("material"))});
  for (const Json& entry : json.at("cracks")) plate.cracks.push_back(crack(entry));
  for (const Json& entry : json.at("no_fail")) plate.no_fail.push_back(shape(entry, cells));
  for (const Json& entry : json.at("starts"))
    plate.starts.push_back({region(entry.at("region"), cells),
                            vector_field(entry.at("displacement_m")),
                            vector_field(entry.at("velocity_m_s"))});
  plate.scatter = scatter(json.at("strength"));
  plate.contact = contact(json);
  plate.loads = loads(json, cells);
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
  numerics.precision = choice<Precision>(json, "precision", precision_names);
  numerics.fused = json.at("fused").get<bool>();
  numerics.fidelity = number(json, "fidelity");
  if (json.at("step_s").is_number()) numerics.step = number(json, "step_s");
  numerics.force_step = json.value("force_step", false);
  return numerics;
}

// Refuses what goes deeper, or holds more, than what inputs_of() writes, before it takes memory.
class Bounds {
 public:
  bool operator()(int depth, Json::parse_event_t event, Json&) {
    if (depth > most_depth) refuse("it goes too deep");
    if (event == Json::parse_event_t::object_end || event == Json::parse_event_t::array_end)
      return true;
    if (++values_ > most_values) refuse(fmt::format("it holds more than {} values", most_values));
    constexpr std::int64_t now_and_then = 4096;
    if (values_ % now_and_then == 0) stop_if_interrupted();
    return true;
  }

 private:
  std::int64_t values_ = 0;
};

}  // namespace

Inputs read_inputs(const std::string& text) {
  try {
    const Json json = Json::parse(text, Bounds());
    return {plate(json.at("plate")), numerics(json.at("numerics"))};
  } catch (const Json::parse_error& error) {  // whose words are those of the text
    refuse(fmt::format("it is no JSON at byte {}", error.byte));
  } catch (const Json::out_of_range&) {
    refuse("something is missing or too large");
  } catch (const Json::exception&) {
    refuse("something is of another type");
  }
}

}  // namespace hackle
