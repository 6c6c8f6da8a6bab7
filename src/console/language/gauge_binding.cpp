// SPDX-License-Identifier: MIT
#include "console/language/gauge_binding.hpp"

#include <array>
#include <string>

#include <fmt/format.h>

#include "base/units.hpp"
#include "console/language/region_options.hpp"
#include "console/language/scripted_recording.hpp"
#include "console/language/scripted_run.hpp"
#include "console/lua/description.hpp"
#include "console/schema/arguments.hpp"
#include "console/schema/object_type.hpp"
#include "measure/node_value.hpp"
#include "scene/load_names.hpp"

namespace hackle {
namespace {

constexpr std::array gauge_options{
    Option{.name = "kind",
           .type = OptionType::choice,
           .required = true,
           .positional = true,
           .choices = enum_names<Gauge::Kind>,
           .sentence = "A quantity at a point, its mean along a line or over the nodes of a "
                       "region; extension between two places, strain: that over their distance; "
                       "opening along the line between them, sliding across it."},
    Option{.name = "of",
           .type = OptionType::choice,
           .fallback = "uy",
           .choices = node_quantity_names,
           .sentence = "Quantity of a point, a line or a region."},
    Option{.name = "at",
           .type = OptionType::point,
           .unit = "m",
           .alternative = true,
           .sentence = "Place of a point, on the plate before it moves, as all places."},
    Option{.name = "from",
           .type = OptionType::point,
           .unit = "m",
           .alternative = true,
           .sentence = "One end of a line, one of two places, or the lower left corner of a "
                       "region."},
    Option{.name = "to",
           .type = OptionType::point,
           .unit = "m",
           .alternative = true,
           .sentence = "The other end, place or corner."},
    Option{.name = "centre",
           .type = OptionType::point,
           .unit = "m",
           .alternative = true,
           .sentence = "Centre of a region that is a disc."},
    Option{.name = "radius",
           .unit = "m",
           .range = above(0.0),
           .alternative = true,
           .sentence = "Radius of the disc."},
    Option{.name = "name",
           .type = OptionType::text,
           .fallback = "its kind",
           .sentence = "Name of its column in s:log."}};

constexpr FunctionDoc gauge_doc{
    .name = "gauge",
    .sentence =
        "Makes a gauge that s:read reads and s:log records: a probe, an extensometer, a strain "
        "gauge, a gauge of crack opening. Between nodes it interpolates, never across an open "
        "crack.",
    .options = gauge_options,
    .example =
        "cmod = gauge { \"opening\", from = {0, 19*mm}, to = {0, 21*mm}, name = \"cmod\" }\n"
        "grip = gauge { \"line\", of = \"uy\", from = {0, 39*mm}, to = {100*mm, 39*mm}, name = "
        "\"head\" }\n"
        "s:log { \"gauges.csv\", every = 1*us, cmod, grip } s:run(2*us)"};

constexpr FunctionDoc read_doc{
    .name = "read",
    .owner = "s",
    .sentence = "Returns what a gauge reads now, in SI; takes a gauge or the options of one.",
    .options = gauge_options,
    .example = "print(s:read { \"point\", at = {50*mm, 30*mm}, of = \"stress_yy\" })"};

constexpr FunctionDoc recorded_read_doc{
    .name = "read",
    .owner = "r",
    .sentence = "Returns what a gauge reads in the record that is shown, the first at first.",
    .options = gauge_options,
    .example = "print(r:read { \"point\", at = {50*mm, 30*mm}, of = \"uy\" })"};

// Which of the options say where it is.
void check_places(Arguments& arguments, Gauge::Kind kind, std::string_view who) {
  const auto need = [&](bool given, const char* what) {
    if (!given && arguments.good({"at", "from", "to", "centre", "radius"}))
      arguments.problems.add(fmt::format("{}: it is not clear where the {} is", who, name_of(kind)),
                             fmt::format("give {}", what));
  };
  if (kind == Gauge::Kind::point)
    need(arguments.has("at"), "at = {x, y}");
  else if (kind == Gauge::Kind::region)
    need((arguments.has("from") && arguments.has("to")) ||
             (arguments.has("centre") && arguments.has("radius")),
         "from and to, or centre and radius");
  else
    need(arguments.has("from") && arguments.has("to"), "from and to, two places");
}

Gauge gauge_of(Arguments& arguments, std::string_view who) {
  Gauge gauge;
  gauge.kind = arguments.choice<Gauge::Kind>("kind");
  gauge.of = arguments.text_of_choice("of", "uy");
  gauge.name = arguments.text("name", name_of(gauge.kind));
  if (arguments.good({"kind"})) check_places(arguments, gauge.kind, who);
  if (!is_identifier(gauge.name))
    arguments.problems.add(fmt::format("{}: '{}' is no name of a column", who, gauge.name),
                           "a name has letters, digits and _, and begins with no digit");
  gauge.from = arguments.point(gauge.kind == Gauge::Kind::point ? "at" : "from");
  gauge.to = arguments.point("to");
  if (gauge.kind == Gauge::Kind::region && arguments.has("centre"))
    gauge.area =
        Ellipse{arguments.point("centre"), Vec2::Constant(arguments.number("radius")), 0.0};
  else if (gauge.kind == Gauge::Kind::region)
    gauge.area = rectangle(gauge.from.cwiseMin(gauge.to), gauge.from.cwiseMax(gauge.to));
  const bool line = gauge.kind != Gauge::Kind::point && gauge.kind != Gauge::Kind::region;
  if (line && arguments.has("from") && arguments.has("to") && gauge.from == gauge.to)
    arguments.problems.add(fmt::format("{}: from and to are the same place", who),
                           "give two places");
  arguments.problems.throw_if_any();
  return gauge;
}

int make_gauge(lua_State* L) {
  Arguments arguments = Arguments::from_table(L, 1, gauge_doc);
  push_object(L, ScriptedGauge{std::make_shared<const Gauge>(gauge_of(arguments, gauge_doc.name))});
  return 1;
}

// [-0, +1] Reads the gauge at index 2, or one of the options there.
int read_on(lua_State* L, const View& view, const FunctionDoc& doc) {
  Gauge gauge;
  if (const auto* given = object_at<ScriptedGauge>(L, 2)) {
    gauge = *given->gauge;
  } else {
    Arguments arguments = Arguments::from_table(L, 2, doc);
    gauge = gauge_of(arguments, doc.name);
  }
  check_on(gauge, view, "read");
  lua_pushnumber(L, reading(gauge, view).value());
  return 1;
}

int read_run(lua_State* L) {
  return read_on(L, self<ScriptedRun>(L, read_doc).results(), read_doc);
}

int read_recording(lua_State* L) {
  return read_on(L, self<ScriptedRecording>(L, recorded_read_doc).recording->view(),
                 recorded_read_doc);
}

int gauge_to_text(lua_State* L) {
  const Gauge& gauge = *object_at<ScriptedGauge>(L, 1)->gauge;
  const std::string_view unit = unit_of(gauge);
  push_text(L, fmt::format("gauge {}: {}{}", gauge.name, name_of(gauge.kind),
                           unit.empty() ? "" : fmt::format(" [{}]", unit)));
  return 1;
}

int push_gauge_name(lua_State* L) {
  push_text(L, object_at<ScriptedGauge>(L, 1)->gauge->name);
  return 1;
}

int push_gauge_unit(lua_State* L) {
  push_text(L, std::string(unit_of(*object_at<ScriptedGauge>(L, 1)->gauge)));
  return 1;
}

constexpr std::array gauge_fields{
    Property{"name", "", "Name of its column.", push_gauge_name},
    Property{"unit", "", "Unit of what it reads, SI.", push_gauge_unit},
};

}  // namespace

const TypeDoc& gauge_type() {
  static constexpr TypeDoc type{.name = "gauge",
                                .sentence = "What reads one number of a plate.",
                                .fields = gauge_fields,
                                .to_text = guarded<gauge_to_text>,
                                .destroy = destroy_object<ScriptedGauge>};
  return type;
}

std::span<const Function> gauge_functions() {
  static constexpr std::array functions{Function{&gauge_doc, guarded<make_gauge>}};
  return functions;
}

std::span<const Function> gauge_methods() {
  static constexpr std::array methods{Function{&read_doc, guarded<read_run>}};
  return methods;
}

std::span<const Function> recorded_gauge_methods() {
  static constexpr std::array methods{Function{&recorded_read_doc, guarded<read_recording>}};
  return methods;
}

}  // namespace hackle
