// SPDX-License-Identifier: MIT
// The file of a movie, from the user's options to the last frame.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "base/origin.hpp"
#include "base/progress.hpp"
#include "movie/encoder.hpp"
#include "movie/kept_frames.hpp"
#include "output/files/movie_options.hpp"
#include "render/overlay/layout.hpp"

namespace hackle {

class MovieFile {
 public:
  // Reports a fallback to another kind, unless it is quiet. `origin` goes into the metadata. Throws
  // what Run::movie throws; writes nothing yet.
  MovieFile(const std::filesystem::path& path, const MovieOptions& options, const Origin& origin,
            int threads, Talk talk);

  // Has the extension of the fallback, if there is one.
  const std::filesystem::path& path() const { return path_; }
  // Estimates the bytes of `frames` frames of `pixels` px each.
  double expected_bytes(std::int64_t frames, double pixels) const;

  // Call this before the first frame, on the thread that made the object: it holds the file, so
  // that nobody else writes it. Frames left by an earlier, killed run would be overwritten; they
  // are kept under another name, not `taken`, which is reported. One call suffices.
  void begin(const std::function<bool(const std::filesystem::path&)>& taken);
  // Adds a frame; frames are equally spaced and of the same even size. The note is kept with it.
  // Throws what Encoder throws.
  void add(Image frame, std::string_view note = {});
  // Completes the file, unless there was no frame. Call it only once.
  void finish();

  // Call this before begin(): keeps the frames for another program, see KeptFrames.
  void keep_frames() { keeps_ = true; }
  bool keeps() const { return keeps_; }
  // Returns the kept frames, from begin() or continue_from() on; null if they are not kept.
  const std::shared_ptr<KeptFrames>& kept() const { return kept_; }
  // Instead of begin(): goes on behind the first `frames` frames that a former program kept, of
  // this size in px, and returns the note of the last one. What else that program left is removed.
  // Throws Error (files), with a remedy, if there are not so many.
  std::string continue_from(std::int64_t frames, const Layout& size);
  // Then, before the first frame is added, encodes those.
  void film_kept(std::int64_t frames);

  double seconds() const { return seconds_; }  // spent encoding so far

 private:
  void tell(const std::string& note) const;
  void hold();
  void encode(Image frame);

  std::filesystem::path path_;
  MovieFormat format_;  // its size is that of the first frame
  Talk talk_;
  std::unique_ptr<PartialFile> held_;  // from begin() on, until the encoder takes it
  std::unique_ptr<Encoder> encoder_;
  std::shared_ptr<KeptFrames> kept_;
  std::atomic<double> seconds_ = 0.0;
  bool begun_ = false;
  bool keeps_ = false;
};

}  // namespace hackle
