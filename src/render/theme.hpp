// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

namespace hackle {

enum class Background { dark, light, transparent };
inline constexpr std::array<std::string_view, 3> background_names{"dark", "light", "transparent"};

}  // namespace hackle
