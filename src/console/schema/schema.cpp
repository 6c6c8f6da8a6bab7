// SPDX-License-Identifier: MIT
#include "console/schema/schema.hpp"

#include <fmt/format.h>

#include "base/text.hpp"

namespace hackle {
namespace {

std::string option_names(const FunctionDoc& doc) {
  std::string names;
  for (const Option& option : doc.options)
    names.append(names.empty() ? "" : ", ").append(option.name);
  return names;
}

}  // namespace

std::string call_name(const FunctionDoc& doc) {
  return doc.owner.empty() ? std::string(doc.name) : fmt::format("{}:{}", doc.owner, doc.name);
}

std::string signature(const FunctionDoc& doc) {
  const std::string name =
      doc.owner.empty() ? std::string(doc.name) : fmt::format("{}:{}", doc.owner, doc.name);
  const std::string names = option_names(doc);
  if (doc.leading.starts_with('{')) return fmt::format("{} {}", name, doc.leading);
  if (doc.call != Call::options) {
    const bool both = !doc.leading.empty() && !names.empty();
    return fmt::format("{}({}{}{})", name, doc.leading, both ? ", " : "", names);
  }
  if (doc.leading.empty()) return fmt::format("{} {{ {} }}", name, names);
  return fmt::format("{}({}, {{ {} }})", name, doc.leading, names);
}

std::string expectation(const Option& option) {
  const std::string in_unit = option.unit.empty() ? "" : fmt::format(" in {}", option.unit);
  switch (option.type) {
    case OptionType::number:
      return "a number" + in_unit;
    case OptionType::integer:
      return "a whole number" + (option.unit.empty() ? "" : fmt::format(" of {}", option.unit));
    case OptionType::text:
      return "a text in quotes";
    case OptionType::caption:
      return "a text in quotes, \"\" for none";
    case OptionType::texts:
      return fmt::format("a list of {} or more texts in quotes", option.range.min);
    case OptionType::flag:
      return "true or false";
    case OptionType::point:
      return "{x, y}, two numbers" + in_unit;
    case OptionType::pair:
      return "{a, b}, two numbers" + in_unit;
    case OptionType::window:
      return "{x, y, half}, the middle and half the width" + in_unit;
    case OptionType::points:
      return fmt::format("a list of {} or more points {{x, y}}{}, or the name of a file",
                         option.range.min, in_unit);
    case OptionType::markers:
      return fmt::format("a list of {} or more {{x, y, \"label\"}}{}", option.range.min, in_unit);
    case OptionType::numbers:
      return fmt::format("a list of {} or more numbers{}", option.range.min, in_unit);
    case OptionType::recordings:
      return fmt::format("a list of {} or more of what recording returns", option.range.min);
    case OptionType::sources:
      return fmt::format(
          "a list of {} or more names of files, recordings, or tables of lists of numbers",
          option.range.min);
    case OptionType::columns:
      return "names of columns, functions of the simulation, gauges, or {name = function}";
    case OptionType::choice:
      return "one of " + comma_list(option.choices);
    case OptionType::material:
      return "the name of a material, or material { ... }";
    case OptionType::areas:
      return "an area, {centre = ..., radius = ...} for one, or a list of areas";
    case OptionType::vector_field:
      return "{x, y}" + in_unit +
             ", or a function of x and y, and maybe t, that returns two numbers";
    case OptionType::scalar_field:
      return "a number" + in_unit + ", or a function of x and y, and maybe t";
    case OptionType::amplitude:
      return "{{t, factor}, ...}, as ramp, pulse and step_at make it, or a function of t";
    case OptionType::function:
      return "a function";
    case OptionType::reading:
      return "a number, a list of numbers, or a function that returns a number";
  }
  return "?";
}

std::string range_text(const Option& option) {
  return range_text(option.range, option.unit);
}

const Option* find_option(const FunctionDoc& doc, std::string_view name) {
  for (const Option& option : doc.options)
    if (option.name == name) return &option;
  return nullptr;
}

const Function* find_method(const TypeDoc& type, std::string_view name) {
  for (const Function& method : type.methods)
    if (method.doc->name == name) return &method;
  return nullptr;
}

const Property* find_field(const TypeDoc& type, std::string_view name) {
  for (const Property& field : type.fields)
    if (field.name == name) return &field;
  return nullptr;
}

}  // namespace hackle
