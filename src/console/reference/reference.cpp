// SPDX-License-Identifier: MIT
#include "console/reference/reference.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/text.hpp"
#include "base/units.hpp"
#include "console/reference/see_also.hpp"
#include "console/reference/specimen_list.hpp"
#include "console/reference/vocabulary.hpp"
#include "console/schema/option_row.hpp"
#include "measure/quantity.hpp"
#include "measure/scalar.hpp"
#include "output/chart/chart_kind.hpp"

namespace hackle {
namespace {

// Formats "  name   text", with the text in its own column.
std::string entry(std::string_view name, std::size_t column, std::string_view text) {
  return fmt::format("  {:<{}}  {}\n", name, column, hanging(text, column + 4, reference_width));
}

std::string comma_text(const std::vector<std::string>& words) {
  const std::vector<std::string_view> views(words.begin(), words.end());
  return comma_list(views);
}

std::string function_lines(std::span<const Function> functions) {
  std::size_t column = 0;
  for (const Function& function : functions)
    column = std::max(column, call_name(*function.doc).size());
  std::string text;
  for (const Function& function : functions)
    text += entry(call_name(*function.doc), column, function.doc->sentence);
  return text;
}

std::string field_line(const TypeDoc& type, const Property& field, std::size_t column) {
  const std::string unit = field.unit.empty() ? "" : fmt::format("[{}] ", field.unit);
  return entry(fmt::format("{}.{}", object_name(type), field.name), column,
               unit + std::string(field.sentence));
}

std::string field_lines(const TypeDoc& type) {
  std::size_t column = 0;
  for (const Property& field : type.fields)
    column = std::max(column, object_name(type).size() + 1 + field.name.size());
  std::string text;
  for (const Property& field : type.fields) text += field_line(type, field, column);
  return text;
}

// Formats a line that begins with a word and continues indented.
std::string line_of(std::string_view word, const std::string& text) {
  return fmt::format("\n{}: {}", word, hanging(text, word.size() + 2, reference_width));
}

// Lists methods and fields of the type that a function makes.
std::string lines_of_members(const TypeDoc& type) {
  std::vector<std::string> methods, fields;
  for (const Function& method : type.methods) methods.emplace_back(method.doc->name);
  for (const Property& field : type.fields) fields.emplace_back(field.name);
  std::string text;
  if (!methods.empty()) text = line_of(fmt::format("a {} can", type.name), comma_text(methods));
  return text + line_of(fmt::format("a {} has", type.name), comma_text(fields));
}

std::string example_lines(std::string_view example) {
  std::string text = "\n\nexample:\n  ";
  for (const char c : example) text.append(c == '\n' ? "\n  " : std::string(1, c));
  return text;
}

// Returns the functions that take an option of this name, grouped by their sentence about it.
std::map<std::string, std::vector<std::string>> takers_of(std::string_view option) {
  std::map<std::string, std::vector<std::string>> takers;
  for (const FunctionDoc* doc : all_docs())
    if (const Option* found = find_option(*doc, option))
      takers[table_text({row_of(*found)}, reference_width)].push_back(call_name(*doc));
  return takers;
}

std::string page_of_option(std::string_view name) {
  std::string text;
  for (const auto& [row, functions] : takers_of(name)) {
    if (!text.empty()) text += "\n\n";
    const std::string head = fmt::format("{}, an option of {}", name, comma_text(functions));
    text += hanging(head, 2, reference_width) + "\n" + row;
    text.pop_back();
  }
  return text;
}

std::string takers_line(std::string_view name) {
  std::vector<std::string> all;
  for (const auto& [row, functions] : takers_of(name))
    all.insert(all.end(), functions.begin(), functions.end());
  return all.empty() ? "" : line_of("an option of", comma_text(all));
}

// Explains every function of this name: plates and simulations share some.
std::string page_of_function(std::string_view name) {
  const FunctionDoc* first = nullptr;
  std::vector<std::string> others;
  for (const FunctionDoc* doc : all_docs()) {
    if (doc->name != name) continue;
    if (first != nullptr) others.push_back(call_name(*doc));
    if (first == nullptr) first = doc;
  }
  if (first == nullptr) return "";
  std::string text = reference_of(*first);
  if (!others.empty())
    text += line_of(first->owner == "p" ? "between two runs" : "also", comma_text(others));
  return text + takers_line(name);
}

std::string page_of_type(std::string_view name) {
  const TypeDoc* type = find_type(name);
  return type != nullptr ? reference_of(*type) : "";
}

std::string page_of_field(std::string_view name) {
  std::string text;
  for (const TypeDoc* type : all_types())
    if (const Property* field = find_field(*type, name)) text += field_line(*type, *field, 0);
  if (text.empty()) return "";
  const std::string options = page_of_option(name);
  if (options.empty()) text.pop_back();
  return options.empty() ? text : text + "\n" + options;
}

std::string page_of_unit(std::string_view name) {
  for (const Unit& unit : units())
    if (unit.name == name)
      return fmt::format("{} = {} in SI, a unit of {}", name, shortest(unit.factor),
                         unit.dimension);
  return "";
}

std::string page_of_order() {
  const auto line = [](std::string_view what, std::string_view how) {
    return fmt::format("\n  {:<13}{}", what, hanging(how, 15, reference_width));
  };
  return "A script does the same in every process, to the bit.\n" +
         line("pairs, next",
              "visit the whole numbers from 1 first; then other numbers, ascending; texts, by "
              "their bytes; false, true; tables, functions and objects in the order of their "
              "creation. __pairs is honoured.") +
         line("table.sort", "keeps the order of equal elements.") +
         line("tostring", "numbers tables, functions and the like: table: 1; so do %s and %p.") +
         line("math.random", "starts with the same number, also after math.randomseed().") +
         line("loads",
              "on one node add up to the same in any order; so do temperatures and initial "
              "conditions.") +
         "\n\nThe order matters where things overlap: the last inclusion applies, and so does\n"
         "the last support of a node along an axis. Discs are numbered in the order given.\n\n"
         "Not fixed: os.time, os.date, os.clock; the length (#) of a list with gaps; the bytes\n"
         "that collectgarbage counts, and the time when weak tables lose their entries.";
}

std::string page_of_times() {
  const auto part = [](std::string_view text) {
    return "\n\n" + hanging(text, 0, reference_width);
  };
  return hanging(
             "Ends of runs, frames, records and calls of s:on lie at the times that were asked "
             "for, whatever the step.",
             0, reference_width) +
         part(
             "The default step divides a power of ten: it is up to a twentieth shorter than "
             "`safety` times the limit. Times that are written in round numbers then mostly lie "
             "at steps.") +
         part(
             "Between two steps displacements and rigid discs are interpolated linearly, and "
             "velocities are those of the nearer half step plus the acceleration times what is "
             "missing; both are exact to second order in the step. Bonds, energies, temperatures "
             "and what s:on changes are those of the later step.") +
         part(
             "No step is ever shortened: a run has the same bits however it is cut and whatever "
             "looks on. Where `every` is less than a step, every step is taken, with a note. In "
             "slow loading, which has no steps, a time is served at the end of its increment.");
}

std::string page_of_list(std::string_view name) {
  if (name == "times") return page_of_times();
  if (name == "order") return page_of_order();
  if (name == "specimens") return list_of_specimens(reference_width);
  if (name == "functions") return list_of_functions();
  if (name == "fields") return list_of_fields();
  if (name == "columns") return list_of_columns();
  if (name == "charts") return list_of_charts();
  return name == "units" ? list_of_units() : "";
}

// Returns "[m/s] How fast a node moves."
std::string meaning(const Scalar& scalar) {
  const std::string unit = scalar.unit.empty() ? "" : fmt::format("[{}] ", scalar.unit);
  return unit + std::string(scalar.sentence);
}

// Returns the line about a field of pictures, if there is one of this name.
std::string picture_line(std::string_view name) {
  for (const Scalar& scalar : scalars())
    if (scalar.name == name) return line_of("a field of pictures", meaning(scalar));
  return "";
}

std::string page_of_scalar(std::string_view name) {
  const std::string line = picture_line(name);
  return line.empty() ? "" : fmt::format("field = \"{}\"{}", name, line);
}

}  // namespace

std::string_view object_name(const TypeDoc& type) {
  return type.methods.empty() ? type.name : type.methods.front().doc->owner;
}

std::string list_of_functions() {
  std::string text = function_lines(all_functions());
  for (const TypeDoc* type : all_types())
    if (!type->methods.empty())
      text +=
          fmt::format("\n{}: {}\n{}", type->name, type->sentence, function_lines(type->methods));
  text.pop_back();
  return text;
}

std::string list_of_units() {
  std::vector<std::string_view> dimensions;
  for (const Unit& unit : units())
    if (std::ranges::count(dimensions, unit.dimension) == 0) dimensions.push_back(unit.dimension);
  std::string text =
      "Numbers are in SI units; multiply by a constant to convert: 12*MPa, 0.5*mm.\n";
  for (const std::string_view dimension : dimensions) {
    std::vector<std::string_view> names;
    for (const Unit& unit : units())
      if (unit.dimension == dimension) names.push_back(unit.name);
    text += fmt::format("\n  {:<8}{}", dimension, comma_list(names));
  }
  return text;
}

std::string list_of_fields() {
  std::size_t column = 0;
  for (const Scalar& scalar : scalars()) column = std::max(column, scalar.name.size());
  std::string text = "Used as in show(s, { field = \"speed\" }), also for frames and movies.\n\n";
  for (const Scalar& scalar : scalars()) text += entry(scalar.name, column, meaning(scalar));
  text.pop_back();
  return text;
}

// Returns a line for each of a kind of column.
template <class Quantities>
std::string lines_of_columns(const Quantities& quantities, std::size_t column) {
  std::string text;
  for (const auto& one : quantities) {
    const std::string unit = one.unit.empty() ? "" : fmt::format("[{}] ", one.unit);
    text += entry(one.name, column, unit + std::string(one.sentence));
  }
  return text;
}

std::string list_of_columns() {
  constexpr std::size_t column = 12;
  std::string text =
      hanging(
          "Used as in s:log { \"run.csv\", every = 1*us, \"external\", \"tip.x\" }; the first "
          "column is always the time. In the file a column is named with its unit: tip_x_m.",
          0, reference_width) +
      "\n\n" + lines_of_columns(quantities(), column) +
      "\nOf a load, by its name or its kind and number, as in \"grip.fx\", \"roller1.uy\":\n" +
      lines_of_columns(load_quantities(), column) + "\nOf a field, as in \"max.stress_1\":\n" +
      lines_of_columns(field_quantities(), column);
  text.pop_back();
  return text;
}

std::string list_of_charts() {
  constexpr std::size_t column = 12;
  std::string text =
      hanging(
          "Used as in s:chart { \"speed.pdf\", \"speed\" }, r:chart, chart { of = ... } and hackle "
          "chart run.h5 speed; instead of a kind, columns of one unit may be named. Each needs "
          "what s:log has noted, or records that know it.",
          0, reference_width) +
      "\n\n";
  for (const ChartKind& kind : chart_kinds())
    text += entry(kind.name, column, std::string(kind.sentence));
  text.pop_back();
  return text;
}

std::string reference_of(const FunctionDoc& doc) {
  std::vector<OptionRow> rows;
  for (const Option& option : doc.options) rows.push_back(row_of(option));
  std::string text = hanging(signature(doc), 4, reference_width) + "\n" +
                     hanging(doc.sentence, 0, reference_width);
  if (!rows.empty()) text += "\n\n" + table_text(rows, reference_width);
  if (!rows.empty()) text.pop_back();
  text += example_lines(doc.example) + "\n";
  const TypeDoc* made = doc.owner.empty() ? find_type(doc.name) : nullptr;
  if (made != nullptr) text += lines_of_members(*made);
  return text + line_of("see also", comma_list(see_also(doc.name)));
}

std::string reference_of(const TypeDoc& type) {
  std::string text = fmt::format("{}: {}\n", type.name, type.sentence);
  if (!type.methods.empty()) text.append("\n").append(function_lines(type.methods));
  if (!type.fields.empty()) text.append("\n").append(field_lines(type));
  text.pop_back();
  return text;
}

std::string reference_of(std::string_view name) {
  for (const auto page :
       {page_of_function, page_of_type, page_of_list, page_of_field, page_of_option, page_of_unit})
    if (std::string text = page(name); !text.empty()) return text + picture_line(name);
  if (std::string text = page_of_scalar(name); !text.empty()) return text;
  const std::vector<std::string> all = topics();
  const std::vector<std::string_view> known(all.begin(), all.end());
  throw Error(ErrorKind::refused,
              fmt::format("help: nothing is known of '{}'{}", name.substr(0, 40),
                          did_you_mean(name, known)),
              "help() gives a tour, help \"functions\" lists all functions");
}

std::vector<std::string> topics() {
  std::set<std::string_view> names{"functions", "units", "materials", "fields", "columns",
                                   "charts",    "order", "specimens", "times"};
  for (const FunctionDoc* doc : all_docs()) {
    names.insert(doc->name);
    for (const Option& option : doc->options) names.insert(option.name);
  }
  for (const TypeDoc* type : all_types()) {
    names.insert(type->name);
    for (const Property& field : type->fields) names.insert(field.name);
  }
  for (const Unit& unit : units()) names.insert(unit.name);
  names.insert(scalar_names.begin(), scalar_names.end());
  return {names.begin(), names.end()};
}

}  // namespace hackle
