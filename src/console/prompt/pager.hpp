// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace hackle {

// Prints a text on the terminal at stdout, a screen at a time if it is longer than that: space,
// Enter or the Down key go on, q and Ctrl-C end it. What a person has typed ahead, or pastes, is
// not taken for an answer: the text then comes as a whole.
void show_in_pages(const std::string& text);

}  // namespace hackle
