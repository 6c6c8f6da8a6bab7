// SPDX-License-Identifier: MIT
#include "output/files/checkpoint_keeper.hpp"

#include <exception>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/terminal.hpp"
#include "base/units.hpp"
#include "store/checkpoint.hpp"

namespace hackle {

CheckpointKeeper::CheckpointKeeper(double seconds, CheckpointHost host, Origin origin, Talk talk)
    : interval_(
          std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds))),
      host_(std::move(host)),
      origin_(std::move(origin)),
      talk_(talk) {
}

CheckpointKeeper::~CheckpointKeeper() {
  wait();
}

std::int64_t CheckpointKeeper::next_due(const Simulation& simulation) {
  constexpr std::int64_t steps_between_looks = 8;  // at the clock
  return simulation.state().step + steps_between_looks;
}

bool CheckpointKeeper::due(const Simulation&) {
  return !hopeless_ && Clock::now() - last_ >= interval_ && !is_writing();
}

bool CheckpointKeeper::is_writing() const {
  using std::chrono::seconds;
  return writing_.valid() && writing_.wait_for(seconds(0)) != std::future_status::ready;
}

// The run matters more than its checkpoints, also where memory or threads are lacking.
template <class Work>
void CheckpointKeeper::attempt(const Work& work) {
  try {
    work();
  } catch (const std::exception& error) {
    hopeless_ = true;
    if (talk_ != Talk::quiet) say_note(fmt::format("no checkpoints are kept: {}", error.what()));
  }
}

void CheckpointKeeper::observe(const Simulation& simulation) {
  attempt([&] { keep(simulation); });
}

void CheckpointKeeper::keep(const Simulation& simulation) {
  collect();
  if (!path_) path_ = host_.place();
  CheckpointImage image =
      image_of(simulation, origin_, host_.continuation ? host_.continuation() : std::string());
  auto settled = host_.settled ? host_.settled() : [] {};
  writing_ = std::async(std::launch::async,
                        [path = *path_, image = std::move(image), settled = std::move(settled)] {
                          settled();
                          write_checkpoint(path, image);
                        });
  last_ = Clock::now();
}

void CheckpointKeeper::collect() {
  if (writing_.valid()) writing_.get();
}

void CheckpointKeeper::keep_last(const Simulation& simulation) {
  if (hopeless_ || simulation.state().step == 0) return;
  try {
    simulation.check_finite();
  } catch (const Error&) {
    return;
  }
  attempt([&] {
    keep(simulation);
    collect();
    if (talk_ != Talk::quiet)
      say_note(
          fmt::format("the state at {} is kept in '{}': the same command, or hackle resume, "
                      "goes on from it",
                      quantity(simulation.time(), "s"), path_->string()));
  });
}

}  // namespace hackle
