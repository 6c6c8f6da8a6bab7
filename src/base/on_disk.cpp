// SPDX-License-Identifier: MIT
#include "base/on_disk.hpp"

#include <cerrno>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

#include "base/error.hpp"

namespace hackle {

void bring_file_to_disk(const std::filesystem::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0) return;
  const int failure = ::fsync(file) == 0 ? 0 : errno;
  ::close(file);
  if (failure != 0 && failure != EINVAL)  // a pipe has no disk
    throw Error(ErrorKind::files, "cannot write '" + path.string() +
                                      "': " + std::generic_category().message(failure));
}

}  // namespace hackle
