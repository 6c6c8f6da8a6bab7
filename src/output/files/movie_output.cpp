// SPDX-License-Identifier: MIT
#include "output/files/movie_output.hpp"

#include <utility>

#include "base/stopwatch.hpp"

namespace hackle {
namespace {

constexpr std::size_t waiting_shots = 4;

}  // namespace

MovieOutput::MovieOutput(const std::filesystem::path& path, const MovieOptions& options,
                         const View& view, const Origin& origin, int threads, Talk talk,
                         std::shared_ptr<const OutputNames> names)
    : Output(Schedule("movie", options.every, view)),
      options_(options),
      style_(style_of(options.picture, view)),
      file_(path, options, origin, threads, talk),
      names_(std::move(names)) {
  style_.slow_motion = slow_motion_of(options);
}

void MovieOutput::reserve() {
  file_.begin([&](const std::filesystem::path& path) { return names_->is_claimed(path); });
}

void MovieOutput::look(const Simulation& simulation) {
  add(simulation);
}

void MovieOutput::add(const View& view) {
  if (!painting_) {
    reserve();
    painting_ = std::make_unique<Worker<Work>>(waiting_shots, [this](const Work& w) { paint(w); });
  }
  hand_over(shot_of(options_.picture, view));
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
  if (!work) {
    painter_.reset();
    return file_.finish();
  }
  double seconds = 0.0;
  Image image;
  {
    const Stopwatch watch(seconds);
    if (!painter_) painter_ = std::make_unique<PlatePainter>(style_);
    image = painter_->paint(*work);
  }
  render_seconds_ += seconds;
  file_.add(std::move(image));
}

Expected MovieOutput::expected(double until, std::int64_t max_looks) const {
  const std::int64_t frames = schedule().moments(until, max_looks);
  const Layout layout = layout_of(style_);
  const double pixels = static_cast<double>(layout.width) * layout.height;
  return {file_.path(), frames, file_.expected_bytes(frames, pixels)};
}

void MovieOutput::close() {
  if (failed_ || complete_ || !painting_) return;
  hand_over(std::nullopt);
  failed_ = true;  // unless the next line succeeds
  painting_->finish();
  failed_ = false;
  complete_ = true;
}

std::vector<std::filesystem::path> MovieOutput::files() const {
  return complete_ ? std::vector{file_.path()} : std::vector<std::filesystem::path>{};
}

void MovieOutput::add_seconds(StageSeconds& wall) const {
  wall.render += render_seconds_;
  wall.encode += file_.seconds();
}

}  // namespace hackle
