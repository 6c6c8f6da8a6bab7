// SPDX-License-Identifier: MIT
// The file of a movie, from what a user says of it to the last frame.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "base/origin.hpp"
#include "base/progress.hpp"
#include "movie/encoder.hpp"
#include "output/files/movie_options.hpp"

namespace hackle {

class MovieFile {
 public:
  // Says what it falls back to, unless it is to be quiet. `origin` is told in the file. Throws what
  // Run::movie throws; writes nothing yet.
  MovieFile(const std::filesystem::path& path, const MovieOptions& options, const Origin& origin,
            int threads, Talk talk);

  // Its ending is that of what it falls back to.
  const std::filesystem::path& path() const { return path_; }
  // About how many bytes so many frames of so many px each take.
  double expected_bytes(std::int64_t frames, double pixels) const;

  // Before the first frame, on the thread that made it: holds the file, so that nobody else films
  // there. An earlier run that was killed while it filmed has left frames that would be written
  // over; they are kept under another name, none that is `taken`, and it says so. Once is enough.
  void begin(const std::function<bool(const std::filesystem::path&)>& taken);
  // Frames follow one another evenly, all of the same even size. Throws what Encoder throws.
  void add(Image frame);
  // Completes the file, unless there was no frame. Once only.
  void finish();

  double seconds() const { return seconds_; }  // of encoding so far

 private:
  void tell(const std::string& note) const;

  std::filesystem::path path_;
  MovieFormat format_;  // its size comes with the first frame
  Talk talk_;
  std::unique_ptr<PartialFile> held_;  // from begin() on, until the encoder has it
  std::unique_ptr<Encoder> encoder_;
  std::atomic<double> seconds_ = 0.0;
  bool begun_ = false;
};

}  // namespace hackle
