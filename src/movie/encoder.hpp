// SPDX-License-Identifier: MIT
// Encodes pictures to a movie, whose kind follows from the extension of its name.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "base/image.hpp"
#include "base/partial_file.hpp"
#include "movie/movie_format.hpp"

namespace hackle {

// Encodes on its own thread, behind a queue of a few frames. The file has a partial name until
// finish() has completed it; under that name it also plays, up to about the last second encoded, so
// that a killed program leaves a movie; see rescue().
class Encoder {
 public:
  // Opens the file, replacing any file under its partial name. Throws Error (files) if it cannot be
  // written or another run is writing it, Error (run_failed) if FFmpeg lacks the encoder (names the
  // package), Error (refused) for impossible formats, all problems at once. The partial file may
  // already be `held`.
  Encoder(const std::filesystem::path& path, const MovieFormat& format,
          std::unique_ptr<PartialFile> held = nullptr);
  // Removes the partial file unless finish() has completed it. An earlier file of the same name is
  // unchanged until then.
  ~Encoder();

  // Queues a frame; waits while the queue is full. Frame k is shown at k/fps, rounded to the tick
  // of the kind: 1/100 s in a GIF, 1 ms in WebP, webm and mkv. Errors of the encoder's thread are
  // rethrown here or in finish().
  void add(Image frame);
  // Encodes the queued frames and repeats the last one for as long as it is held, closes the file
  // and renames it. Call it only once.
  void finish();

  int frames() const;      // queued so far, without held repeats
  double seconds() const;  // spent encoding so far; exact after finish()

  static std::string library_version();  // "libavcodec 59.37.100, ..."

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hackle
