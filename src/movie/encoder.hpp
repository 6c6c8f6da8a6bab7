// SPDX-License-Identifier: MIT
// Pictures to a video file: H.264 High, yuv420p, BT.709, faststart, in an MP4.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "base/image.hpp"

namespace hackle {

struct MovieFormat {
  int width = 0;      // px, even
  int height = 0;     // px, even
  double fps = 30.0;  // frames a second, 0.1 .. 1000
  int crf = 18;       // x264 quality, 1 (best) .. 51; 0 is lossless, which few players take
  int threads = 1;    // of the encoder, at least 1
  std::string title;  // metadata; may be empty
};

// Encodes on a thread of its own, behind a queue of a few frames. The file bears a partial name
// until finish() has completed it.
class Encoder {
 public:
  // Opens the file. Throws Error (files) when it cannot be written, Error (run_failed) when FFmpeg
  // has no H.264 encoder (names the package), Error (refused) for impossible formats,
  // all problems at once.
  Encoder(const std::filesystem::path& path, const MovieFormat& format);
  // Removes the partial file unless finish() has completed it. A file of the same name from an
  // earlier run stays as it is until then.
  ~Encoder();

  // Hands a frame over; waits while the queue is full. Frame k is shown at k/fps. Errors of the
  // encoder's thread come out here or in finish().
  void add(Image frame);
  // Encodes what waits, closes the file and gives it its name. Once only.
  void finish();

  int frames() const;      // handed over so far
  double seconds() const;  // of encoding so far; exact after finish()

  static std::string library_version();  // "libavcodec 59.37.100, ..."

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hackle
