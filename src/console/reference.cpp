// SPDX-License-Identifier: MIT
#include "console/reference.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/text.hpp"
#include "base/units.hpp"
#include "console/background_binding.hpp"
#include "console/contact_sheet_binding.hpp"
#include "console/help_binding.hpp"
#include "console/load_binding.hpp"
#include "console/material_binding.hpp"
#include "console/options_binding.hpp"
#include "console/plate_binding.hpp"
#include "console/show_binding.hpp"
#include "console/simulation_binding.hpp"

namespace hackle {
namespace {

std::string_view type_word(const Option& option) {
  switch (option.type) {
    case OptionType::number:
      return "number";
    case OptionType::integer:
      return "integer";
    case OptionType::text:
      return "text";
    case OptionType::texts:
      return "list of texts";
    case OptionType::flag:
      return "flag";
    case OptionType::point:
      return "{x, y}";
    case OptionType::pair:
      return "{a, b}";
    case OptionType::window:
      return "{x, y, half}";
    case OptionType::points:
      return "points";
    case OptionType::choice:
      return "choice";
    case OptionType::material:
      return "material";
    case OptionType::vector_field:
      return "{x, y} or function";
    case OptionType::scalar_field:
      return "number or function";
    case OptionType::course:
      return "times or function";
    case OptionType::function:
      return "function";
  }
  return "?";
}

// What values are allowed.
std::string allowed(const Option& option) {
  if (option.type == OptionType::choice) return comma_list(option.choices);
  const std::string range = range_text(option);
  return range.empty() ? std::string(option.unit) : range;
}

std::string presence(const Option& option) {
  if (option.required) return "required";
  if (option.alternative) return "one way";
  return option.fallback.empty() ? "optional" : fmt::format("default {}", option.fallback);
}

std::string option_table(const FunctionDoc& doc) {
  std::size_t name = 0, type = 0, values = 0, must = 0;
  for (const Option& option : doc.options) {
    name = std::max(name, option.name.size());
    type = std::max(type, type_word(option).size());
    values = std::max(values, allowed(option).size());
    must = std::max(must, presence(option).size());
  }
  std::string text;
  for (const Option& option : doc.options)
    text +=
        fmt::format("  {:<{}}  {:<{}}  {:<{}}  {:<{}}  {}\n", option.name, name, type_word(option),
                    type, allowed(option), values, presence(option), must, option.sentence);
  return text;
}

std::string function_lines(std::span<const Function> functions) {
  constexpr std::size_t column = 44;
  std::string text;
  for (const Function& function : functions) {
    std::string line = "  " + signature(*function.doc);
    line += line.size() < column ? std::string(column - line.size(), ' ')
                                 : "\n" + std::string(column, ' ');
    text.append(line).append(function.doc->sentence).append("\n");
  }
  return text;
}

std::string field_lines(const TypeDoc& type) {
  std::string text;
  for (const Property& field : type.fields)
    text += fmt::format("  {:<9}  {:<5}  {}\n", field.name, field.unit, field.sentence);
  return text;
}

std::string unit_line() {
  std::string text;
  for (const Unit& unit : units()) text.append(text.empty() ? "" : " ").append(unit.name);
  return text;
}

const TypeDoc* find_type(std::string_view name) {
  for (const TypeDoc* type : all_types())
    if (type->name == name) return type;
  return nullptr;
}

}  // namespace

std::vector<const TypeDoc*> all_types() {
  return {&material_type(), &plate_type(), &simulation_type()};
}

std::vector<Function> all_functions() {
  std::vector<Function> list;
  for (const auto functions :
       {material_functions(), plate_functions(), course_functions(), simulation_functions(),
        background_functions(), show_functions(), contact_sheet_functions(), options_functions(), help_functions()})
    list.insert(list.end(), functions.begin(), functions.end());
  return list;
}

std::string overview() {
  std::string text = function_lines(all_functions());
  for (const TypeDoc* type : all_types())
    if (!type->methods.empty())
      text +=
          fmt::format("\n{}: {}\n{}", type->name, type->sentence, function_lines(type->methods));
  return fmt::format("{}\nunits: {}\nhelp \"crack\" tells more about one of them", text,
                     unit_line());
}

std::string reference_of(const FunctionDoc& doc) {
  std::string text = fmt::format("{}\n{}\n", signature(doc), doc.sentence);
  if (!doc.options.empty()) text += "\n" + option_table(doc);
  text += fmt::format("\nexample: {}", doc.example);
  const TypeDoc* made = doc.owner.empty() ? find_type(doc.name) : nullptr;
  return made != nullptr ? text + "\n\n" + reference_of(*made) : text;
}

std::string reference_of(const TypeDoc& type) {
  std::string text = fmt::format("{}: {}", type.name, type.sentence);
  if (!type.methods.empty()) text += "\n" + function_lines(type.methods);
  if (!type.fields.empty()) text += "\n" + field_lines(type);
  while (text.ends_with('\n')) text.pop_back();
  return text;
}

std::string reference_of(std::string_view name) {
  std::vector<std::string_view> known;
  std::vector<Function> functions = all_functions();
  for (const TypeDoc* type : all_types()) {
    functions.insert(functions.end(), type->methods.begin(), type->methods.end());
    known.push_back(type->name);
  }
  for (const Function& function : functions) {
    if (function.doc->name == name) return reference_of(*function.doc);
    known.push_back(function.doc->name);
  }
  if (const TypeDoc* type = find_type(name)) return reference_of(*type);
  throw Error(ErrorKind::refused,
              fmt::format("help: nothing is known of '{}'{}", name.substr(0, 40),
                          did_you_mean(name, known)),
              "help() lists everything");
}

}  // namespace hackle
