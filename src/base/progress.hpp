// SPDX-License-Identifier: MIT
// The progress of long work on stderr: a bar on a terminal, a plain line now and then elsewhere.
#pragma once

#include <chrono>
#include <string>

namespace hackle {

// How much a program says on stderr while it works.
enum class Talk { quiet, plain, animated };

class Progress {
 public:
  explicit Progress(Talk talk);
  // Clears an animated bar that was not finished.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // Cheap enough to be called at every step: reads the clock and mostly returns.
  // `fraction` lies in 0..1. True when the text would be shown now; then call show().
  bool due(double fraction);
  // Shows the bar at `fraction`, `detail` and the remaining time.
  void show(double fraction, const std::string& detail);

 private:
  using Clock = std::chrono::steady_clock;
  double elapsed() const;

  Talk talk_;
  Clock::time_point start_, last_;
  int tenths_shown_ = 0;
  double fraction_at_start_ = -1.0;
  bool bar_is_drawn_ = false;
};

}  // namespace hackle
