// SPDX-License-Identifier: MIT
#include "study/case.hpp"

#include <iterator>

#include <fmt/format.h>

namespace hackle {

std::string name_of(const Settings& settings) {
  std::string name;
  for (const auto& [key, value] : settings) {
    const std::size_t dot = key.rfind('.');
    fmt::format_to(std::back_inserter(name), "{}{} {}", name.empty() ? "" : ", ",
                   dot == std::string::npos ? key : key.substr(dot + 1), value);
  }
  return name.empty() ? "as written" : name;
}

Settings joined(Settings first, const Settings& second) {
  for (const auto& [key, value] : second) first[key] = value;
  return first;
}

}  // namespace hackle
