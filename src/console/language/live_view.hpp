// SPDX-License-Identifier: MIT
// Shows the picture of a run in the terminal, redrawn in the same place.
#pragma once

#include <optional>

#include "base/described.hpp"
#include "console/session.hpp"
#include "output/files/schedule.hpp"
#include "output/picture/picture.hpp"

namespace hackle {

struct WatchOptions {
  std::optional<double> every;  // simulated seconds from picture to picture
};

template <>
inline constexpr auto description_of<WatchOptions> = describe_noun(
    "watch", "watch",
    member("every", &WatchOptions::every,
           {.unit = "s",
            .range = above(0.0),
            .alternative = true,
            .sentence = "Simulated time between pictures; without it drawing stops."}));

class LiveView : public ScheduledObserver {
 public:
  // Draws every `every` simulated seconds, including the present. Throws what Schedule throws.
  LiveView(Session& session, const PictureOptions& options, double every,
           const Simulation& simulation);

  bool due(const Simulation& simulation) override {
    return !ended_ && ScheduledObserver::due(simulation);
  }
  void end() { ended_ = true; }

 private:
  void look(const Simulation& simulation) override;

  Session& session_;
  PictureOptions options_;
  bool ended_ = false;
  long lines_ = 0;  // of the picture above the cursor
  std::int64_t said_ = -1;
};

}  // namespace hackle
