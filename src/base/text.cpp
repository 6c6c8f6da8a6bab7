// SPDX-License-Identifier: MIT
#include "base/text.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

namespace hackle {
namespace {

constexpr std::size_t shortest_beginning = 4;

// Computes the optimal string alignment distance with three rows of the usual table.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> older(b.size() + 1), old(b.size() + 1), now(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) old[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    now[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = old[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      now[j] = std::min({replaced, old[j] + 1, now[j - 1] + 1});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) now[j] = std::min(now[j], older[j - 2] + 1);
    }
    std::swap(older, old);
    std::swap(old, now);
  }
  return old[b.size()];
}

}  // namespace

std::optional<std::string_view> nearest(std::string_view word,
                                        std::span<const std::string_view> candidates) {
  std::optional<std::string_view> best;
  std::size_t min = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (std::string_view candidate : candidates) {
    const bool begun = word.size() >= shortest_beginning && candidate.starts_with(word);
    const std::size_t distance = begun ? std::min<std::size_t>(1, candidate.size() - word.size())
                                       : edit_distance(word, candidate);
    if (distance < min) {
      min = distance;
      best = candidate;
    }
  }
  return best;
}

std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates) {
  const auto best = nearest(word, candidates);
  return best ? " (did you mean '" + std::string(*best) + "'?)" : std::string();
}

std::string hanging(std::string_view line, std::size_t indent, std::size_t width) {
  std::string text;
  std::size_t used = indent;
  while (!line.empty()) {
    const std::string_view word = line.substr(0, std::min(line.find(' ', 1), line.size()));
    line.remove_prefix(word.size());
    if (used + word.size() > width && used > indent && word.front() == ' ') {
      text.append("\n").append(indent, ' ').append(word.substr(1));
      used = indent + word.size() - 1;
    } else {
      text += word;
      used += word.size();
    }
  }
  return text;
}

std::string fitted(std::string_view text, std::size_t width) {
  std::string result;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    const std::size_t blanks = std::min(line.find_first_not_of(' '), line.size());
    const std::size_t indent = 2 * blanks > width ? width / 4 : blanks;
    result += line.size() <= width
                  ? std::string(line)
                  : std::string(indent, ' ') + hanging(line.substr(blanks), indent, width);
    text.remove_prefix(line.size());
    if (text.empty()) break;
    result += '\n';
    text.remove_prefix(1);
  }
  return result;
}

std::string shell_word(std::string_view word) {
  constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_@%+=:,./-";
  if (!word.empty() && word.find_first_not_of(plain) == std::string_view::npos)
    return std::string(word);
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

std::string comma_list(std::span<const std::string_view> words) {
  std::string text;
  for (std::string_view word : words) {
    if (!text.empty()) text += ", ";
    text += word;
  }
  return text;
}

std::string counted(std::size_t count, const char* noun) {
  return count == 0 ? std::string() : fmt::format(", {} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace hackle
