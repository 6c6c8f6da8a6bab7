// SPDX-License-Identifier: MIT
#include "console/reference/search.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <vector>

#include <fmt/format.h>

#include "base/text.hpp"
#include "base/units.hpp"
#include "console/reference/reference.hpp"
#include "console/reference/vocabulary.hpp"
#include "measure/quantity.hpp"
#include "measure/scalar.hpp"

namespace hackle {
namespace {

// Words that people look for, and the name under which the language has the matter.
struct OtherWords {
  std::string_view name, words;
};

constexpr auto other_words = std::to_array<OtherWords>({
    {"plate", "sheet panel body geometry domain specimen"},
    {"crack", "precrack slit fissure cut flaw defect"},
    {"notch", "slot groove"},
    {"hole", "cavity void bore cutout"},
    {"mask", "image bitmap png geometry"},
    {"keep", "outline contour geometry intersection"},
    {"points", "csv coordinates outline contour"},
    {"inclusion", "fibre fiber matrix composite phase"},
    {"traction", "force stress load pull boundary condition"},
    {"clamp", "fix fixed boundary condition support dirichlet"},
    {"move", "displacement control boundary condition grip dirichlet"},
    {"temperature", "thermal heat quench cooling shock"},
    {"foundation", "spring elastic bed winkler"},
    {"impactor", "projectile ball bullet disc collision impact"},
    {"damping", "viscous dissipation rayleigh"},
    {"absorb", "nonreflecting infinite boundary"},
    {"contact", "collision friction rebound"},
    {"roller", "bending support"},
    {"platen", "compression test"},
    {"grade", "gradient heterogeneous layers"},
    {"simulate", "mesh lattice resolution discretisation discretization grid solver"},
    {"spacing", "mesh size resolution dx grid"},
    {"horizon", "delta length scale family neighbours"},
    {"fidelity", "speed accuracy fast trade approximate"},
    {"precision", "float double single f32 f64 speed memory"},
    {"relax", "static equilibrium implicit preload"},
    {"quasistatic", "static slow implicit load displacement curve"},
    {"movie", "film video animation mp4 gif webm"},
    {"frame", "picture image png screenshot plot figure"},
    {"record", "save export hdf5 h5 xdmf paraview output data"},
    {"recording", "load open replay hdf5 h5"},
    {"fork", "copy clone restart branch future"},
    {"save", "checkpoint restart dump backup"},
    {"load", "checkpoint restart resume continue restore"},
    {"rewind", "restart back undo"},
    {"script", "save history transcript session"},
    {"report", "summary print result statistics"},
    {"cracks", "tip branch bifurcation length path"},
    {"at", "probe gauge point sensor value node"},
    {"on", "callback event observer hook function step"},
    {"options", "parameters arguments sweep command line set"},
    {"strength", "scatter weibull random heterogeneous"},
    {"help", "manual documentation"},
    {"c_R", "velocity limit crack"},
});

std::string lower(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

bool is_of_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

std::vector<std::string> parts_of(std::string_view text) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (!is_of_word(text[at])) continue;
    if (at == 0 || !is_of_word(text[at - 1])) words.emplace_back();
    words.back() += text[at];
  }
  return words;
}

// A line of the answer, and all words by which it may be found.
struct Entry {
  std::string name, sentence, words;
};

std::string others_of(std::string_view name) {
  const auto found = std::ranges::find(other_words, name, &OtherWords::name);
  return found == other_words.end() ? "" : fmt::format(" {}", found->words);
}

std::vector<Entry> entries() {
  std::vector<Entry> all;
  std::set<std::string> known;
  const auto add = [&](const std::string& name, std::string_view plain, std::string_view sentence) {
    if (known.insert(fmt::format("{} {}", name, sentence)).second)
      all.push_back(
          {name, std::string(sentence), fmt::format("{} {}{}", plain, sentence, others_of(plain))});
  };
  for (const FunctionDoc* doc : all_docs()) add(call_name(*doc), doc->name, doc->sentence);
  for (const TypeDoc* type : all_types())
    for (const Property& field : type->fields)
      add(fmt::format("{}.{}", object_name(*type), field.name), field.name, field.sentence);
  for (const FunctionDoc* doc : all_docs())
    for (const Option& option : doc->options)
      add(fmt::format("{} (option)", option.name), option.name, option.sentence);
  for (const Scalar& scalar : scalars())
    add(fmt::format("{} (field)", scalar.name), scalar.name, scalar.sentence);
  for (const Quantity& one : quantities())
    add(fmt::format("{} (column)", one.name), one.name, one.sentence);
  return all;
}

bool has_word(const std::vector<std::string>& words, const std::string& wanted) {
  return std::ranges::any_of(words, [&](const auto& word) { return word.starts_with(wanted); });
}

bool answers(const Entry& entry, const std::vector<std::string>& query) {
  const std::vector<std::string> words = parts_of(lower(entry.words));
  return std::ranges::all_of(query, [&](const auto& wanted) { return has_word(words, wanted); });
}

}  // namespace

std::string search_reference(std::string_view query) {
  constexpr std::size_t most_lines = 30, name_column = 24;
  const std::vector<std::string> wanted = parts_of(lower(query));
  if (wanted.empty()) return "";
  std::string text;
  std::size_t lines = 0;
  for (const Entry& entry : entries()) {
    if (!answers(entry, wanted) || ++lines > most_lines) continue;
    text += fmt::format("\n  {:<{}}  {}", entry.name, name_column,
                        hanging(entry.sentence, name_column + 4, reference_width));
  }
  if (lines > most_lines) text += fmt::format("\n  and {} more", lines - most_lines);
  return text;
}

}  // namespace hackle
