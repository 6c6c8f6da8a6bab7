// SPDX-License-Identifier: MIT
#include "output/movie_output.hpp"

#include <algorithm>
#include <cstdio>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "base/files.hpp"
#include "base/hash.hpp"
#include "base/stopwatch.hpp"
#include "base/version.hpp"
#include "movie/rescue.hpp"
#include "render/layout.hpp"

namespace hackle {
namespace {

constexpr std::size_t waiting_shots = 4;
constexpr double least_fps = 1.0, most_fps = 240.0;

// Which script made it, so that a movie that lies about can be made again.
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
  if (!(options.fps >= least_fps && options.fps <= most_fps))
    problems.add(fmt::format("movie: fps is {}, it must lie between {} and {}", options.fps,
                             least_fps, most_fps));
  else
    check_settings(path, format_of(options), problems);
  problems.throw_if_any();
}

// What the kind it falls back to cannot be, it is as well as that can.
MovieFormat adapted(MovieFormat format, const MovieKind& kind) {
  format.crf.reset();
  format.fps = std::min(format.fps, kind.most_fps);
  if (!kind.settings(format.profile)) format.profile = Profile::paper;
  return format;
}

}  // namespace

MovieOutput::MovieOutput(const std::filesystem::path& path, const MovieOptions& options,
                         const Simulation& simulation, const Origin& origin, Talk talk)
    : options_(options),
      style_(style_of(options.picture, simulation)),
      schedule_("movie", options.every, simulation),
      format_(format_of(options)),
      talk_(talk) {
  style_.slow_motion = 1.0 / (options.every * options.fps);
  check(path, options);
  const Makeable made = makeable(path, options.fallback);
  path_ = made.path;
  if (path_ != path) format_ = adapted(format_, movie_kind(path_));
  tell(made.note);
  format_.threads = simulation.threads();
  format_.title = path_.stem().string();
  format_.comment = comment_of(origin);
}

void MovieOutput::tell(const std::string& note) const {
  if (!note.empty() && talk_ != Talk::quiet) fmt::print(stderr, "note: {}\n", note);
}

// An earlier run was killed while it filmed: the movie of this one would be written over its own.
void MovieOutput::keep_what_was_cut_off() const {
  const std::optional<Rescued> rescued = rescue(path_);
  if (!rescued) return;
  tell(fmt::format(
      "an earlier run was cut off while it filmed '{}': its {} frames, {:.3g} s, are "
      "kept as '{}'",
      path_.string(), rescued->length.frames, rescued->length.seconds, rescued->file.string()));
}

void MovieOutput::observe(const Simulation& simulation) {
  if (!painting_) {
    keep_what_was_cut_off();
    painting_ = std::make_unique<Worker<Work>>(waiting_shots, [this](const Work& w) { paint(w); });
  }
  schedule_.advance();
  hand_over(shot_of(options_.picture, simulation));
}

void MovieOutput::hand_over(Work work) {
  try {
    painting_->push(std::move(work));
  } catch (...) {
    failed_ = true;
    throw;
  }
}

void MovieOutput::paint(const Work& work) {
  double seconds = 0.0;
  if (!work) {
    painter_.reset();
    encoder_->finish();
    encode_seconds_ = encoder_->seconds();
    return;
  }
  Image image;
  {
    const Stopwatch watch(seconds);
    if (!painter_) painter_ = std::make_unique<PlatePainter>(style_);
    image = painter_->paint(*work);
  }
  render_seconds_ += seconds;
  if (!encoder_) {
    make_folder_of(path_);
    format_.width = image.width;
    format_.height = image.height;
    encoder_ = std::make_unique<Encoder>(path_, format_);
  }
  encoder_->add(std::move(image));
  encode_seconds_ = encoder_->seconds();
}

Expected MovieOutput::expected(double until, std::int64_t most_looks) const {
  const std::int64_t frames = schedule_.moments(until, most_looks);
  const Layout layout = layout_of(style_);
  const double pixels = static_cast<double>(layout.width) * layout.height;
  return {path_, frames, static_cast<double>(frames) * pixels * movie_kind(path_).bytes_a_pixel};
}

void MovieOutput::close() {
  if (failed_ || complete_ || !painting_) return;
  hand_over(std::nullopt);
  failed_ = true;  // unless the next line returns
  painting_->finish();
  failed_ = false;
  complete_ = true;
}

std::vector<std::filesystem::path> MovieOutput::files() const {
  return complete_ ? std::vector{path_} : std::vector<std::filesystem::path>{};
}

void MovieOutput::add_seconds(StageSeconds& wall) const {
  wall.render += render_seconds_;
  wall.encode += encode_seconds_;
}

}  // namespace hackle
