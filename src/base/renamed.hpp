// SPDX-License-Identifier: MIT
// Names that earlier versions used in scripts: an error for one of them tells the new name.
#pragma once

#include <optional>
#include <string_view>

namespace hackle {

// The present name of what `owner`, a type such as "plate" or "field" of a picture, once called
// `name`; nothing when it never did.
std::optional<std::string_view> renamed(std::string_view owner, std::string_view name);

}  // namespace hackle
