// SPDX-License-Identifier: MIT
#include "console/language/live_view.hpp"

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

#include "base/streams.hpp"
#include "console/language/picture_text.hpp"

namespace hackle {

LiveView::LiveView(Session& session, const PictureOptions& options, double every,
                   const Simulation& simulation)
    : ScheduledObserver(Schedule("watch", every, simulation)),
      session_(session),
      options_(options) {
}

// Draws over the last picture unless something was printed since.
void LiveView::look(const Simulation& simulation) {
  Terminal terminal = terminal_of(STDOUT_FILENO);
  terminal.graphics = Graphics::symbols;  // their lines can be counted
  std::string text = picture_text(simulation, options_, terminal);
  const long lines = std::ranges::count(text, '\n');
  if (session_.make_room) session_.make_room();
  if (said_ == session_.said) text.insert(0, fmt::format("\r\033[{}A", lines_));
  if (session_.settings.talk == Talk::animated) text.insert(0, "\r\033[K");
  flush(stdout);
  write_picture(text, terminal, STDOUT_FILENO);
  lines_ = lines;
  said_ = session_.said;
}

}  // namespace hackle
