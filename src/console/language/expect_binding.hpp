// SPDX-License-Identifier: MIT
// expect { ... }: what a scene should give, by which source, and what it gives.
#pragma once

#include "console/schema/schema.hpp"

namespace hackle {

std::span<const Function> expect_functions();

}  // namespace hackle
