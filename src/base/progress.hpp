// SPDX-License-Identifier: MIT
// Shows the progress of long work on stderr: a bar on a terminal, occasional plain lines elsewhere.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

namespace hackle {

// How much a program reports on stderr while it works.
enum class Talk { quiet, plain, animated };

// Returns the line of a bar of so many columns at most: "━━━╌ 62 %  step 9 000 of 14 000  3 s
// left". The bar is 24 columns wide, less where they are few, and the detail is cut at a blank.
std::string progress_line(double fraction, std::string_view detail, std::string_view left,
                          std::size_t columns);

class Progress {
 public:
  explicit Progress(Talk talk);
  // Clears an unfinished animated bar.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // Cheap enough to call at every step: usually it reads the clock and returns. `fraction` lies in
  // 0..1. Returns true if the text is to be shown; then call show().
  bool due(double fraction);
  // Shows the bar at `fraction`, with `detail` and the remaining time.
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
