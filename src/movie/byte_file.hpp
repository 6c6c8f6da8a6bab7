// SPDX-License-Identifier: MIT
// A file of a movie whose bytes we write ourselves, without buffering.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace hackle {

// Bytes to be written, least significant byte first.
class Bytes {
 public:
  Bytes& add(std::string_view text);
  Bytes& add(std::span<const std::uint8_t> bytes);
  // Appends the lowest `count` bytes of a number.
  Bytes& number(std::uint64_t value, int count);

  std::span<const std::uint8_t> all() const { return bytes_; }
  std::size_t size() const { return bytes_.size(); }

 private:
  std::vector<std::uint8_t> bytes_;
};

class ByteFile {
 public:
  // Creates the partial file of `path`, or empties it. Every function throws Error (files).
  explicit ByteFile(const std::filesystem::path& path);
  // Creates `file`, or cuts it to its first `size` bytes. Messages name the movie.
  ByteFile(const std::filesystem::path& file, const std::filesystem::path& movie,
           std::int64_t size);
  ~ByteFile();
  ByteFile(const ByteFile&) = delete;
  ByteFile& operator=(const ByteFile&) = delete;

  void write(const Bytes& bytes, std::int64_t at);
  void append(const Bytes& bytes) { write(bytes, size_); }
  std::int64_t size() const { return size_; }
  // Returns when everything is on the disk. For any thread.
  void sync();
  void close();

 private:
  std::filesystem::path path_;
  int file_;
  std::int64_t size_ = 0;
};

}  // namespace hackle
