// SPDX-License-Identifier: MIT
#include "console/plate_binding.hpp"

#include <array>
#include <vector>

#include "console/arguments.hpp"
#include "console/strength_binding.hpp"

namespace hackle {
namespace {

// In the order of the enumerators.
constexpr std::array<std::string_view, 4> edge_names{"left", "right", "bottom", "top"};
constexpr std::array<std::string_view, 2> born_names{"broken", "absent"};

constexpr std::array plate_options{
    Option{.name = "width",
           .unit = "m",
           .range = above(0.0),
           .required = true,
           .sentence = "Size along x."},
    Option{.name = "height",
           .unit = "m",
           .range = above(0.0),
           .required = true,
           .sentence = "Size along y."},
    Option{.name = "material",
           .type = OptionType::material,
           .required = true,
           .sentence = "What it is made of."},
    Option{.name = "plane",
           .type = OptionType::choice,
           .fallback = "stress",
           .choices = plane_names,
           .sentence = "Plane stress for a thin plate, plane strain for a thick one."},
};

constexpr FunctionDoc plate_doc{
    .name = "plate",
    .sentence = "A rectangular plate; its lower left corner is the origin, x right, y up.",
    .options = plate_options,
    .example = "p = plate { width = 100*mm, height = 40*mm, material = \"duran50\" }"};

constexpr std::array crack_options{
    Option{.name = "from",
           .type = OptionType::point,
           .unit = "m",
           .required = true,
           .sentence = "One end, on the plate."},
    Option{.name = "to",
           .type = OptionType::point,
           .unit = "m",
           .required = true,
           .sentence = "The other end, on the plate."},
    Option{.name = "born",
           .type = OptionType::choice,
           .fallback = "broken",
           .choices = born_names,
           .sentence = "Whether the bonds it cuts count as damage or were never there."},
};

constexpr FunctionDoc crack_doc{.name = "crack",
                                .owner = "p",
                                .sentence = "Cuts every bond that a straight crack crosses.",
                                .options = crack_options,
                                .example = "p:crack { from = {0, 20*mm}, to = {50*mm, 20*mm} }"};

constexpr std::array traction_options{
    Option{.name = "edge",
           .type = OptionType::choice,
           .required = true,
           .choices = edge_names,
           .sentence = "The edge it acts on, all along."},
    Option{.name = "stress",
           .type = OptionType::point,
           .unit = "Pa",
           .required = true,
           .sentence = "Force on the edge per area, from time zero on; positive right and up."},
};

constexpr FunctionDoc traction_doc{
    .name = "traction",
    .owner = "p",
    .sentence = "Pulls, pushes or shears an edge with a constant stress.",
    .options = traction_options,
    .example = "p:traction { edge = \"top\", stress = {0, 12*MPa} }"};

constexpr std::array nofail_options{
    Option{.name = "edge",
           .type = OptionType::choice,
           .choices = edge_names,
           .sentence = "The edge of a strip, with depth."},
    Option{.name = "depth",
           .unit = "m",
           .range = above(0.0),
           .sentence = "How far the strip reaches into the plate; one horizon is usual."},
    Option{.name = "from",
           .type = OptionType::point,
           .unit = "m",
           .sentence = "Lower left corner of a rectangle, instead of edge and depth."},
    Option{.name = "to",
           .type = OptionType::point,
           .unit = "m",
           .sentence = "Upper right corner of the rectangle."},
};

constexpr FunctionDoc nofail_doc{
    .name = "nofail",
    .owner = "p",
    .sentence = "A strip along an edge, or a rectangle, in which no bond breaks.",
    .options = nofail_options,
    .example = "p:nofail { edge = \"top\", depth = 2*mm }"};

int make_plate(lua_State* L) {
  Arguments arguments = Arguments::from_table(L, 1, plate_doc);
  arguments.problems.throw_if_any();
  Plate plate;
  plate.width = arguments.number("width");
  plate.height = arguments.number("height");
  plate.material = arguments.material("material");
  plate.plane = arguments.choice<Plane>("plane");
  check(plate, arguments.problems);
  arguments.problems.throw_if_any();
  push_object(L, std::move(plate));
  return 1;
}

// The plate itself, so that calls can be chained.
int return_self(lua_State* L) {
  lua_settop(L, 1);
  return 1;
}

int add_crack(lua_State* L) {
  Plate& plate = self<Plate>(L, crack_doc);
  Arguments arguments = Arguments::from_table(L, 2, crack_doc);
  const Crack crack{arguments.point("from"), arguments.point("to"), arguments.choice<Born>("born")};
  if (arguments.has("from") && arguments.has("to")) check(plate, crack, arguments.problems);
  arguments.problems.throw_if_any();
  plate.cracks.push_back(crack);
  return return_self(L);
}

int add_traction(lua_State* L) {
  Plate& plate = self<Plate>(L, traction_doc);
  Arguments arguments = Arguments::from_table(L, 2, traction_doc);
  arguments.problems.throw_if_any();
  plate.loads.tractions.push_back({arguments.choice<Edge>("edge"), arguments.point("stress")});
  return return_self(L);
}

// Either edge and depth or from and to.
void check_one_way(Arguments& arguments) {
  const bool strip = arguments.has("edge") || arguments.has("depth");
  const bool rectangle = arguments.has("from") || arguments.has("to");
  const bool whole_strip = arguments.has("edge") && arguments.has("depth");
  const bool whole_rectangle = arguments.has("from") && arguments.has("to");
  const bool good = arguments.good({"edge", "depth", "from", "to"});
  if (!good || (whole_strip && !rectangle) || (whole_rectangle && !strip)) return;
  arguments.problems.add("nofail: the zone is not clear",
                         "give edge and depth, or from and to, and not both");
}

int add_nofail(lua_State* L) {
  Plate& plate = self<Plate>(L, nofail_doc);
  Arguments arguments = Arguments::from_table(L, 2, nofail_doc);
  check_one_way(arguments);
  arguments.problems.throw_if_any();
  const Shape zone = arguments.has("edge")
                         ? strip(plate, arguments.choice<Edge>("edge"), arguments.number("depth"))
                         : rectangle(arguments.point("from"), arguments.point("to"));
  check_no_fail(plate, zone, arguments.problems);
  arguments.problems.throw_if_any();
  plate.no_fail.push_back(zone);
  return return_self(L);
}

constexpr std::array functions{Function{&plate_doc, guarded<make_plate>}};
constexpr std::array methods{Function{&crack_doc, guarded<add_crack>},
                             Function{&traction_doc, guarded<add_traction>},
                             Function{&nofail_doc, guarded<add_nofail>}};

int to_text(lua_State* L) {
  push_text(L, describe(*object_at<Plate>(L, 1)));
  return 1;
}

template <double Plate::*value>
int push_value(lua_State* L) {
  lua_pushnumber(L, object_at<Plate>(L, 1)->*value);
  return 1;
}

constexpr std::array fields{
    Property{"width", "m", "Size along x.", push_value<&Plate::width>},
    Property{"height", "m", "Size along y.", push_value<&Plate::height>},
};

// Of all files that bind methods of a plate.
std::vector<Function> all_methods() {
  std::vector<Function> all;
  for (const std::span<const Function> part :
       {std::span<const Function>(methods), strength_methods()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace

const TypeDoc& plate_type() {
  static const std::vector<Function> all = all_methods();
  static const TypeDoc type{.name = "plate",
                            .sentence = "A plate with its cracks and loads; simulate copies it.",
                            .methods = all,
                            .fields = fields,
                            .to_text = guarded<to_text>,
                            .destroy = destroy_object<Plate>};
  return type;
}

std::span<const Function> plate_functions() {
  return functions;
}

}  // namespace hackle
