// SPDX-License-Identifier: MIT
// Keys of --set that are for a call of the scene language, not for an option of the script.
#pragma once

#include <string_view>

namespace hackle {

inline constexpr std::string_view simulate_prefix = "simulate.", movie_prefix = "movie.",
                                  material_prefix = "material.", scatter_prefix = "scatter.";

constexpr bool is_of_language(std::string_view key) {
  return key.starts_with(simulate_prefix) || key.starts_with(movie_prefix) ||
         key.starts_with(material_prefix) || key.starts_with(scatter_prefix);
}

}  // namespace hackle
