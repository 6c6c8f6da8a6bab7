// SPDX-License-Identifier: MIT
// Makes scripts from bytes with a small grammar: calls of every function of the language with
// options of its own table, with valid and invalid values.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace hackle::test {

// The result always compiles; the same bytes give the same script. Its scenes are small or refused:
// at most a few thousand nodes.
std::string script_of(std::span<const std::uint8_t> bytes);

}  // namespace hackle::test
