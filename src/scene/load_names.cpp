// SPDX-License-Identifier: MIT
#include "scene/load_names.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>

#include <fmt/format.h>

namespace hackle {
namespace {

// Returns the name that a load was given, or nothing for a kind without names.
template <class Load>
const std::string* given_name(const Load& load) {
  if constexpr (requires { load.guided.name; }) return &load.guided.name;
  if constexpr (requires { load.name; }) return &load.name;
  return nullptr;
}

template <class Load>
const Amplitude* amplitude_of_load(const Load& load) {
  if constexpr (requires { load.guided.amplitude; }) return &load.guided.amplitude;
  if constexpr (requires { load.amplitude; }) return &load.amplitude;
  return nullptr;
}

// The first parts of other columns of tables.
constexpr auto taken = std::to_array<std::string_view>({"tip", "crack", "max", "min", "mean"});

}  // namespace

std::string load_name(const std::string& given, std::string_view kind, int number) {
  return given.empty() ? fmt::format("{}{}", kind, number) : given;
}

std::vector<LoadName> load_names(const Loads& loads) {
  std::vector<LoadName> names;
  for_each_list(loads, [&](const auto& list) {
    using Load = typename std::remove_cvref_t<decltype(list)>::value_type;
    constexpr std::string_view kind = description_of<Load>.noun;
    int number = 0;
    for (const Load& load : list)
      if (const std::string* given = given_name(load); given != nullptr) {
        ++number;
        names.push_back({load_name(*given, kind, number), kind, number, !given->empty(),
                         amplitude_of_load(load)});
      }
  });
  return names;
}

bool is_identifier(std::string_view word) {
  const auto letter = [](unsigned char c) { return c < 128 && (std::isalpha(c) != 0 || c == '_'); };
  const auto digit = [](unsigned char c) { return c < 128 && std::isdigit(c) != 0; };
  return !word.empty() && letter(static_cast<unsigned char>(word.front())) &&
         std::ranges::all_of(word, [&](char c) {
           const auto byte = static_cast<unsigned char>(c);
           return letter(byte) || digit(byte);
         });
}

void check_load_names(const Loads& loads, Problems& problems) {
  std::set<std::string> known;
  for (const LoadName& load : load_names(loads)) {
    const bool fresh = known.insert(load.name).second;
    if (!load.is_given) continue;
    if (!is_identifier(load.name))
      problems.add(fmt::format("{}: '{}' is no name for a load", load.kind, load.name),
                   "a name has letters, digits and _, and begins with no digit, as \"grip\"");
    else if (std::ranges::find(taken, load.name) != taken.end())
      problems.add(
          fmt::format("{}: the name '{}' is taken: columns begin so", load.kind, load.name),
          "choose another name");
    else if (!fresh)
      problems.add(fmt::format("{}: two loads are named '{}'", load.kind, load.name),
                   "each name is that of one load");
  }
}

}  // namespace hackle
