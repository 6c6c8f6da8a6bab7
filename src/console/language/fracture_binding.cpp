// SPDX-License-Identifier: MIT
#include "console/language/fracture_binding.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "console/language/scripted_recording.hpp"
#include "console/language/scripted_run.hpp"
#include "console/schema/arguments.hpp"
#include "console/schema/object_type.hpp"
#include "console/schema/result_table.hpp"
#include "measure/fracture.hpp"
#include "measure/fragment_list.hpp"
#include "output/files/fragments_file.hpp"

namespace hackle {
namespace {

constexpr std::array fragments_options{
    Option{.name = "file",
           .type = OptionType::text,
           .positional = true,
           .fallback = "none",
           .sentence = "Also writes the list there, .csv; relative to the output folder."},
};
constexpr FunctionDoc fragments_doc{
    .name = "fragments",
    .owner = "s",
    .sentence =
        "Lists the fragments, the parts that bonds hold together, the largest first: number (as "
        "in pictures of the field), nodes, area (m2), diameter (of a disc of that area, m), "
        "passing (the share of the area in it and in smaller ones, as a sieve tells it), mass "
        "(kg/m), x, y (its centre now, m), vx, vy (m/s), spin (rad/s, anticlockwise), kinetic "
        "(J/m). Nodes without bonds are none.",
    .options = fragments_options,
    .example = "f = s:fragments() print(#f, f[1].area, f[1].spin)\ns:fragments \"frag.csv\""};
constexpr FunctionDoc recorded_fragments_doc{
    .name = "fragments",
    .owner = "r",
    .sentence = "Lists the fragments in the record that is shown.",
    .options = fragments_options,
    .example = "print(#r:fragments { \"recorded.csv\" })"};

constexpr std::array fracture_options{
    Option{.name = "tip",
           .type = OptionType::point,
           .unit = "m",
           .positional = true,
           .fallback = "farthest along",
           .sentence = "Place of the tip, on the plate before it moves."},
    Option{.name = "direction",
           .type = OptionType::point,
           .fallback = "found",
           .sentence = "Vector along the crack, out of it; by default away from what is open "
                       "within three horizons of the tip."},
    Option{.name = "along",
           .type = OptionType::point,
           .fallback = "{1, 0}",
           .sentence = "Vector; without a tip that one is taken which lies farthest along it."},
    Option{.name = "radii",
           .type = OptionType::numbers,
           .unit = "m",
           .range = at_least(1.0),
           .fallback = "four, as far as the plate is the same",
           .sentence = "Radii of the rings around the tip, each at least two horizons."},
};
constexpr FunctionDoc fracture_doc{
    .name = "fracture",
    .owner = "s",
    .sentence =
        "Measures what drives a crack, at rest or in motion: J (J/m2, from the bonds, the mean of "
        "rings around the tip), spread (of the rings, over J), G0 (of a straight cut ahead), "
        "J_over_G0; K_J = sqrt(E' J), K_I and K_II by interaction integrals, williams_K_I, "
        "williams_K_II, williams_T (Pa) and williams_misfit by a fit of displacements; Pa "
        "sqrt(m). Also x, y, dx, dy (tip and direction), clear and clear_all_round (m, how far the "
        "plate is the same along the crack, for J, and without an edge, for K: nil beyond) and "
        "rings, a list of radius, width, J, K_I, K_II.",
    .options = fracture_options,
    .example =
        "s:relax()\nf = s:fracture()\nprint(f.J_over_G0, f.spread, f.K_I, f.williams_K_I)\n"
        "print(s:fracture { tip = {50*mm, 20*mm}, radii = {16*mm, 18*mm} }.J)"};
constexpr FunctionDoc recorded_fracture_doc{
    .name = "fracture",
    .owner = "r",
    .sentence = "Measures the same in the record that is shown.",
    .options = fracture_options,
    .example = "print(r:fracture { radii = {16*mm} }.J)"};

constexpr auto fragment_names =
    std::to_array<std::string_view>({"number", "nodes", "area", "diameter", "passing", "mass", "x",
                                     "y", "vx", "vy", "spin", "kinetic"});
constexpr auto fracture_names = std::to_array<std::string_view>(
    {"x", "y", "dx", "dy", "clear", "clear_all_round", "J", "spread", "G0", "J_over_G0", "K_J",
     "K_I", "K_II", "williams_K_I", "williams_K_II", "williams_T", "williams_misfit", "rings"});
constexpr auto ring_names =
    std::to_array<std::string_view>({"radius", "width", "J", "K_I", "K_II"});

void set_vector(lua_State* L, const char* x, const char* y, const Vec2& vector) {
  set_number(L, x, vector.x());
  set_number(L, y, vector.y());
}

constexpr double none = std::numeric_limits<double>::infinity();

void set_if_finite(lua_State* L, const char* name, double value) {
  if (std::isfinite(value)) set_number(L, name, value);
}

void push_fragment(lua_State* L, const MeasuredFragment& one) {
  lua_createtable(L, 0, fragment_names.size());
  close_names(L, "s:fragments()", fragment_names);
  set_integer(L, "number", one.number);
  set_integer(L, "nodes", one.nodes);
  set_number(L, "area", one.area);
  set_number(L, "diameter", one.diameter());
  set_number(L, "passing", one.passing);
  set_number(L, "mass", one.mass);
  set_vector(L, "x", "y", one.centre);
  set_vector(L, "vx", "vy", one.velocity);
  set_number(L, "spin", one.spin);
  set_number(L, "kinetic", one.kinetic);
}

// [-0, +1] Pushes the values as a list.
template <class Value>
void push_list(lua_State* L, const std::vector<Value>& values,
               void (*push)(lua_State*, const Value&)) {
  lua_createtable(L, static_cast<int>(values.size()), 0);
  lua_Integer place = 0;
  for (const Value& value : values) {
    push(L, value);
    lua_rawseti(L, -2, ++place);
  }
}

int list_fragments(lua_State* L, const View& view, const FunctionDoc& doc) {
  const Arguments arguments = Arguments::from_table(L, 2, doc);
  arguments.problems.throw_if_any();
  Session& session = session_of(L);
  const bool writes = arguments.has("file");
  const auto path =
      writes ? session.claim("fragments", arguments.text("file"), FileKind::table) : "";
  const FragmentList found = measured_fragments(view);
  if (writes && session.settings.purpose == Purpose::results) {
    write_fragments(found, path);
    session.names->complete(path);
  }
  push_list(L, found.all, push_fragment);
  return 1;
}

struct MeasuredRing {
  ContourRing ring;
  RingIntegrals on_it;
};

void push_ring(lua_State* L, const MeasuredRing& one) {
  lua_createtable(L, 0, ring_names.size());
  close_names(L, "a ring of s:fracture{}", ring_names);
  set_number(L, "radius", one.ring.radius);
  set_number(L, "width", one.ring.width);
  set_number(L, "J", one.on_it.J);
  set_number(L, "K_I", one.on_it.K_I);
  set_number(L, "K_II", one.on_it.K_II);
}

void push_fracture(lua_State* L, const Fracture& found) {
  lua_createtable(L, 0, fracture_names.size());
  close_names(L, "s:fracture{}", fracture_names);
  set_vector(L, "x", "y", found.frame.tip);
  set_vector(L, "dx", "dy", found.frame.ahead);
  set_if_finite(L, "clear", found.clear.along);
  set_if_finite(L, "clear_all_round", found.clear.all_round);
  set_number(L, "J", found.J());
  set_number(L, "spread", found.spread());
  set_number(L, "G0", found.G0);
  set_number(L, "J_over_G0", found.J() / found.G0);
  set_number(L, "K_J", found.K_J());
  set_if_finite(L, "K_I", found.K_I().value_or(none));
  set_if_finite(L, "K_II", found.K_II().value_or(none));
  if (found.williams) {
    set_number(L, "williams_K_I", found.williams->K_I);
    set_number(L, "williams_K_II", found.williams->K_II);
    set_number(L, "williams_T", found.williams->T);
    set_number(L, "williams_misfit", found.williams->misfit);
  }
  std::vector<MeasuredRing> rings;
  for (std::size_t k = 0; k < found.rings.size(); ++k)
    rings.push_back({found.rings[k], found.on_rings[k]});
  push_list(L, rings, push_ring);
  lua_setfield(L, -2, "rings");
}

// Returns the vector, or adds a problem where it has no direction.
std::optional<Vec2> direction_in(Arguments& arguments, const char* name) {
  if (!arguments.has(name) || !arguments.good({name})) return std::nullopt;
  const Vec2 given = arguments.point(name);
  if (given.norm() > 0.0) return given;
  arguments.problems.add(fmt::format("fracture: {} is {{0, 0}}, which is no direction", name),
                         "as in {1, 0}");
  return std::nullopt;
}

int measure_fracture(lua_State* L, const View& view, const FunctionDoc& doc) {
  Arguments arguments = Arguments::from_table(L, 2, doc);
  FractureOptions options;
  if (arguments.has("tip")) options.tip = arguments.point("tip");
  options.ahead = direction_in(arguments, "direction");
  options.along = direction_in(arguments, "along").value_or(options.along);
  options.radii = arguments.get<std::vector<double>>("radii", {});
  arguments.problems.throw_if_any();
  push_fracture(L, fracture(view, options));
  return 1;
}

int fragments_of_run(lua_State* L) {
  return list_fragments(L, self<ScriptedRun>(L, fragments_doc).results(), fragments_doc);
}
int fragments_of_recording(lua_State* L) {
  return list_fragments(L, self<ScriptedRecording>(L, recorded_fragments_doc).recording->view(),
                        recorded_fragments_doc);
}
int fracture_of_run(lua_State* L) {
  return measure_fracture(L, self<ScriptedRun>(L, fracture_doc).results(), fracture_doc);
}
int fracture_of_recording(lua_State* L) {
  return measure_fracture(L, self<ScriptedRecording>(L, recorded_fracture_doc).recording->view(),
                          recorded_fracture_doc);
}

}  // namespace

std::span<const Function> fracture_methods() {
  static constexpr std::array methods{Function{&fragments_doc, guarded<fragments_of_run>},
                                      Function{&fracture_doc, guarded<fracture_of_run>}};
  return methods;
}

std::span<const Function> recorded_fracture_methods() {
  static constexpr std::array methods{
      Function{&recorded_fragments_doc, guarded<fragments_of_recording>},
      Function{&recorded_fracture_doc, guarded<fracture_of_recording>}};
  return methods;
}

}  // namespace hackle
