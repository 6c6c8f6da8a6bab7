// SPDX-License-Identifier: MIT
// What may come next at the prompt.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "console/lua/lua_state.hpp"

namespace hackle {

struct Candidate {
  std::string text;   // the whole word: "crack"
  std::string after;  // what follows when it is the only one: " { "
  bool operator==(const Candidate&) const = default;
};

struct Completion {
  std::size_t typed = 0;              // bytes before the cursor that every candidate begins with
  std::vector<Candidate> candidates;  // in order, each text once

  // What can be added at the cursor without a choice: the rest that all candidates have in common,
  // and behind the only one what follows it.
  std::string insertion() const;
};

// [-0, +0] Completes the end of Lua text, which may be a chunk of several lines: globals, keywords,
// fields and methods of tables and objects, names and values of options of the function that is
// being called, materials, files. Reads tables raw and the docs of our types alone: nothing of the
// script runs. Wants a state with a session, and to be called from within Lua. Throws Error (files)
// when the library of materials cannot be read.
Completion complete(lua_State* L, std::string_view text);

// The texts in columns for a terminal so many characters wide, at most `most` of them; then how
// many more there are.
std::string in_columns(const std::vector<Candidate>& candidates, std::size_t width,
                       std::size_t most);

}  // namespace hackle
