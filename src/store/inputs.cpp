// SPDX-License-Identifier: MIT
#include "store/inputs.hpp"

#include <iterator>
#include <type_traits>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "store/json_key.hpp"

namespace hackle {
namespace {

using Json = nlohmann::ordered_json;

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

template <Described Noun>
Json to_json(const Noun& noun);

Json to_json(const Vec2& vector) {
  return Json::array({vector.x(), vector.y()});
}

// A function can only be written as its text; the function itself is in the script.
Json function_json(const std::string& text) {
  return {{"function", text}};
}

Json to_json(const Amplitude& amplitude) {
  if (amplitude.is_function()) return function_json(amplitude.describe());
  if (amplitude.is_constant()) return "constant";
  Json list = Json::array();
  for (const Vec2& point : amplitude.points()) list.push_back(to_json(point));
  return list;
}

template <class T>
Json to_json(const FieldOfPlace<T>& field) {
  if (!field.is_constant()) return function_json("of place");
  if constexpr (std::is_same_v<T, double>)
    return field.constant();
  else
    return to_json(field.constant());
}

Json to_json(const Shape& shape) {
  Json json = {{"kind", kind_of(shape)}};
  std::visit([&](const auto& kind) { json.update(to_json(kind)); }, shape);
  return json;
}

// Writes run lengths, cells outside first, then inside, and so on: "12 3 40". It is a text because
// a list would take a line per number.
std::string to_json(const std::vector<std::uint8_t>& cells) {
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

template <class T>
Json to_json(const std::vector<T>& things) {
  Json list = Json::array();
  for (const T& thing : things) list.push_back(to_json(thing));
  return list;
}

template <class T>
Json value_json(const T& value, const About& about) {
  if constexpr (is_optional<T>) {
    return value ? value_json(*value, about) : Json(about.nothing);
  } else if constexpr (std::is_enum_v<T>) {
    return name_of(value);
  } else if constexpr (requires { to_json(value); }) {
    return to_json(value);
  } else {
    return value;
  }
}

template <Described Noun>
Json to_json(const Noun& noun) {
  Json json = Json::object();
  for_each_member<Noun>([&](const auto& member) {
    const auto& value = noun.*member.pointer;
    if constexpr (requires { member.kind; }) {
      const auto kind = static_cast<std::size_t>(noun.*member.kind);
      json[key_of(member.names[kind], member.abouts[kind].unit)] =
          value_json(value, member.abouts[kind]);
    } else if (member.name.empty()) {
      json.update(value_json(value, member.about));
    } else {
      json[key_of(member.name, member.about.unit)] = value_json(value, member.about);
    }
  });
  return json;
}

// Replaces defaults by the values of the run.
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
  // The name of a material may contain invalid UTF-8.
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
