// SPDX-License-Identifier: MIT
// Small helpers for messages.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace hackle {

// The candidate with the least edit distance (insert, delete, replace, swap of neighbours), or
// nothing when even that is farther than a third of the word, at least 1: then a suggestion would
// mislead. A candidate that starts with the word (4 letters or more) counts as one edit away.
std::optional<std::string_view> nearest(std::string_view word,
                                        std::span<const std::string_view> candidates);

// " (did you mean 'crack'?)" or "" when nothing is near.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates);

// Breaks a line at blanks so that none is wider than `width`, if it can; every line but the first
// begins with `indent` blanks, and the first has as many before it that count.
std::string hanging(std::string_view line, std::size_t indent, std::size_t width);

// As a shell takes it for one word: in quotes where it must be.
std::string shell_word(std::string_view word);

// "a, b, c"
std::string comma_list(std::span<const std::string_view> words);

// ", 2 cracks", or "" for none: a part of a line of facts.
std::string counted(std::size_t count, const char* noun);

}  // namespace hackle
