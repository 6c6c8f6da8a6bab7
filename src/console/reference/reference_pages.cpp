// SPDX-License-Identifier: MIT
#include "console/reference/reference_pages.hpp"

#include <fmt/format.h>

#include "base/files.hpp"
#include "base/markup.hpp"
#include "base/text.hpp"
#include "base/units.hpp"
#include "console/language/materials.hpp"
#include "console/reference/reference.hpp"
#include "console/reference/see_also.hpp"
#include "console/reference/tour.hpp"
#include "console/reference/vocabulary.hpp"
#include "console/schema/option_row.hpp"
#include "measure/quantity.hpp"
#include "measure/scalar.hpp"
#include "output/chart/chart_kind.hpp"

namespace hackle {
namespace {

std::string option_table(const FunctionDoc& doc) {
  if (doc.options.empty()) return "";
  std::string text = "| option | type | unit | range | default | |\n|---|---|---|---|---|---|\n";
  for (const Option& option : doc.options) {
    const OptionRow row = row_of(option);
    const std::string range = row.values == option.unit ? "" : row.values;
    text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", markdown_code(row.name),
                        markdown(row.type), markdown(option.unit), markdown(range),
                        markdown(row.presence), markdown(row.sentence));
  }
  return text + "\n";
}

std::string links(const FunctionDoc& doc) {
  std::vector<std::string> words;
  for (const std::string_view name : see_also(doc.name)) words.push_back(markdown_code(name));
  const std::vector<std::string_view> views(words.begin(), words.end());
  return views.empty() ? "" : "See also " + comma_list(views) + ".\n\n";
}

std::string function_section(const FunctionDoc& doc) {
  return fmt::format("### `{}`\n\n```lua\n{}\n```\n\n{}\n\n{}Example:\n\n```lua\n{}\n```\n\n{}",
                     call_name(doc), signature(doc), markdown(doc.sentence), option_table(doc),
                     doc.example, links(doc));
}

std::string field_table(const TypeDoc& type) {
  if (type.fields.empty()) return "";
  std::string text =
      fmt::format("### Fields of a {}\n\n| field | unit | |\n|---|---|---|\n", type.name);
  for (const Property& field : type.fields)
    text += fmt::format("| {} | {} | {} |\n", markdown_code(field.name), markdown(field.unit),
                        markdown(field.sentence));
  return text + "\n";
}

std::string type_section(const TypeDoc& type) {
  std::string text = fmt::format("## A {}\n\n{}\n\n", type.name, markdown(type.sentence));
  for (const Function& method : type.methods) text += function_section(*method.doc);
  return text + field_table(type);
}

std::string unit_table() {
  std::string text = "## Units\n\n| constant | in SI | of |\n|---|---|---|\n";
  for (const Unit& unit : units())
    text += fmt::format("| {} | {} | {} |\n", markdown_code(unit.name), shortest(unit.factor),
                        unit.dimension);
  return text + "\n";
}

std::string scalar_table() {
  std::string text = "## Fields of pictures\n\n| field | unit | |\n|---|---|---|\n";
  for (const Scalar& scalar : scalars())
    text += fmt::format("| {} | {} | {} |\n", markdown_code(scalar.name), markdown(scalar.unit),
                        markdown(scalar.sentence));
  return text + "\n";
}

template <class Quantities>
void add_columns(std::string& text, std::string_view before, const Quantities& quantities) {
  for (const auto& one : quantities)
    text += fmt::format("| {} | {} | {} |\n", markdown_code(fmt::format("{}{}", before, one.name)),
                        markdown(one.unit), markdown(one.sentence));
}

std::string column_table() {
  std::string text = "## Columns of tables\n\n| column | unit | |\n|---|---|---|\n";
  add_columns(text, "", quantities());
  add_columns(text, "LOAD.", load_quantities());
  for (const PartQuantity& one : field_quantities())
    text += fmt::format("| {} | | {} |\n", markdown_code(fmt::format("{}.FIELD", one.name)),
                        markdown(one.sentence));
  return text + "\n";
}

std::string chart_table() {
  std::string text = "## Charts\n\n| kind | |\n|---|---|\n";
  for (const ChartKind& kind : chart_kinds())
    text += fmt::format("| {} | {} |\n", markdown_code(kind.name), markdown(kind.sentence));
  return text + "\n";
}

std::string material_table() {
  const Materials materials(data_file("assets/materials.lua"));
  std::string text = "## Materials\n\n| name | | source |\n|---|---|---|\n";
  for (const KnownMaterial& known : materials.list())
    text += fmt::format("| {} | {} | {} |\n", markdown_code(known.key),
                        markdown(describe(known.material)), markdown(known.source));
  return text;
}

std::string roff_functions(std::span<const Function> functions) {
  std::string text;
  for (const Function& function : functions)
    text += fmt::format(".TP\n{}\n{}\n", roff_code(signature(*function.doc)),
                        roff(function.doc->sentence));
  return text;
}

std::string roff_type(const TypeDoc& type) {
  std::string text =
      fmt::format(".SS A {}\n{}\n", type.name, roff(type.sentence)) + roff_functions(type.methods);
  for (const Property& field : type.fields)
    text += fmt::format(".TP\n{}{}\n{}\n", roff_code(field.name),
                        field.unit.empty() ? "" : fmt::format(" [{}]", field.unit),
                        roff(field.sentence));
  return text;
}

}  // namespace

std::string markdown_reference() {
  std::string text = "## Functions\n\n";
  for (const Function& function : all_functions()) text += function_section(*function.doc);
  for (const TypeDoc* type : all_types()) text += type_section(*type);
  return text + scalar_table() + column_table() + chart_table() + unit_table() + material_table();
}

std::string roff_reference() {
  std::string first;
  for (const std::string_view line : tour_lines())
    if (!line.starts_with("help")) first.append(line).append("\n");
  std::string text = ".SH SCENE LANGUAGE\nLua 5.4, all numbers in SI units.\n" +
                     roff_example(first) + ".SS Functions\n" + roff_functions(all_functions());
  for (const TypeDoc* type : all_types()) text += roff_type(*type);
  text += ".SS Columns of tables\n";
  for (const Quantity& one : quantities())
    text += fmt::format(".TP\n{}\n{}\n", roff_code(one.name), roff(one.sentence));
  text += ".SS Fields of pictures\n";
  for (const Scalar& scalar : scalars())
    text += fmt::format(".TP\n{}\n{}\n", roff_code(scalar.name), roff(scalar.sentence));
  std::vector<std::string_view> names;
  for (const Unit& unit : units()) names.push_back(unit.name);
  return text + ".SS Units\n" + comma_list(names) + "\n";
}

}  // namespace hackle
