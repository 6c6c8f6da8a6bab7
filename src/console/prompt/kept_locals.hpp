// SPDX-License-Identifier: MIT
// Locals at the top of lines that are typed or pasted. To Lua each chunk at the prompt is a program
// of its own, with which its locals end; in a script they last to its end, which is what is meant.
#pragma once

#include <string>
#include <string_view>

namespace hackle {

// Returns the text with `local` left out where it stands outside every block, so that the variables
// are global and stay: `local a, b` becomes `a, b = nil`, `local function f` becomes `function f`,
// and <const> goes. Variables to be closed stay local. Lines keep their numbers.
std::string with_locals_kept(std::string_view text);

// Returns whether a word stands outside every block whose effect would reach beyond the text if it
// were a part of a longer one: local, return, goto.
bool needs_a_scope(std::string_view text);

}  // namespace hackle
