// SPDX-License-Identifier: MIT
// Small helpers for messages.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace hackle {

// The candidate with the least edit distance (insert, delete, replace, swap of neighbours), or
// nothing when even that is farther than a third of the word, at least 1: then a suggestion would
// mislead.
std::optional<std::string_view> nearest(std::string_view word,
                                        std::span<const std::string_view> candidates);

// " (did you mean 'crack'?)" or "" when nothing is near.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates);

// "a, b, c"
std::string comma_list(std::span<const std::string_view> words);

}  // namespace hackle
