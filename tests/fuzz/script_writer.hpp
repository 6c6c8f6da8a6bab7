// SPDX-License-Identifier: MIT
// Scripts made from bytes by a small grammar: calls of every function of the language with options
// of its own table, values that fit beside values that do not.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace hackle::test {

// Always Lua that compiles; the same bytes give the same script. What it builds is small or
// refused: at most a few thousand nodes.
std::string script_of(std::span<const std::uint8_t> bytes);

}  // namespace hackle::test
