// SPDX-License-Identifier: MIT
// Stored files as an attacker may change them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace hackle::test {

enum class StoredFile { checkpoint, run_file };

// Returns the bytes of a small file: a loaded, broken plate that is heated and hit by a disc.
std::string whole_file(StoredFile kind, const std::filesystem::path& folder);

// Returns the bytes with some of them changed, inserted, removed or repeated.
std::string damaged_file(std::string bytes, std::uint64_t seed);

// Reads the bytes as a file of that kind, and goes on with what it holds; the seal of a checkpoint
// is made anew, so that what it protects is reached. Throws nothing but Error, which is swallowed;
// returns whether it was read.
bool read_damaged(StoredFile kind, std::string bytes, const std::filesystem::path& folder);

}  // namespace hackle::test
