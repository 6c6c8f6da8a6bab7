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

ByteFile::ByteFile(const std::filesystem::path& path) : ByteFile(partial_name(path), path, 0) {
}

ByteFile::ByteFile(const std::filesystem::path& file, const std::filesystem::path& movie,
                   std::int64_t size)
    : path_(movie), file_(::open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666)), size_(size) {
  if (file_ < 0) av::fail(path_, "create", AVERROR(errno));
  if (::ftruncate(file_, size) == 0) return;
  const int cause = errno;
  ::close(file_);
  av::fail(path_, "write", AVERROR(cause));
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

void ByteFile::sync() {
  if (::fdatasync(file_) != 0) av::fail(path_, "write", AVERROR(errno));
}

void ByteFile::close() {
  if (::close(std::exchange(file_, -1)) != 0) av::fail(path_, "write", AVERROR(errno));
}

}  // namespace hackle
