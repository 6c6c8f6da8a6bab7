// SPDX-License-Identifier: MIT
// Pictures to a video file, of the kind that the ending of its name says.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "base/image.hpp"
#include "base/partial_file.hpp"
#include "movie/movie_format.hpp"

namespace hackle {

// Encodes on a thread of its own, behind a queue of a few frames. The file bears a partial name
// until finish() has completed it; under that it plays too, up to about the last second of what was
// encoded, so a program that is killed leaves a movie behind; see rescue().
class Encoder {
 public:
  // Opens the file, over what is under its partial name. Throws Error (files) when it cannot be
  // written or is being filmed by another run, Error (run_failed) when FFmpeg lacks the encoder
  // (names the package), Error (refused) for impossible formats, all problems at once. The partial
  // file may be `held` already.
  Encoder(const std::filesystem::path& path, const MovieFormat& format,
          std::unique_ptr<PartialFile> held = nullptr);
  // Removes the partial file unless finish() has completed it. A file of the same name from an
  // earlier run stays as it is until then.
  ~Encoder();

  // Hands a frame over; waits while the queue is full. Frame k is shown at k/fps, to the tick of
  // the kind: 1/100 s in a GIF, 1 ms in WebP, webm and mkv. Errors of the encoder's thread come out
  // here or in finish().
  void add(Image frame);
  // Encodes what waits, and the last frame again for as long as it is held, closes the file and
  // gives it its name. Once only.
  void finish();

  int frames() const;      // handed over so far, without those that are held
  double seconds() const;  // of encoding so far; exact after finish()

  static std::string library_version();  // "libavcodec 59.37.100, ..."

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hackle
