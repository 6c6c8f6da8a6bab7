// SPDX-License-Identifier: MIT
// The options of functions that load or support a plate, or a simulation between two runs.
#pragma once

#include <array>

#include "console/language/noun_options.hpp"
#include "console/language/region_options.hpp"
#include "scene/plate.hpp"

namespace hackle {

inline constexpr std::array axis_names = std::to_array<std::string_view>({"both", "x", "y"});

inline constexpr Option axis_option{.name = "axis",
                                    .type = OptionType::choice,
                                    .fallback = "both",
                                    .choices = axis_names,
                                    .sentence = "Axis along which it acts; the other stays free."};

inline constexpr auto body_force_options = joined(options_of<BodyForce>, region_options);

inline constexpr auto clamp_options = joined(
    std::array{axis_option, option_of<std::string>("name", about_load_name)}, region_options);

inline constexpr auto move_options = joined(
    joined(without("along_x", without("along_y", options_of<Support>)), std::array{axis_option}),
    region_options);

inline constexpr auto temperature_options = joined(options_of<ThermalLoad>, region_options);

inline constexpr auto impactor_options = joined(
    options_of<Impactor>,
    std::array{Option{.name = "density",
                      .unit = "kg/m3",
                      .range = above(0.0),
                      .fallback = "7850",
                      .sentence = "Density of the disc, instead of a mass; 7850 is steel."}});

// The numbers of Loads, all others of which are lists; p:damping calls them rate and stiffness.
inline constexpr auto damping_options = [] {
  auto options = options_of<Loads>;
  static_assert(options.size() == 2);
  options[0].name = "rate";
  options[1].name = "stiffness";
  return options;
}();

inline constexpr auto start_options = joined(options_of<InitialCondition>, region_options);

inline constexpr FunctionDoc plate_traction_doc{
    .name = "traction",
    .owner = "p",
    .sentence =
        "Pulls, pushes or shears an edge, the rim of a hole or an outline, or an arc of it.",
    .options = options_of<Traction>,
    .example =
        "p:traction { edge = \"top\", stress = {0, 12*MPa}, time = ramp(1*us) }\n"
        "p:hole { centre = {70*mm, 20*mm}, radius = 4*mm, name = \"bore\" }\n"
        "p:traction { rim = \"bore\", stress = {5*MPa, 0}, angles = {-30*deg, 30*deg} }"};
inline constexpr FunctionDoc plate_pressure_doc{
    .name = "pressure",
    .owner = "p",
    .sentence = "Applies a pressure to a rim or an arc of it, or to the faces of a crack.",
    .options = options_of<Pressure>,
    .example =
        "p:hole { centre = {70*mm, 20*mm}, radius = 4*mm, name = \"bore\" }\n"
        "p:pressure { rim = \"bore\", pressure = 5*MPa }\n"
        "p:crack { from = {20*mm, 20*mm}, to = {30*mm, 20*mm}, name = \"slit\" }\n"
        "p:pressure { rim = \"slit\", pressure = 2*MPa, time = ramp(5*us) }"};
inline constexpr FunctionDoc plate_body_force_doc{
    .name = "body_force",
    .owner = "p",
    .sentence = "Applies a force per volume to an area, or to the whole plate.",
    .options = body_force_options,
    .example = "p:body_force { force = {0, -2235*9.81} }"};
inline constexpr FunctionDoc plate_clamp_doc{
    .name = "clamp",
    .owner = "p",
    .sentence = "Holds the nodes of an area in place.",
    .options = clamp_options,
    .example = "p:clamp { edge = \"left\", depth = 2*mm }"};
inline constexpr FunctionDoc plate_move_doc{
    .name = "move",
    .owner = "p",
    .sentence = "Prescribes the motion of the nodes of an area.",
    .options = move_options,
    .example = "p:move { edge = \"top\", depth = 2*mm, velocity = {0, 5}, axis = \"y\" }"};
inline constexpr FunctionDoc plate_temperature_doc{
    .name = "temperature",
    .owner = "p",
    .sentence = "Heats or cools an area, or the whole plate; its bonds expand or shrink.",
    .options = temperature_options,
    .example =
        "p = plate { width = 10*mm, height = 4*mm, material = material { like = \"duran50\", "
        "alphaT = 3.3e-6 } }\n"
        "p:temperature { change = function(x, y) return -100*y/(4*mm) end }"};
inline constexpr FunctionDoc plate_impactor_doc{
    .name = "impactor",
    .owner = "p",
    .sentence = "Throws a rigid disc at the plate, in its plane.",
    .options = impactor_options,
    .example = "p:impactor { centre = {-6*mm, 20*mm}, radius = 5*mm, velocity = {50, 0} }"};
inline constexpr FunctionDoc plate_damping_doc{
    .name = "damping",
    .owner = "p",
    .sentence = "Damps all motion, or waves the more the shorter they are.",
    .options = damping_options,
    .example = "p:damping { rate = 1e5 }"};
inline constexpr FunctionDoc plate_start_doc{
    .name = "initial",
    .owner = "p",
    .sentence = "Sets the initial condition of an area, or of the whole plate; several add up.",
    .options = start_options,
    .example = "p:initial { velocity = function(x, y) return 0, 3*(y - 20*mm)/(20*mm) end }"};

// Of a load that introduces itself: its members are the options, and an area if it has a region.
template <class Load>
constexpr auto load_options = [] {
  if constexpr (requires(Load load) { load.region; })
    return joined(options_of<Load>, region_options);
  else
    return options_of<Load>;
}();
template <class Load>
inline constexpr FunctionDoc plate_load_doc{.name = description_of<Load>.noun,
                                            .owner = "p",
                                            .sentence = introduction_of<Load>.sentence,
                                            .options = load_options<Load>,
                                            .example = introduction_of<Load>.example};

// Returns the doc of the same method of a simulation: from then on, the load replaces the old one
// at the same place.
constexpr FunctionDoc of_simulation(FunctionDoc doc, std::string_view example) {
  doc.owner = "s";
  doc.example = example;
  return doc;
}

template <class Load>
inline constexpr FunctionDoc run_load_doc = of_simulation(plate_load_doc<Load>,
                                                          introduction_of<Load>.example_in_run);

inline constexpr FunctionDoc run_traction_doc = of_simulation(
    plate_traction_doc, "s:traction { edge = \"top\", stress = {0, 6*MPa} }  -- changes the load");
inline constexpr FunctionDoc run_pressure_doc =
    of_simulation(plate_pressure_doc,
                  "p:hole { centre = {70*mm, 20*mm}, radius = 4*mm, name = \"bore\" }\n"
                  "s = simulate(p, { spacing = 0.5*mm })\n"
                  "s:pressure { rim = \"bore\", pressure = 5*MPa }");
inline constexpr FunctionDoc run_body_force_doc =
    of_simulation(plate_body_force_doc, "s:body_force { force = {0, -2235*9.81} }");
inline constexpr FunctionDoc run_clamp_doc =
    of_simulation(plate_clamp_doc, "s:clamp { edge = \"left\", depth = 2*mm }");
inline constexpr FunctionDoc run_move_doc =
    of_simulation(plate_move_doc, "s:move { edge = \"top\", depth = 2*mm, velocity = {0, 5} }");
inline constexpr FunctionDoc run_temperature_doc = of_simulation(
    plate_temperature_doc,
    "p = plate { width = 10*mm, height = 4*mm, material = material { like = \"duran50\", alphaT = "
    "3.3e-6 } }\n"
    "s = simulate(p, { spacing = 0.5*mm })\n"
    "s:temperature { change = -100 }");
inline constexpr FunctionDoc run_impactor_doc =
    of_simulation(plate_impactor_doc,
                  "s:impactor { centre = {-6*mm, 20*mm}, radius = 5*mm, velocity = {50, 0} }");
inline constexpr FunctionDoc run_damping_doc =
    of_simulation(plate_damping_doc, "s:damping { rate = 1e5 }");
inline constexpr FunctionDoc release_doc{
    .name = "release",
    .owner = "s",
    .sentence = "Releases clamped or moved nodes in an area, or all of them.",
    .options = region_options,
    .example =
        "s:clamp { edge = \"left\", depth = 2*mm }\n"
        "s:release { edge = \"left\", depth = 2*mm }"};

inline constexpr std::array duration_option{Option{.name = "duration",
                                                   .unit = "s",
                                                   .range = above(0.0),
                                                   .required = true,
                                                   .sentence = "Time from 0 to 1."}};
inline constexpr std::array pulse_options{
    Option{.name = "duration",
           .unit = "s",
           .range = above(0.0),
           .required = true,
           .sentence = "Length of the pulse."},
    Option{.name = "start",
           .unit = "s",
           .range = at_least(0.0),
           .fallback = "0",
           .sentence = "Time at which it begins."},
};
inline constexpr std::array step_at_options{Option{.name = "start",
                                                   .unit = "s",
                                                   .range = at_least(0.0),
                                                   .required = true,
                                                   .sentence = "Time at which it begins."}};

inline constexpr FunctionDoc ramp_doc{
    .name = "ramp",
    .call = Call::values,
    .sentence = "An amplitude that rises linearly from 0 to 1 and stays there.",
    .options = duration_option,
    .example = "ramp(2*us)"};
inline constexpr FunctionDoc pulse_doc{
    .name = "pulse",
    .call = Call::values,
    .sentence = "An amplitude that is 1 during a pulse and 0 otherwise.",
    .options = pulse_options,
    .example = "pulse(1*us, 3*us)"};
inline constexpr FunctionDoc step_at_doc{.name = "step_at",
                                         .call = Call::values,
                                         .sentence = "An amplitude that steps from 0 to 1.",
                                         .options = step_at_options,
                                         .example = "step_at(5*us)"};

}  // namespace hackle
