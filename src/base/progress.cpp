// SPDX-License-Identifier: MIT
#include "base/progress.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>

#include "base/streams.hpp"

namespace hackle {
namespace {

constexpr double first_shown_after = 0.5;     // seconds; shorter work needs no bar
constexpr double redraw_every = 0.1;          // seconds, on a terminal
constexpr double plain_line_after = 1.0;      // seconds before the first plain line
constexpr double plain_line_at_least = 30.0;  // largest interval between plain lines, s
constexpr int bar_width = 24;

std::string remaining_text(double seconds) {
  if (seconds < 100.0) return fmt::format("{:.0f} s left", seconds);
  if (seconds < 6000.0) return fmt::format("{:.0f} min left", seconds / 60.0);
  return fmt::format("{:.1f} h left", seconds / 3600.0);
}

std::string bar(double fraction) {
  const int full = static_cast<int>(std::lround(fraction * bar_width));
  std::string text;
  for (int i = 0; i < bar_width; ++i) text += i < full ? "━" : "╌";
  return text;
}

}  // namespace

Progress::Progress(Talk talk) : talk_(talk), start_(Clock::now()), last_(start_) {
}

Progress::~Progress() {
  if (bar_is_drawn_) say("\r\033[K");
}

double Progress::elapsed() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

bool Progress::due(double fraction) {
  if (fraction_at_start_ < 0.0) fraction_at_start_ = fraction;
  if (talk_ == Talk::quiet) return false;
  const double since_last = std::chrono::duration<double>(Clock::now() - last_).count();
  if (talk_ == Talk::animated) return since_last >= redraw_every && elapsed() >= first_shown_after;
  const bool next_tenth = static_cast<int>(fraction * 10.0) > tenths_shown_;
  return elapsed() >= plain_line_after && (next_tenth || since_last >= plain_line_at_least);
}

void Progress::show(double fraction, const std::string& detail) {
  last_ = Clock::now();
  tenths_shown_ = static_cast<int>(fraction * 10.0);
  const double done = std::max(fraction - fraction_at_start_, 1e-9);
  const std::string left = remaining_text(elapsed() * (1.0 - fraction) / done);
  const int percent = static_cast<int>(fraction * 100.0);
  if (talk_ == Talk::animated) {
    say("\r\033[K{} {:3d} %  {}  {}", bar(fraction), percent, detail, left);
    flush(stderr);
    bar_is_drawn_ = true;
  } else {
    say("{:3d} %  {}  {}\n", percent, detail, left);
  }
}

}  // namespace hackle
