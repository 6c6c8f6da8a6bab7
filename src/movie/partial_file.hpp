// SPDX-License-Identifier: MIT
// The partial file of a movie while it is filmed: ours alone, and gone when nothing comes of it.
#pragma once

#include <filesystem>

namespace hackle {

// Keeps a lock on a file, so that others know that a living program writes it. The system takes the
// lock off when that ends in whatever way.
class FileLock {
 public:
  // Locks a file; with `create`, creates it if it does not exist. A file that cannot be opened is
  // not locked: whoever opens it will say why.
  FileLock(const std::filesystem::path& file, bool create);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  bool is_foreign() const { return is_foreign_; }  // somebody else has it
  bool is_open() const { return file_ >= 0; }

 private:
  int file_;
  bool is_foreign_ = false;
};

class PartialFile {
 public:
  // Creates and locks the partial file of `path`. Throws Error (files) when another program, or
  // another movie of this one, is being filmed there.
  explicit PartialFile(const std::filesystem::path& path);
  // Removes it; after publish() there is none.
  ~PartialFile();

 private:
  std::filesystem::path path_;
  FileLock lock_;
};

}  // namespace hackle
