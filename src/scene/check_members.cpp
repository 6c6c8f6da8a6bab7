// SPDX-License-Identifier: MIT
#include "scene/check_members.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/renamed.hpp"
#include "base/text.hpp"

namespace hackle {

void check_value(double value, std::string_view who, std::string_view name, const About& about,
                 Problems& problems) {
  if (auto found = objection(who, name, value, about.unit, about.range))
    problems.add(std::move(*found), std::string(about.remedy));
}

void check_value(const Vec2& value, std::string_view who, std::string_view name, const About&,
                 Problems& problems) {
  if (!value.allFinite())
    problems.add(fmt::format("{}: {} is {{{}, {}}}, expected finite numbers", who, name, value.x(),
                             value.y()));
}

void check_value(const std::string& value, std::string_view who, std::string_view name,
                 const About& about, Problems& problems) {
  if (value.empty() || about.choices.empty()) return;
  if (std::ranges::find(about.choices, value) == about.choices.end())
    problems.add(
        fmt::format("{}: {} is '{}'{}", who, name, value, present_name(name, value, about.choices)),
        "one of " + comma_list(about.choices));
}

}  // namespace hackle
