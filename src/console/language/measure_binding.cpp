// SPDX-License-Identifier: MIT
#include "console/language/measure_binding.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "console/language/scripted_run.hpp"
#include "console/schema/arguments.hpp"
#include "console/schema/object_type.hpp"
#include "console/schema/result_table.hpp"
#include "measure/bond_field.hpp"
#include "measure/cracks.hpp"

namespace hackle {
namespace {

constexpr std::array cracks_options{
    Option{.name = "from",
           .type = OptionType::point,
           .unit = "m",
           .alternative = true,
           .sentence = "Lower left corner of the area; default: the whole plate."},
    Option{.name = "to",
           .type = OptionType::point,
           .unit = "m",
           .alternative = true,
           .sentence = "Upper right corner of the area."},
};
constexpr FunctionDoc cracks_doc{
    .name = "cracks",
    .owner = "s",
    .sentence =
        "Finds the nodes that have lost more than 0.35 of their bonds: nodes, left, right, bottom, "
        "top, bands (the largest number one above another, a horizon apart), fork (x where the "
        "middle lines of two branches meet, the first from the left, or nil).",
    .options = cracks_options,
    .example = "tip = s:cracks { from = {0, 10*mm}, to = {100*mm, 30*mm} }.right"};

constexpr std::array at_options{
    Option{.name = "place",
           .type = OptionType::point,
           .unit = "m",
           .required = true,
           .sentence = "Point; the nearest node is taken."},
};
constexpr FunctionDoc at_doc{
    .name = "at",
    .owner = "s",
    .call = Call::values,
    .sentence =
        "Returns the state of one node: x, y (initial position), ux, uy (m), vx, vy (m/s), damage, "
        "stress_xx, stress_yy, stress_xy (Pa), energy (J/m3), stretch (the largest of its bonds, "
        "over s0), temperature (its change, K). Costs the same on any plate.",
    .options = at_options,
    .example = "print(s:at({50*mm, 30*mm}).uy)"};

constexpr auto cracks_names =
    std::to_array<std::string_view>({"nodes", "bands", "fork", "left", "right", "bottom", "top"});
constexpr auto node_names =
    std::to_array<std::string_view>({"x", "y", "ux", "uy", "vx", "vy", "damage", "stress_xx",
                                     "stress_yy", "stress_xy", "energy", "stretch", "temperature"});

void push_cracks(lua_State* L, const Cracks& found) {
  lua_createtable(L, 0, 7);
  close_names(L, "s:cracks()", cracks_names);
  set_integer(L, "nodes", found.nodes);
  set_integer(L, "bands", found.bands);
  if (found.fork) set_number(L, "fork", *found.fork);
  if (found.nodes == 0) return;
  set_number(L, "left", found.box.min.x());
  set_number(L, "right", found.box.max.x());
  set_number(L, "bottom", found.box.min.y());
  set_number(L, "top", found.box.max.y());
}

// Returns the given area, or everything.
Box area_of(Arguments& arguments) {
  if (arguments.has("from") != arguments.has("to"))
    arguments.problems.add("cracks: from and to are given together or not at all");
  if (!arguments.has("from") || !arguments.has("to")) return everywhere();
  Box area{arguments.point("from"), arguments.point("to")};
  if ((area.min.array() >= area.max.array()).any())
    arguments.problems.add("cracks: the area is empty", "from is its lower left corner");
  return area;
}

int find_cracks(lua_State* L) {
  const Simulation& simulation = self<ScriptedRun>(L, cracks_doc).results();
  Arguments arguments = Arguments::from_table(L, 2, cracks_doc);
  const Box area = area_of(arguments);
  arguments.problems.throw_if_any();
  push_cracks(L, cracks(simulation, area));
  return 1;
}

// Returns the column or row of the node nearest to `x` spacings from the lower left corner.
int nearest(double x, int count, const char* axis) {
  if (!(x >= 0.0 && x <= count))
    throw Error(ErrorKind::refused,
                fmt::format("at: the place lies beyond the plate along {}", axis),
                "the origin is its lower left corner");
  return std::min(static_cast<int>(x), count - 1);
}

void set_point(lua_State* L, const char* x, const char* y, const Vec2& point) {
  set_number(L, x, point.x());
  set_number(L, y, point.y());
}

int at(lua_State* L) {
  const Simulation& simulation = self<ScriptedRun>(L, at_doc).results();
  const Arguments arguments = Arguments::from_values(L, 2, at_doc);
  arguments.problems.throw_if_any();
  const Grid& grid = simulation.lattice().grid;
  const Vec2 place = grid.from_centre(arguments.point("place"));
  const int i = nearest(place.x() + 0.5 * grid.nx, grid.nx, "x");
  const int j = nearest(place.y() + 0.5 * grid.ny, grid.ny, "y");
  const View view = simulation.view();
  const BondsOfNode bonds = bonds_of_node(view, i, j);
  lua_createtable(L, 0, node_names.size());
  close_names(L, "s:at()", node_names);
  set_point(L, "x", "y", grid.position(i, j));
  set_point(L, "ux", "uy", view.displacement(i, j));
  set_point(L, "vx", "vy", view.velocity(i, j));
  set_number(L, "damage", damage_of(view, i, j));
  set_number(L, "stress_xx", bonds.stress.xx);
  set_number(L, "stress_yy", bonds.stress.yy);
  set_number(L, "stress_xy", bonds.stress.xy);
  set_number(L, "energy", bonds.energy);
  set_number(L, "stretch", bonds.closeness);
  set_number(L, "temperature", temperature_of(view, i, j));
  return 1;
}

}  // namespace

std::span<const Function> measure_methods() {
  static constexpr std::array methods{Function{&cracks_doc, guarded<find_cracks>},
                                      Function{&at_doc, guarded<at>}};
  return methods;
}

}  // namespace hackle
