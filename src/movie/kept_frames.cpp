// SPDX-License-Identifier: MIT
// The file begins with a line, and width, height and threads in four bytes each. A frame has the
// sizes of its note and its delta in four bytes each, their hash, and both.
#include "movie/kept_frames.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/hash.hpp"
#include "movie/frame_delta.hpp"

namespace hackle {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view first_line = "Hackle frames 1\n";
constexpr std::uint32_t max_side = 16384, max_threads = 4096;
constexpr std::size_t hash_digits = 16;

std::string hash_of(std::string_view note, std::span<const std::uint8_t> delta) {
  Hash hash;
  hash.add(std::span(note.data(), note.size()));
  hash.add(delta);
  return hash.hex();
}

std::span<const std::uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace

fs::path kept_frames_name(const fs::path& movie) {
  return movie.parent_path() / fmt::format(".{}.frames", movie.filename().string());
}

KeptFramesReader::KeptFramesReader(const fs::path& movie)
    : movie_(movie), file_(std::fopen(kept_frames_name(movie).c_str(), "rb")) {
  if (!file_) refuse(std::strerror(errno));
  std::error_code failure;
  left_ = static_cast<std::int64_t>(fs::file_size(kept_frames_name(movie), failure));
  std::string line;
  std::array<std::uint32_t, 3> head{};
  if (failure || !take(line, first_line.size()) || line != first_line ||
      !take_numbers(head.data(), 3) || head[0] - 1 >= max_side || head[1] - 1 >= max_side ||
      head[2] - 1 >= max_threads)
    refuse("it does not begin as it should");
  format_ = {static_cast<int>(head[0]), static_cast<int>(head[1]), static_cast<int>(head[2])};
  picture_ = Image(format_.width, format_.height);
}

void KeptFramesReader::refuse(const std::string& what) const {
  throw Error(ErrorKind::files,
              fmt::format("'{}' cannot be continued from '{}': {}", movie_.string(),
                          kept_frames_name(movie_).filename().string(), what),
              "begin anew with --fresh; a run that is recorded can be filmed again with hackle "
              "render");
}

bool KeptFramesReader::take(std::string& text, std::uint64_t size) {
  if (size > static_cast<std::uint64_t>(left_)) return false;
  text.resize(size);
  left_ -= static_cast<std::int64_t>(size);
  end_ += static_cast<std::int64_t>(size);
  return std::fread(text.data(), 1, size, file_.get()) == size;
}

bool KeptFramesReader::take_numbers(std::uint32_t* numbers, int count) {
  std::string text;
  if (!take(text, 4 * static_cast<std::uint64_t>(count))) return false;
  std::memcpy(numbers, text.data(), text.size());
  return true;
}

bool KeptFramesReader::take_frame() {
  std::array<std::uint32_t, 2> sizes{};
  std::string hash;
  return take_numbers(sizes.data(), 2) && take(hash, hash_digits) && take(note_, sizes[0]) &&
         take(delta_, sizes[1]) && hash_of(note_, bytes_of(delta_)) == hash &&
         apply_delta(bytes_of(delta_), picture_);
}

bool KeptFramesReader::next() {
  if (take_frame()) return true;
  left_ = 0;
  return false;
}

KeptFrames::KeptFrames(const fs::path& movie)
    : movie_(movie), file_(kept_frames_name(movie), movie, 0) {
}

KeptFrames::KeptFrames(const fs::path& movie, const KeptFramesReader& former, std::int64_t count)
    : movie_(movie),
      file_(kept_frames_name(movie), movie, former.end()),
      last_(former.picture()),
      count_(count) {
}

void KeptFrames::add(const Image& picture, const FrameFormat& format, std::string_view note) {
  Bytes bytes;
  if (file_.size() == 0) {
    bytes.add(first_line).number(format.width, 4).number(format.height, 4);
    bytes.number(format.threads, 4);
    last_ = Image(format.width, format.height);
  }
  const Bytes delta = advance_by_delta(last_, picture);
  bytes.number(note.size(), 4).number(delta.size(), 4).add(hash_of(note, delta.all()));
  file_.append(bytes.add(note).add(delta.all()));
  const std::lock_guard lock(mutex_);
  ++count_;
  added_.notify_all();
}

void KeptFrames::give_up() {
  const std::lock_guard lock(mutex_);
  given_up_ = true;
  added_.notify_all();
}

void KeptFrames::wait_for(std::int64_t count) {
  {
    std::unique_lock lock(mutex_);
    added_.wait(lock, [&] { return count_ >= count || given_up_; });
    if (count_ < count)
      throw Error(ErrorKind::files, fmt::format("the movie '{}' has failed", movie_.string()));
  }
  file_.sync();
}

}  // namespace hackle
