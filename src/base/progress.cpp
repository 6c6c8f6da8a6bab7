// SPDX-License-Identifier: MIT
#include "base/progress.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

#include "base/streams.hpp"
#include "base/terminal.hpp"

namespace hackle {
namespace {

constexpr double first_shown_after = 0.5;     // seconds; shorter work needs no bar
constexpr double redraw_every = 0.1;          // seconds, on a terminal
constexpr double plain_line_after = 1.0;      // seconds before the first plain line
constexpr double plain_line_at_least = 30.0;  // largest interval between plain lines, s
constexpr std::size_t bar_width = 24;

std::string remaining_text(double seconds) {
  if (seconds < 100.0) return fmt::format("{:.0f} s left", seconds);
  if (seconds < 6000.0) return fmt::format("{:.0f} min left", seconds / 60.0);
  return fmt::format("{:.1f} h left", seconds / 3600.0);
}

std::string bar(double fraction, std::size_t width) {
  const auto full = static_cast<std::size_t>(std::lround(fraction * static_cast<double>(width)));
  std::string text;
  for (std::size_t i = 0; i < width; ++i) text += i < full ? "━" : "╌";
  return text;
}

// Returns the beginning of the text that fits, up to a blank.
std::string_view beginning(std::string_view text, std::size_t width) {
  if (text.size() <= width) return text;
  const std::size_t blank = text.rfind(' ', width);
  text = text.substr(0, blank == std::string_view::npos ? 0 : blank);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

}  // namespace

std::string progress_line(double fraction, std::string_view detail, std::string_view left,
                          std::size_t columns) {
  constexpr std::size_t smallest_bar = 4;
  const std::string percent = fmt::format("{:3d} %", static_cast<int>(fraction * 100.0));
  const std::size_t texts = percent.size() + left.size() + 4;  // with blanks around detail and bar
  const std::size_t room = columns - std::min(columns, texts + smallest_bar + 1);
  const std::string_view shown = beginning(detail, room);
  const std::size_t width = smallest_bar + std::min(bar_width - smallest_bar, room - shown.size());
  return fmt::format("{} {}  {}  {}", bar(fraction, width), percent, shown, left);
}

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
  const std::string left =
      fraction > 0.0 ? remaining_text(elapsed() * (1.0 - fraction) / done) : std::string();
  if (talk_ == Talk::animated) {
    const std::size_t columns = terminal_columns(STDERR_FILENO) - 1;  // the last one may wrap
    say("\r\033[K{}", progress_line(fraction, detail, left, columns));
    flush(stderr);
    bar_is_drawn_ = true;
  } else {
    say("{:3d} %  {}  {}\n", static_cast<int>(fraction * 100.0), detail, left);
  }
}

}  // namespace hackle
