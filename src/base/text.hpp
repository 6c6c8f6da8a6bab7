// SPDX-License-Identifier: MIT
// Text helpers for messages.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace hackle {

// Returns the candidate with the smallest edit distance (insert, delete, replace, swap of
// neighbours). Returns nothing if that distance exceeds a third of the word, at least 1: a
// suggestion would then mislead. A candidate that starts with the word (4+ letters) counts as one
// edit away.
std::optional<std::string_view> nearest(std::string_view word,
                                        std::span<const std::string_view> candidates);

// Returns " (did you mean 'crack'?)", or "" if no candidate is near.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates);

// Breaks a line at blanks so that no part is wider than `width`, if possible. Continuation lines
// begin with `indent` blanks; the first line counts as indented by as many, which the caller has
// written.
std::string hanging(std::string_view line, std::size_t indent, std::size_t width);

// Breaks every line of a text that is wider than `width` at blanks; what continues is indented as
// its line is, and a line that begins beyond the middle at a quarter of the width.
std::string fitted(std::string_view text, std::size_t width);

// Returns the word as a shell reads it: quoted if necessary.
std::string shell_word(std::string_view word);

// "a, b, c"
std::string comma_list(std::span<const std::string_view> words);

// Returns ", 2 cracks", or "" for none: a part of a line of facts.
std::string counted(std::size_t count, const char* noun);

}  // namespace hackle
