// SPDX-License-Identifier: MIT
#include "movie/byte_file.hpp"

#include <algorithm>
#include <cerrno>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "base/files.hpp"
#include "movie/av.hpp"

namespace hackle {

Bytes& Bytes::add(std::string_view text) {
  bytes_.insert(bytes_.end(), text.begin(), text.end());
  return *this;
}

Bytes& Bytes::add(std::span<const std::uint8_t> bytes) {
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  return *this;
}

Bytes& Bytes::number(std::uint64_t value, int count) {
  for (int k = 0; k < count; ++k) bytes_.push_back(static_cast<std::uint8_t>(value >> (8 * k)));
  return *this;
}

ByteFile::ByteFile(const std::filesystem::path& path)
    : path_(path),
      file_(::open(partial_name(path).c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
  if (file_ < 0) av::fail(path_, "create", AVERROR(errno));
}

ByteFile::~ByteFile() {
  if (file_ >= 0) ::close(file_);
}

void ByteFile::write(const Bytes& bytes, std::int64_t at) {
  std::span<const std::uint8_t> left = bytes.all();
  while (!left.empty()) {
    const ssize_t written = ::pwrite(file_, left.data(), left.size(), at);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) av::fail(path_, "write", AVERROR(errno));
    left = left.subspan(static_cast<std::size_t>(written));
    at += written;
  }
  size_ = std::max(size_, at);
}

void ByteFile::close() {
  if (::close(std::exchange(file_, -1)) != 0) av::fail(path_, "write", AVERROR(errno));
}

}  // namespace hackle
