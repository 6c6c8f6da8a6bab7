// SPDX-License-Identifier: MIT
#include "movie/partial_file.hpp"

#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "base/error.hpp"
#include "base/files.hpp"

namespace hackle {

FileLock::FileLock(const std::filesystem::path& file, bool create)
    : file_(::open(file.c_str(), O_RDWR | O_CLOEXEC | (create ? O_CREAT : 0), 0666)) {
  is_foreign_ = is_open() && ::flock(file_, LOCK_EX | LOCK_NB) != 0;
}

FileLock::~FileLock() {
  if (is_open()) ::close(file_);
}

PartialFile::PartialFile(const std::filesystem::path& path)
    : path_(path), lock_(partial_name(path), true) {
  if (lock_.is_foreign())
    throw Error(ErrorKind::files, "'" + path.string() + "' is being filmed by another run",
                "wait for it, or choose another file name");
}

PartialFile::~PartialFile() {
  std::error_code ignored;
  std::filesystem::remove(partial_name(path_), ignored);
}

}  // namespace hackle
