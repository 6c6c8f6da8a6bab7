// SPDX-License-Identifier: MIT
#include "base/renamed.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/text.hpp"

namespace hackle {
namespace {

struct Renaming {
  std::string_view owner, was, is;
};

constexpr auto renamings = std::to_array<Renaming>({
    {"field", "pieces", "fragments"},
    {"plate", "start", "initial"},
    {"simulation", "pieces", "fragments"},
});

}  // namespace

std::optional<std::string_view> renamed(std::string_view owner, std::string_view name) {
  const auto* const found = std::ranges::find_if(
      renamings, [&](const Renaming& one) { return one.owner == owner && one.was == name; });
  if (found == renamings.end()) return std::nullopt;
  return found->is;
}

std::string present_name(std::string_view owner, std::string_view name,
                         std::span<const std::string_view> candidates) {
  const auto now = renamed(owner, name);
  return now ? fmt::format(" (it is called '{}' now)", *now) : did_you_mean(name, candidates);
}

}  // namespace hackle
