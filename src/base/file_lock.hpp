// SPDX-License-Identifier: MIT
// File locks, which tell this and other programs that somebody is writing a file.
#pragma once

#include <filesystem>

namespace hackle {

// Holds a lock on a file, so that others know that a running program writes it. The system releases
// the lock however the program ends.
class FileLock {
 public:
  // Locks a file; with `create`, creates it if it does not exist. A file that cannot be opened, or
  // lies on a file system without locks, is not locked: whoever opens it will report the reason.
  FileLock(const std::filesystem::path& file, bool create);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  bool is_foreign() const { return is_foreign_; }  // another holder has it
  bool is_open() const { return file_ >= 0; }
  // Returns whether this object has the lock: false also on a file system without locks.
  bool is_held() const { return is_held_; }
  // Returns the descriptor of the open file, or -1. A program that inherits it shares the lock.
  int descriptor() const { return file_; }
  // Returns whether the file still has this name; another file may have taken it.
  bool is_at(const std::filesystem::path& file) const;

 private:
  void open(const std::filesystem::path& file, bool create);
  void close();

  int file_ = -1;
  bool is_foreign_ = false;
  bool is_held_ = false;
};

// A file that belongs to this object alone while it lives, and is removed afterwards unless it was
// renamed.
class HeldFile {
 public:
  // Creates and locks `file`. Throws Error (files) if it is locked by somebody else; the message
  // names `written` as the file being written.
  HeldFile(std::filesystem::path file, const std::filesystem::path& written);
  ~HeldFile();

 private:
  std::filesystem::path file_;
  FileLock lock_;
};

// Returns whether anybody, this program included, is writing the file. Readers may hold a shared
// lock on it.
bool is_locked(const std::filesystem::path& file);

// Throws Error (files): `written` cannot be written because `locked` is locked.
[[noreturn]] void refuse_locked(const std::filesystem::path& written,
                                const std::filesystem::path& locked);

}  // namespace hackle
