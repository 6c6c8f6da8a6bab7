// SPDX-License-Identifier: MIT
// The pictures of a movie, kept beside it while it is filmed. The state of an encoder cannot be
// stored: a movie that another program goes on with is encoded again, from these, to the same
// bytes.
//
// A running crack changes few pixels, so a picture is kept as what changes (frame_delta.hpp).
// Measured on 160 frames of 1280 x 640 of the edge crack, per frame: damage 0.31 ms of CPU time and
// 1.1 kB, speed 0.75 ms and 29 kB, smooth speed 4.6 ms and 370 kB; painting and encoding take 18,
// 45 and 240 ms. Beside a run, which shares the caches, it is 0.55 ms for damage: 3 % of the CPU
// time of scripts/samples/edge_crack.lua. FFmpeg's cheapest lossless encoder, QuickTime Animation,
// takes 9 ms for damage.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include "base/image.hpp"
#include "movie/byte_file.hpp"

namespace hackle {

// "a/movie.mp4" -> "a/.movie.mp4.frames"
std::filesystem::path kept_frames_name(const std::filesystem::path& movie);

// What all frames have in common. The bytes of some kinds depend on the threads of their encoder.
struct FrameFormat {
  int width = 0, height = 0;  // px
  int threads = 1;
};

// Reads the frames of a movie one after another. The file is not trusted: no content makes it take
// more memory than a picture of the largest size and the file itself.
class KeptFramesReader {
 public:
  // Throws Error (files) if the file cannot be read or does not begin as it should.
  explicit KeptFramesReader(const std::filesystem::path& movie);

  const FrameFormat& format() const { return format_; }
  // Goes to the next frame, at first to the first. Returns false, for ever, if no whole one
  // follows.
  bool next();
  const Image& picture() const { return picture_; }
  const std::string& note() const { return note_; }
  // The end of the present frame in the file, bytes.
  std::int64_t end() const { return end_; }

  // Says that the frames are not what is needed. Throws Error (files).
  [[noreturn]] void refuse(const std::string& what) const;

 private:
  bool take(std::string& text, std::uint64_t size);
  bool take_numbers(std::uint32_t* numbers, int count);
  bool take_frame();

  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::filesystem::path movie_;
  std::unique_ptr<std::FILE, Close> file_;
  std::int64_t left_ = 0, end_ = 0;  // bytes
  FrameFormat format_;
  Image picture_;
  std::string note_, delta_;
};

// Keeps frames. Each is whole on its way to the disk when add() returns: a killed program loses
// none.
class KeptFrames {
 public:
  // Begins anew. Every function throws Error (files), which names the movie.
  explicit KeptFrames(const std::filesystem::path& movie);
  // Goes on behind the present frame of the reader, the `count`-th, and drops later ones.
  KeptFrames(const std::filesystem::path& movie, const KeptFramesReader& former,
             std::int64_t count);

  // The note goes with the picture. All frames have the format of the first.
  void add(const Image& picture, const FrameFormat& format, std::string_view note);
  // Says that no more frames will be added, because of a failure.
  void give_up();

  // Returns when that many frames, in all, have reached the disk. For any thread. Throws Error
  // (files) if they will not.
  void wait_for(std::int64_t count);

 private:
  std::filesystem::path movie_;
  ByteFile file_;
  Image last_;
  std::mutex mutex_;  // of what follows
  std::condition_variable added_;
  std::int64_t count_ = 0;
  bool given_up_ = false;
};

}  // namespace hackle
