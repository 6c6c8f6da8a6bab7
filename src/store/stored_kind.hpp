// SPDX-License-Identifier: MIT
// Which kind of file of ours it may be, by how it begins.
#pragma once

#include <filesystem>
#include <string>

namespace hackle {

enum class StoredKind { run, checkpoint, other };

// A file of HDF5 counts as a run file: reading it tells whether it is one. Throws Error (files) for
// a file that is missing, no plain file or cannot be read.
StoredKind kind_of_stored(const std::filesystem::path& path);

// Throws Error (files): "cannot read 'a.txt': it is neither ... nor ... of Hackle".
[[noreturn]] void refuse_kind(const std::filesystem::path& path, const std::string& what);

}  // namespace hackle
