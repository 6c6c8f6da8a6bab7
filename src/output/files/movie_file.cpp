// SPDX-License-Identifier: MIT
#include "output/files/movie_file.hpp"

#include <algorithm>
#include <cstdio>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "base/files.hpp"
#include "base/hash.hpp"
#include "base/terminal.hpp"
#include "base/version.hpp"
#include "movie/rescue.hpp"
#include "scene/check_members.hpp"

namespace hackle {
namespace {

// The script that made the movie, so that it can be made again.
std::string comment_of(const Origin& origin) {
  std::string text = fmt::format("Made by Hackle {} ({})", version(), git_hash());
  if (origin.script_text.empty()) return text;
  Hash hash;
  hash.add(std::span<const char>(origin.script_text));
  const std::string name = std::filesystem::path(origin.script_name).filename().string();
  return text + fmt::format(" from {}, XXH3 {}", name.empty() ? "the prompt" : name, hash.hex());
}

MovieFormat format_of(const MovieOptions& options) {
  MovieFormat format;
  format.fps = options.fps;
  format.profile = options.profile;
  format.crf = options.crf;
  format.hold = options.hold;
  return format;
}

void check(const std::filesystem::path& path, const MovieOptions& options) {
  Problems problems;
  check_members(options, "movie", problems);
  if (problems.empty()) check_settings(path, format_of(options), problems);
  problems.throw_if_any();
}

// Adapts the format to the kind of the fallback, as closely as that allows.
MovieFormat adapted(MovieFormat format, const MovieKind& kind) {
  format.crf.reset();
  format.fps = std::min(format.fps, kind.max_fps);
  if (!kind.settings(format.profile)) format.profile = Profile::paper;
  return format;
}

}  // namespace

MovieFile::MovieFile(const std::filesystem::path& path, const MovieOptions& options,
                     const Origin& origin, int threads, Talk talk)
    : format_(format_of(options)), talk_(talk) {
  check(path, options);
  const Makeable made = makeable(path, options.fallback);
  path_ = made.path;
  if (path_ != path) format_ = adapted(format_, movie_kind(path_));
  tell(made.note);
  format_.threads = threads;
  format_.title = path_.stem().string();
  format_.comment = comment_of(origin);
}

void MovieFile::tell(const std::string& note) const {
  if (!note.empty() && talk_ != Talk::quiet) say_note(note);
}

double MovieFile::expected_bytes(std::int64_t frames, double pixels) const {
  return static_cast<double>(frames) * pixels * movie_kind(path_).bytes_a_pixel;
}

void MovieFile::begin(const std::function<bool(const std::filesystem::path&)>& taken) {
  if (begun_) return;
  make_folder_of(path_);
  const std::optional<Rescued> rescued = rescue(path_, taken);
  hold();
  if (!rescued) return;
  tell(fmt::format(
      "an earlier run was cut off while it filmed '{}': its {} frames, {:.3g} s, are "
      "kept as '{}'",
      path_.string(), rescued->length.frames, rescued->length.seconds, rescued->file.string()));
}

void MovieFile::hold() {
  held_ = std::make_unique<PartialFile>(path_);
  if (keeps_) kept_ = std::make_shared<KeptFrames>(path_);
  begun_ = true;
}

std::string MovieFile::continue_from(std::int64_t frames, const Layout& size) {
  if (frames < 1) {
    make_folder_of(path_);
    hold();
    return "";
  }
  KeptFramesReader former(path_);
  const FrameFormat& format = former.format();
  if (format.width != size.width || format.height != size.height)
    former.refuse(fmt::format("its frames have {} x {} px, those to come {} x {}", format.width,
                              format.height, size.width, size.height));
  for (std::int64_t k = 0; k < frames; ++k)
    if (!former.next()) former.refuse(fmt::format("only {} of its {} frames are whole", k, frames));
  held_ = std::make_unique<PartialFile>(path_);
  format_.threads = format.threads;
  kept_ = std::make_shared<KeptFrames>(path_, former, frames);
  begun_ = true;
  return former.note();
}

void MovieFile::film_kept(std::int64_t frames) {
  KeptFramesReader former(path_);
  for (std::int64_t k = 0; k < frames; ++k) {
    if (!former.next()) former.refuse("somebody has changed it");
    encode(former.picture());
  }
}

void MovieFile::add(Image frame, std::string_view note) {
  if (kept_) kept_->add(frame, {frame.width, frame.height, format_.threads}, note);
  encode(std::move(frame));
}

void MovieFile::encode(Image frame) {
  if (!encoder_) {
    format_.width = frame.width;
    format_.height = frame.height;
    encoder_ = std::make_unique<Encoder>(path_, format_, std::move(held_));
  }
  encoder_->add(std::move(frame));
  seconds_ = encoder_->seconds();
}

void MovieFile::finish() {
  if (!encoder_) return;
  encoder_->finish();
  seconds_ = encoder_->seconds();
  encoder_.reset();
}

}  // namespace hackle
