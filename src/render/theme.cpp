// SPDX-License-Identifier: MIT
#include "render/theme.hpp"

#include <algorithm>
#include <utility>

namespace hackle {
namespace {

// Colours of curves: after Okabe and Ito, "Color Universal Design" (2008); darker on white, so that
// names in these colours are legible.
constexpr Theme dark{
    .background = background_colour,
    .text = {222, 228, 236},
    .quiet = {140, 150, 166},
    .outline = {70, 82, 102},
    .disc = {150, 170, 190},
    .gap = background_colour,
    .curves = {{{86, 180, 233}, {230, 159, 0}, {224, 112, 80}, {0, 178, 135}, {204, 121, 167}}}};
constexpr Theme light{
    .background = {255, 255, 255},
    .text = {28, 32, 40},
    .quiet = {92, 100, 114},
    .outline = {172, 180, 192},
    .disc = {92, 112, 136},
    .gap = {28, 32, 40},
    .curves = {{{0, 114, 178}, {160, 104, 0}, {176, 52, 24}, {0, 132, 98}, {168, 84, 132}}}};

constexpr Theme seen_through(Theme theme) {
  theme.opacity = 0.0;
  return theme;
}
constexpr auto light_maps = std::to_array<std::pair<std::string_view, std::string_view>>(
    {{"damage", "ember"}, {"inferno", "ember"}, {"viridis", "lagoon"}});

constexpr Theme transparent = seen_through(light);

}  // namespace

const Theme& theme_of(Background background) {
  switch (background) {
    case Background::light:
      return light;
    case Background::transparent:
      return transparent;
    case Background::dark:
      break;
  }
  return dark;
}

std::string_view colours_for(Look look, std::string_view usual) {
  const auto found = std::ranges::find(light_maps, usual, &decltype(light_maps)::value_type::first);
  return look == Look::dark || found == light_maps.end() ? usual : found->second;
}

}  // namespace hackle
