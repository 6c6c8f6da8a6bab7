// SPDX-License-Identifier: MIT
// Locks on files, which tell other programs, and this one, that somebody writes there.
#pragma once

#include <filesystem>

namespace hackle {

// Keeps a lock on a file, so that others know that a living program writes it. The system takes the
// lock off when that ends in whatever way.
class FileLock {
 public:
  // Locks a file; with `create`, creates it if it does not exist. A file that cannot be opened, or
  // lies where nothing can be locked, is not locked: whoever opens it will say why.
  FileLock(const std::filesystem::path& file, bool create);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  bool is_foreign() const { return is_foreign_; }  // somebody else has it
  bool is_open() const { return file_ >= 0; }
  // Whether the file still bears this name; another may by now.
  bool is_at(const std::filesystem::path& file) const;

 private:
  void open(const std::filesystem::path& file, bool create);
  void close();

  int file_ = -1;
  bool is_foreign_ = false;
};

// A file that is ours alone while this lives, and gone afterwards unless it was renamed.
class HeldFile {
 public:
  // Creates and locks `file`. Throws Error (files) when somebody else holds it, saying that
  // `written` is what is written there.
  HeldFile(std::filesystem::path file, const std::filesystem::path& written);
  ~HeldFile();

 private:
  std::filesystem::path file_;
  FileLock lock_;
};

// Whether somebody, this program included, writes the file. Who reads it may share a lock on it.
bool is_locked(const std::filesystem::path& file);

// Throws Error (files): `written` cannot be, because of the lock on `locked`.
[[noreturn]] void refuse_locked(const std::filesystem::path& written,
                                const std::filesystem::path& locked);

}  // namespace hackle
