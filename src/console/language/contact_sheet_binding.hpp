// SPDX-License-Identifier: MIT
// contact_sheet { ... }: many pictures on one sheet.
#pragma once

#include <span>

#include "console/schema/schema.hpp"

namespace hackle {

std::span<const Function> contact_sheet_functions();

}  // namespace hackle
