// SPDX-License-Identifier: MIT
#include "console/language/values_binding.hpp"

#include <array>
#include <string>

#include <fmt/format.h>

#include "base/units.hpp"
#include "console/language/scripted_recording.hpp"
#include "console/language/scripted_run.hpp"
#include "console/schema/arguments.hpp"
#include "console/schema/object_type.hpp"
#include "console/schema/result_table.hpp"
#include "measure/scalar.hpp"
#include "output/files/values_file.hpp"

namespace hackle {
namespace {

constexpr std::array values_options{
    Option{.name = "field",
           .type = OptionType::choice,
           .required = true,
           .choices = scalar_names,
           .sentence = "A field of pictures, see help \"fields\"."},
};
constexpr FunctionDoc values_doc{
    .name = "values",
    .owner = "s",
    .call = Call::values,
    .sentence =
        "Returns a field of all nodes as it is now, in one value: asked and saved without "
        "a table of numbers.",
    .options = values_options,
    .example = "v = s:values(\"stress_1\") print(v:max().value, v:at({50*mm, 30*mm}))"};
constexpr FunctionDoc recorded_values_doc{
    .name = "values",
    .owner = "r",
    .call = Call::values,
    .sentence = "Returns a field of all nodes of the record that is shown.",
    .options = values_options,
    .example = "v = r:values(\"damage\") print(v:max().value)"};

constexpr std::array place_option{
    Option{.name = "place",
           .type = OptionType::point,
           .unit = "m",
           .required = true,
           .sentence = "Place on the plate before it moves."},
};
constexpr FunctionDoc values_at_doc{
    .name = "at",
    .owner = "v",
    .call = Call::values,
    .sentence =
        "Returns the value at a place, between nodes interpolated, never across an open "
        "crack; nil off the plate and in holes.",
    .options = place_option,
    .example = "v = s:values(\"displacement_y\") print(v:at({50*mm, 30*mm}))"};
constexpr FunctionDoc values_max_doc{
    .name = "max",
    .owner = "v",
    .call = Call::values,
    .sentence = "Returns the largest value with its place: value, x, y (m).",
    .example = "v = s:values(\"stress_1\") print(v:max().x)"};
constexpr FunctionDoc values_min_doc{
    .name = "min",
    .owner = "v",
    .call = Call::values,
    .sentence = "Returns the smallest value with its place: value, x, y (m).",
    .example = "v = s:values(\"stress_2\") print(v:min().value)"};

constexpr std::array mean_options{
    Option{.name = "from",
           .type = OptionType::point,
           .unit = "m",
           .alternative = true,
           .sentence = "Lower left corner of a rectangle; without an area, the whole plate."},
    Option{.name = "to",
           .type = OptionType::point,
           .unit = "m",
           .alternative = true,
           .sentence = "Upper right corner of the rectangle."},
    Option{.name = "centre",
           .type = OptionType::point,
           .unit = "m",
           .alternative = true,
           .sentence = "Centre of a disc, instead of a rectangle."},
    Option{.name = "radius",
           .unit = "m",
           .range = above(0.0),
           .alternative = true,
           .sentence = "Radius of the disc."},
};
constexpr FunctionDoc values_mean_doc{
    .name = "mean",
    .owner = "v",
    .sentence = "Returns the mean over the nodes of an area, or of the plate; nil without a node.",
    .options = mean_options,
    .example =
        "v = s:values(\"energy_density\") print(v:mean { centre = {60*mm, 20*mm}, radius = "
        "5*mm })"};

constexpr std::array save_options{
    Option{.name = "file",
           .type = OptionType::text,
           .required = true,
           .positional = true,
           .sentence = "File name, .csv or .png; relative to the output folder."},
};
constexpr FunctionDoc values_save_doc{
    .name = "save",
    .owner = "v",
    .sentence =
        "Writes a table of x, y and the value of every node (.csv), or a picture of one "
        "pixel for each node (.png).",
    .options = save_options,
    .example = "v = s:values(\"stress_1\") v:save \"stress.csv\" v:save \"stress.png\""};

constexpr auto extreme_names = std::to_array<std::string_view>({"value", "x", "y"});

int push_values(lua_State* L, const View& view, const FunctionDoc& doc) {
  const Arguments arguments = Arguments::from_values(L, 2, doc);
  arguments.problems.throw_if_any();
  push_object(L, ScriptedValues{std::make_shared<const NodeValues>(
                     arguments.text_of_choice("field", ""), view)});
  return 1;
}

int values_of_run(lua_State* L) {
  return push_values(L, self<ScriptedRun>(L, values_doc).results(), values_doc);
}

int values_of_recording(lua_State* L) {
  return push_values(L, self<ScriptedRecording>(L, recorded_values_doc).recording->view(),
                     recorded_values_doc);
}

int push_or_nil(lua_State* L, const std::optional<double>& value) {
  if (value)
    lua_pushnumber(L, *value);
  else
    lua_pushnil(L);
  return 1;
}

const NodeValues& values_in(const ScriptedValues& scripted) {
  if (scripted.values) return *scripted.values;
  throw Error(ErrorKind::refused,
              "these values were taken before the script was stopped, and are gone",
              "take them again with s:values");
}

int value_at(lua_State* L) {
  const NodeValues& values = values_in(self<ScriptedValues>(L, values_at_doc));
  const Arguments arguments = Arguments::from_values(L, 2, values_at_doc);
  arguments.problems.throw_if_any();
  return push_or_nil(L, values.at(arguments.point("place")));
}

template <const FunctionDoc& doc, NodeValues::Place (NodeValues::*extreme)() const>
int push_extreme(lua_State* L) {
  const NodeValues& values = values_in(self<ScriptedValues>(L, doc));
  Arguments::from_values(L, 2, doc).problems.throw_if_any();
  const NodeValues::Place found = (values.*extreme)();
  lua_createtable(L, 0, extreme_names.size());
  close_names(L, "values:max()", extreme_names);
  set_number(L, "value", found.value);
  set_number(L, "x", found.place.x());
  set_number(L, "y", found.place.y());
  return 1;
}

Region area_of_mean(Arguments& arguments) {
  const bool box = arguments.has("from") && arguments.has("to");
  const bool disc = arguments.has("centre") && arguments.has("radius");
  const bool any = arguments.has("from") || arguments.has("to") || arguments.has("centre") ||
                   arguments.has("radius");
  if (any && box == disc && arguments.problems.empty())
    arguments.problems.add("mean: the area is not clear",
                           "give from and to, or centre and radius, or nothing");
  if (disc)
    return Ellipse{arguments.point("centre"), Vec2::Constant(arguments.number("radius")), 0.0};
  const Vec2 from = arguments.point("from"), to = arguments.point("to");
  if (box) return rectangle(from.cwiseMin(to), from.cwiseMax(to));
  return std::nullopt;
}

int mean(lua_State* L) {
  const NodeValues& values = values_in(self<ScriptedValues>(L, values_mean_doc));
  Arguments arguments = Arguments::from_table(L, 2, values_mean_doc);
  const Region area = area_of_mean(arguments);
  arguments.problems.throw_if_any();
  return push_or_nil(L, values.mean(area));
}

int save_values(lua_State* L) {
  const NodeValues& values = values_in(self<ScriptedValues>(L, values_save_doc));
  const Arguments arguments = Arguments::from_table(L, 2, values_save_doc);
  arguments.problems.throw_if_any();
  Session& session = session_of(L);
  const std::string name = arguments.text("file");
  const bool picture = name.ends_with(".png");
  const auto path = session.claim("save", name, picture ? FileKind::picture : FileKind::table);
  if (session.settings.purpose != Purpose::results) return 0;
  if (picture)
    write_values_image(values, std::string(scalar_of(values.name()).colours), path);
  else
    write_values(values, path);
  session.names->complete(path);
  return 0;
}

int values_to_text(lua_State* L) {
  const ScriptedValues& scripted = *object_at<ScriptedValues>(L, 1);
  if (!scripted.values) {
    push_text(L, "a field of nodes, taken before the script was stopped");
    return 1;
  }
  const NodeValues& values = *scripted.values;
  push_text(L, fmt::format("{} of {} x {} nodes at {}, {} to {}", values.name(), values.grid().nx,
                           values.grid().ny, quantity(values.time(), "s"),
                           quantity(values.min().value, values.unit()),
                           quantity(values.max().value, values.unit())));
  return 1;
}

int push_values_name(lua_State* L) {
  push_text(L, values_in(*object_at<ScriptedValues>(L, 1)).name());
  return 1;
}
int push_values_unit(lua_State* L) {
  push_text(L, values_in(*object_at<ScriptedValues>(L, 1)).unit());
  return 1;
}
int push_values_time(lua_State* L) {
  lua_pushnumber(L, values_in(*object_at<ScriptedValues>(L, 1)).time());
  return 1;
}

constexpr std::array methods_of_values{
    Function{&values_at_doc, guarded<value_at>},
    Function{&values_max_doc, guarded<push_extreme<values_max_doc, &NodeValues::max>>},
    Function{&values_min_doc, guarded<push_extreme<values_min_doc, &NodeValues::min>>},
    Function{&values_mean_doc, guarded<mean>}, Function{&values_save_doc, guarded<save_values>}};

constexpr std::array fields_of_values{
    Property{"name", "", "Name of the field.", push_values_name},
    Property{"unit", "", "Its unit, SI.", push_values_unit},
    Property{"time", "s", "When it was taken.", push_values_time},
};

}  // namespace

const TypeDoc& values_type() {
  static constexpr TypeDoc type{.name = "values",
                                .sentence = "A field of all nodes at one moment.",
                                .methods = methods_of_values,
                                .fields = fields_of_values,
                                .to_text = guarded<values_to_text>,
                                .destroy = destroy_object<ScriptedValues>};
  return type;
}

std::span<const Function> values_methods() {
  static constexpr std::array methods{
      Function{&values_doc, guarded<values_of_run>, Replayed::hands}};
  return methods;
}

std::span<const Function> recorded_values_methods() {
  static constexpr std::array methods{Function{&recorded_values_doc, guarded<values_of_recording>}};
  return methods;
}

}  // namespace hackle
