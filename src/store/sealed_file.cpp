// SPDX-License-Identifier: MIT
#include "store/sealed_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include "base/error.hpp"
#include "base/interrupt.hpp"

namespace hackle {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t seal_digits = 16;
constexpr std::size_t piece = std::size_t{1} << 20U;  // read at once

OpenFile opened(const fs::path& path, const char* mode) {
  OpenFile file(std::fopen(path.c_str(), mode));
  if (!file) refuse_sealed(path, std::strerror(errno));
  return file;
}

std::uint64_t size_of(const fs::path& path) {
  std::error_code failure;
  const std::uint64_t size = fs::file_size(path, failure);
  if (failure) refuse_sealed(path, failure.message());
  return size;
}

}  // namespace

void refuse_sealed(const fs::path& path, std::string_view what, std::string remedy) {
  throw Error(ErrorKind::files, fmt::format("file '{}': {}", path.string(), what),
              std::move(remedy));
}

SealedWriter::SealedWriter(fs::path path) : path_(std::move(path)), file_(opened(path_, "wb")) {
}

// An array without memory has no address to write from.
void SealedWriter::put(const void* bytes, std::size_t count) {
  if (count > 0 && std::fwrite(bytes, 1, count, file_.get()) != count)
    refuse_sealed(path_, std::strerror(errno));
}

void SealedWriter::seal() {
  const std::string hash = hash_.hex();
  put(hash.data(), hash.size());
  if (std::fflush(file_.get()) != 0 || fsync(fileno(file_.get())) != 0)
    refuse_sealed(path_, std::strerror(errno));
  file_.reset();
}

void check_seal(const fs::path& path, std::string_view first_line, Patience patience) {
  const OpenFile file = opened(path, "rb");
  const std::uint64_t size = size_of(path);
  std::vector<char> bytes(piece);
  const auto take = [&](std::size_t count) {
    if (std::fread(bytes.data(), 1, count, file.get()) != count)
      refuse_sealed(path, "it is cut off");
    return std::string_view(bytes.data(), count);
  };
  if (size < first_line.size() + seal_digits || take(first_line.size()) != first_line)
    refuse_sealed(path, fmt::format("it does not begin with '{}'",
                                    first_line.substr(0, first_line.find('\n'))));
  Hash hash;
  hash.add(std::span(first_line));
  for (std::uint64_t left = size - first_line.size() - seal_digits; left > 0;) {
    if (patience == Patience::until_interrupted) throw_if_interrupted();
    const std::size_t count = std::min<std::uint64_t>(left, piece);
    hash.add(std::span(take(count)));
    left -= count;
  }
  if (take(seal_digits) != hash.hex())
    refuse_sealed(path, "it is damaged: its bytes are not those that were written");
}

SealedReader::SealedReader(fs::path path)
    : path_(std::move(path)), file_(opened(path_, "rb")), left_(size_of(path_)) {
}

std::string SealedReader::text(std::uint64_t size) {
  std::string text(checked(size), '\0');
  get(text.data(), text.size());
  return text;
}

std::uint64_t SealedReader::checked(std::uint64_t count, std::size_t size) const {
  if (count > left_ / size) refuse("it is cut off");
  return count;
}

void SealedReader::get(void* bytes, std::size_t count) {
  left_ -= checked(count);
  if (count > 0 && std::fread(bytes, 1, count, file_.get()) != count) refuse("it is cut off");
}

}  // namespace hackle
