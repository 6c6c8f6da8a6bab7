// SPDX-License-Identifier: MIT
// The names by which tables and s:reaction know the loads of a plate.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/loads.hpp"

namespace hackle {

struct LoadName {
  std::string name;       // as given, or "support1"
  std::string_view kind;  // "support", as the noun is called
  int number = 1;         // of its kind, from 1, in the order in which they were described
  bool is_given = false;  // by the user
  const Amplitude* amplitude = nullptr;  // none: of a load that has none
};

// Returns a name for every load that has a name or may have one. The list refers to the loads.
std::vector<LoadName> load_names(const Loads& loads);

// Returns the given name, or the kind with its number: "roller2".
std::string load_name(const std::string& given, std::string_view kind, int number);

// Returns whether it is a word that scripts, tables and other programs take for a name: letters,
// digits and _, not a digit first.
bool is_identifier(std::string_view word);

// Adds a problem for every given name that is no identifier or that two loads share.
void check_load_names(const Loads& loads, Problems& problems);

}  // namespace hackle
