// SPDX-License-Identifier: MIT
#pragma once

#include "base/described.hpp"

namespace hackle {

// The name by which tables and s:reaction know a load; see load_names.hpp.
inline constexpr About about_load_name{
    .fallback = "its kind and number",
    .sentence = "Name of the load in tables and for s:reaction, as \"grip\"."};

}  // namespace hackle
