// SPDX-License-Identifier: MIT
// Script names of earlier versions: an error for an old name tells the new one.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace hackle {

// Returns the new name of what `owner`, a type such as "plate" or "field" of a picture, once called
// `name`; nothing if it never had that name.
std::optional<std::string_view> renamed(std::string_view owner, std::string_view name);

// " (it is called 'fragments' now)" for a former name, else did_you_mean().
std::string present_name(std::string_view owner, std::string_view name,
                         std::span<const std::string_view> candidates);

}  // namespace hackle
