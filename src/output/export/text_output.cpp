// SPDX-License-Identifier: MIT
#include "output/export/text_output.hpp"

#include <cerrno>
#include <cstring>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/files.hpp"

namespace hackle {

TextOutput::TextOutput(const std::filesystem::path& path)
    : path_(path), held_(path), file_(partial_name(path), std::ios::binary) {
}

void TextOutput::finish() {
  file_.close();
  if (!file_)
    throw Error(ErrorKind::files,
                fmt::format("cannot write '{}': {}", path_.string(), std::strerror(errno)));
  publish(path_);
}

}  // namespace hackle
