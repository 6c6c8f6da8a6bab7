// SPDX-License-Identifier: MIT
#include "base/file_lock.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <fstream>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include "base/error.hpp"

namespace hackle {
namespace fs = std::filesystem;
namespace {

// Returns " (process 1234)" for the process that holds a lock on the file, or "" if it is unknown.
std::string holder_of(const fs::path& file) {
  struct stat there {};
  if (::stat(file.c_str(), &there) != 0) return "";
  std::array<char, 64> wanted{};
  std::snprintf(wanted.data(), wanted.size(), "%02x:%02x:%llu", major(there.st_dev),
                minor(there.st_dev), static_cast<unsigned long long>(there.st_ino));
  std::ifstream locks("/proc/locks");
  std::string number, kind, advisory, access, process, place, rest;
  while (locks >> number >> kind) {
    if (kind == "->") continue;  // a process that waits for a lock
    locks >> advisory >> access >> process >> place;
    std::getline(locks, rest);
    if (place == wanted.data()) return " (process " + process + ")";
  }
  return "";
}

}  // namespace

FileLock::FileLock(const fs::path& file, bool create) {
  // A created file may have been removed by its former holder before the lock was free.
  do open(file, create);
  while (create && is_open() && !is_foreign_ && !is_at(file));
}

FileLock::~FileLock() {
  close();
}

void FileLock::open(const fs::path& file, bool create) {
  close();
  // Opened for reading and writing, because some file systems lock only such files; non-blocking,
  // because opening a pipe would wait.
  const int mode = O_RDWR | O_CLOEXEC | O_NONBLOCK | (create ? O_CREAT : 0);
  file_ = ::open(file.c_str(), mode, 0666);
  is_held_ = is_open() && ::flock(file_, LOCK_EX | LOCK_NB) == 0;
  is_foreign_ = is_open() && !is_held_ && errno == EWOULDBLOCK;
}

void FileLock::close() {
  if (is_open()) ::close(std::exchange(file_, -1));
}

bool FileLock::is_at(const fs::path& file) const {
  struct stat ours {
  }, there{};
  return is_open() && ::fstat(file_, &ours) == 0 && ::stat(file.c_str(), &there) == 0 &&
         ours.st_dev == there.st_dev && ours.st_ino == there.st_ino;
}

HeldFile::HeldFile(fs::path file, const fs::path& written)
    : file_(std::move(file)), lock_(file_, true) {
  if (lock_.is_foreign()) refuse_locked(written, file_);
}

HeldFile::~HeldFile() {
  std::error_code ignored;
  if (lock_.is_at(file_)) fs::remove(file_, ignored);
}

bool is_locked(const fs::path& file) {
  const int opened = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (opened < 0) return false;
  const bool is_foreign = ::flock(opened, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(opened);
  return is_foreign;
}

void refuse_locked(const fs::path& written, const fs::path& locked) {
  throw Error(ErrorKind::files,
              "'" + written.string() + "' is being written by another run" + holder_of(locked),
              "wait for it, or choose another file name");
}

}  // namespace hackle
