// SPDX-License-Identifier: MIT
// Completion at the prompt.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "console/lua/lua_state.hpp"

namespace hackle {

struct Candidate {
  std::string text;   // the whole word: "crack"
  std::string after;  // appended if it is the only candidate: " { "
  bool operator==(const Candidate&) const = default;
};

struct Completion {
  std::size_t typed = 0;              // bytes before the cursor that every candidate begins with
  std::vector<Candidate> candidates;  // sorted, without duplicates

  // Returns the unambiguous text to insert at the cursor: the common rest of all candidates, and
  // for a single one also what follows it.
  std::string insertion() const;
};

// [-0, +0] Completes the end of Lua text, which may be a chunk of several lines: globals, keywords,
// fields and methods of tables and objects, names and values of options of the called function,
// materials, files. Reads tables raw and otherwise only the docs of our types: nothing of the
// script runs. Needs a state with a session, and must be called from within Lua. Throws Error
// (files) if the library of materials cannot be read.
Completion complete(lua_State* L, std::string_view text);

// Formats at most `most` candidates in columns for a terminal of this width in characters; then
// states how many more there are.
std::string in_columns(const std::vector<Candidate>& candidates, std::size_t width,
                       std::size_t max);

}  // namespace hackle
