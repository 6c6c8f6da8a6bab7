// SPDX-License-Identifier: MIT
#include "output/files/movie_output.hpp"

#include <optional>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "base/on_disk.hpp"
#include "base/stopwatch.hpp"

namespace hackle {
namespace {

constexpr std::size_t waiting_shots = 4;

// What the painter has learned goes with each kept frame.
std::string note_of(const Adaptation& adaptation) {
  const auto& [first, second] = adaptation.ranges;
  const Window& window = adaptation.window;
  return fmt::format("{} {} {} {} {} {} {} {} {} {}", first.min, first.max, first.widened_by,
                     second.min, second.max, second.widened_by, window.left, window.bottom,
                     window.nx, window.ny);
}

std::optional<Adaptation> adaptation_from(const std::string& note) {
  Adaptation adaptation;
  auto& [first, second] = adaptation.ranges;
  Window& window = adaptation.window;
  std::istringstream text(note);
  text >> first.min >> first.max >> first.widened_by >> second.min >> second.max >>
      second.widened_by >> window.left >> window.bottom >> window.nx >> window.ny;
  if (!text || window.nx < 1 || window.ny < 1) return std::nullopt;
  return adaptation;
}

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
  if (complete_) return;
  file_.begin([&](const std::filesystem::path& path) { return names_->is_claimed(path); });
}

std::int64_t MovieOutput::next_due(const Simulation& simulation) {
  return options_.picture.overlay.graph ? simulation.state().step : Output::next_due(simulation);
}

bool MovieOutput::due(const Simulation& simulation) {
  if (options_.picture.overlay.graph) growth_.count(simulation);
  return Output::due(simulation);
}

void MovieOutput::look(const Simulation& simulation) {
  add(simulation);
}

void MovieOutput::add(const View& view) {
  reserve();
  const CrackGrowth* const growth = growth_.empty() ? nullptr : &growth_;
  hand_over([this, shot = shot_of(options_.picture, view, growth)] { paint(shot); });
  ++frames_;
}

void MovieOutput::hand_over(Work work) {
  if (!painting_)
    painting_ =
        std::make_unique<Worker<Work>>(waiting_shots, [this](const Work& w) { work_on(w); });
  try {
    painting_->push(std::move(work));
  } catch (...) {
    failed_ = true;
    throw;
  }
}

void MovieOutput::work_on(const Work& work) {
  try {
    work();
  } catch (...) {
    if (file_.kept()) file_.kept()->give_up();
    throw;
  }
}

void MovieOutput::paint(const Shot& shot) {
  double seconds = 0.0;
  Image image;
  {
    const Stopwatch watch(seconds);
    if (!painter_) {
      painter_ = std::make_unique<PlatePainter>(style_);
      if (const auto adaptation = adaptation_from(note_)) painter_->adapt(*adaptation);
    }
    image = painter_->paint(shot);
  }
  render_seconds_ += seconds;
  file_.add(std::move(image), note_of(painter_->adaptation()));
}

void MovieOutput::finish() {
  painter_.reset();
  file_.finish();
}

std::vector<std::filesystem::path> MovieOutput::kept_files() const {
  return file_.keeps() ? std::vector{kept_frames_name(path())}
                       : std::vector<std::filesystem::path>{};
}

std::function<void()> MovieOutput::settled() {
  if (complete_) return [path = path()] { bring_file_to_disk(path); };
  return [kept = file_.kept(), frames = frames_] {
    if (kept) kept->wait_for(frames);
  };
}

void MovieOutput::continue_from(const OutputMark& mark) {
  schedule().go_on(mark.start, mark.next);
  frames_ = mark.pieces;
  complete_ = mark.complete;
  if (complete_) return;
  note_ = file_.continue_from(frames_, layout_of(style_));
  if (frames_ > 0) hand_over([this, frames = frames_] { file_.film_kept(frames); });
}

Expected MovieOutput::expected(double until, std::int64_t max_looks) const {
  const std::int64_t frames = schedule().moments(until, max_looks);
  const Layout layout = layout_of(style_);
  const double pixels = static_cast<double>(layout.width) * layout.height;
  return {file_.path(), frames, file_.expected_bytes(frames, pixels)};
}

void MovieOutput::close() {
  if (failed_ || complete_ || !painting_) return;
  hand_over([this] { finish(); });
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
