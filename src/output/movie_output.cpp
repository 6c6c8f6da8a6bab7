// SPDX-License-Identifier: MIT
#include "output/movie_output.hpp"

#include <utility>

#include "base/files.hpp"
#include "base/stopwatch.hpp"
#include "render/layout.hpp"

namespace hackle {
namespace {

constexpr std::size_t waiting_shots = 4;
// Of each frame. The ready scenes take 0.0006, most of them, to 0.0054, a plate that shatters.
constexpr double bytes_a_pixel = 0.006;

}  // namespace

MovieOutput::MovieOutput(std::filesystem::path path, const MovieOptions& options,
                         const Simulation& simulation)
    : path_(std::move(path)),
      options_(options),
      style_(style_of(options.picture, simulation)),
      schedule_("movie", options.every, simulation),
      encoder_threads_(simulation.threads()) {
  style_.slow_motion = 1.0 / (options.every * options.fps);
}

void MovieOutput::observe(const Simulation& simulation) {
  if (!painting_)
    painting_ = std::make_unique<Worker<Work>>(waiting_shots, [this](const Work& w) { paint(w); });
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
    MovieFormat format{image.width, image.height};
    format.fps = options_.fps;
    format.threads = encoder_threads_;
    format.title = path_.stem().string();
    encoder_ = std::make_unique<Encoder>(path_, format);
  }
  encoder_->add(std::move(image));
  encode_seconds_ = encoder_->seconds();
}

Expected MovieOutput::expected(double until, std::int64_t most_looks) const {
  const std::int64_t frames = schedule_.moments(until, most_looks);
  const Layout layout = layout_of(style_);
  const double pixels = static_cast<double>(layout.width) * layout.height;
  return {path_, frames, static_cast<double>(frames) * pixels * bytes_a_pixel};
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
