// SPDX-License-Identifier: MIT
// A binary file that ends with the XXH3 of all its other bytes, in sixteen hexadecimal digits: what
// was cut or changed is known before it is used.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "base/hash.hpp"

namespace hackle {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using OpenFile = std::unique_ptr<std::FILE, CloseFile>;

// Throws Error (files): "file 'a.ckpt': what (remedy)".
[[noreturn]] void refuse_sealed(const std::filesystem::path& path, std::string_view what,
                                std::string remedy = {});

// Every function throws Error (files).
class SealedWriter {
 public:
  // Replaces an existing file.
  explicit SealedWriter(std::filesystem::path path);

  template <class T>
  void write(std::span<const T> values) {
    hash_.add(values);
    put(values.data(), values.size_bytes());
  }
  void write(std::string_view text) { write(std::span(text.data(), text.size())); }
  // Adds the hash; returns when the disk has everything.
  void seal();

 private:
  void put(const void* bytes, std::size_t count);

  std::filesystem::path path_;
  OpenFile file_;
  Hash hash_;
};

// Throws Error (files) unless the file begins so and has the bytes that were written. Throws Error
// (interrupted) on Ctrl-C if that may stop it.
enum class Patience { until_interrupted, endless };
void check_seal(const std::filesystem::path& path, std::string_view first_line, Patience patience);

// Reads front to end a file whose seal has been checked. It may still have been made by anybody:
// takes no memory for more than the file holds.
class SealedReader {
 public:
  explicit SealedReader(std::filesystem::path path);

  std::string text(std::uint64_t size);
  template <class T>
  void read(std::span<T> values) {
    get(values.data(), values.size_bytes());
  }
  // Returns the count if the file still has so many things of that size.
  std::uint64_t checked(std::uint64_t count, std::size_t size = 1) const;
  [[noreturn]] void refuse(std::string_view what) const { refuse_sealed(path_, what); }

 private:
  void get(void* bytes, std::size_t count);

  std::filesystem::path path_;
  OpenFile file_;
  std::uint64_t left_;  // bytes
};

}  // namespace hackle
