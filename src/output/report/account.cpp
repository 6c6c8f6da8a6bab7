// SPDX-License-Identifier: MIT
#include "output/report/account.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "base/units.hpp"
#include "measure/bond_field.hpp"
#include "measure/fragment_list.hpp"
#include "output/report/ledger_remark.hpp"
#include "output/report/ligament_remark.hpp"

namespace hackle {
namespace {

// Of what a table of events tells at once.
constexpr std::size_t max_told = 10;
// Of c_R: a tip that is slower is not said to run.
constexpr double least_speed = 0.01;

class Teller {
 public:
  Teller(const Simulation& simulation, const Summary& summary, const CrackGrowth& growth,
         const CrackGraph& graph)
      : simulation_(simulation),
        summary_(summary),
        growth_(growth),
        graph_(graph),
        unit_(prefixed(0.2 * std::max(simulation.plate().width, simulation.plate().height), "m")) {}

  std::vector<std::string> sentences() {
    if (summary_.damage.broken_bonds == 0) {
      tell_why_nothing_broke();
    } else {
      tell_first_break();
      tell_events();
      tell_tips();
      tell_fragments();
    }
    tell_trust();
    return std::move(told_);
  }

 private:
  // To a hundredth of the unit.
  std::string at(const Vec2& place) const {
    const auto shown = [&](double value) {
      return shortest(std::round(100.0 * value / unit_.factor) / 100.0 + 0.0);
    };
    return fmt::format("({}, {}) {}", shown(place.x()), shown(place.y()), unit_.name);
  }
  std::string when(const std::optional<double>& time) const {
    return time ? fmt::format("at {}", quantity(*time, "s"))
                : fmt::format("before {}", quantity(growth_.since(), "s"));
  }
  std::string speed_text(double speed) const {
    return fmt::format("{} m/s ({:.2f} c_R)", grouped(std::lround(speed)), speed / graph_.rayleigh);
  }

  void tell_why_nothing_broke() {
    const std::vector<double> shares = closest_to_breaking(simulation_.view());
    const auto most = std::ranges::max_element(shares);
    if (most == shares.end() || !(*most > 0.0)) {
      told_.emplace_back("No bond broke: nothing is stretched.");
      return;
    }
    const Grid& grid = simulation_.lattice().grid;
    const auto node = static_cast<int>(most - shares.begin());
    told_.push_back(
        fmt::format("No bond broke: at {} the closest has {:.0f} % of its critical stretch, at {}.",
                    quantity(summary_.time, "s"), 100.0 * *most,
                    at(grid.position(node % grid.nx, node / grid.nx))));
  }

  void tell_first_break() {
    if (const auto first = growth_.first_break())
      told_.push_back(fmt::format("The first bond broke at {}, at {}.", quantity(first->time, "s"),
                                  at(first->place)));
    else
      told_.push_back(
          fmt::format("The first bond broke before {}.", quantity(growth_.since(), "s")));
  }

  // One event, as a sentence.
  std::string sentence_of(const CrackEvent& event) const {
    const std::string moment = when(event.time), place = at(event.place);
    switch (event.kind) {
      case CrackEventKind::nucleation:
        return fmt::format("A crack began {} {}.", place_of_birth(event), moment);
      case CrackEventKind::branch:
        return fmt::format("{} forked {} at {}{}{}.", name_of_crack(event.crack), moment, place,
                           event.angle ? fmt::format(", by {:.0f} degrees",
                                                     *event.angle * 180.0 / std::numbers::pi)
                                       : "",
                           fastest_text(event.crack));
      case CrackEventKind::coalescence:
        return fmt::format("Two cracks met {} at {}.", moment, place);
      case CrackEventKind::arrest:
        return fmt::format("A tip has stood still at {} since {}.", place,
                           event.time ? quantity(*event.time, "s") : "the start");
      case CrackEventKind::arrival:
        return fmt::format("{} came to {} {} at {}{}.", name_of_crack(event.crack),
                           event.site == CrackSite::hole ? "a hole" : "the edge", moment, place,
                           fastest_text(event.crack));
    }
    return "";
  }

  static std::string place_name(CrackSite site) {
    if (site == CrackSite::hole) return "at a hole, ";
    return site == CrackSite::edge ? "at the edge, " : "";
  }
  std::string place_of_birth(const CrackEvent& event) const {
    return fmt::format("{}at {}", place_name(event.site), at(event.place));
  }

  // Where there is one crack, it needs no number.
  std::string name_of_crack(int crack) const {
    const CrackPiece& piece = graph_.cracks[static_cast<std::size_t>(crack)];
    const bool branch =
        piece.parent >= 0 && !graph_.cracks[static_cast<std::size_t>(piece.parent)].initial;
    return branch ? "A branch" : "The crack";
  }
  std::string fastest_text(int crack) const {
    const auto& speed = graph_.cracks[static_cast<std::size_t>(crack)].max_speed;
    return speed ? fmt::format("; it had run at up to {}", speed_text(*speed)) : "";
  }

  void tell_events() {
    if (graph_.events.size() <= max_told) {
      for (const CrackEvent& event : graph_.events) told_.push_back(sentence_of(event));
      return;
    }
    constexpr std::array counted{std::pair{CrackEventKind::nucleation, "cracks began"},
                                 std::pair{CrackEventKind::branch, "forks"},
                                 std::pair{CrackEventKind::coalescence, "times cracks met"},
                                 std::pair{CrackEventKind::arrest, "tips came to stand still"},
                                 std::pair{CrackEventKind::arrival, "arrivals at edges and holes"}};
    for (const auto& [kind, words] : counted) tell_count(kind, words);
  }

  void tell_count(CrackEventKind kind, const char* words) {
    const auto count = std::ranges::count(graph_.events, kind, &CrackEvent::kind);
    if (count == 0) return;
    const auto first = std::ranges::find(graph_.events, kind, &CrackEvent::kind);
    told_.push_back(count == 1 ? sentence_of(*first)
                               : fmt::format("{} {}, the first {} at {}.", count, words,
                                             when(first->time), at(first->place)));
  }

  void tell_tips() {
    std::string places;
    std::size_t running = 0;
    double fastest = 0.0;
    for (const CrackTip& tip : graph_.tips) {
      const bool runs = tip.state == TipState::running && tip.speed > least_speed * graph_.rayleigh;
      if (!runs) continue;
      fastest = std::max(fastest, tip.speed);
      if (++running <= max_told)
        places += fmt::format("{}{}", places.empty() ? "" : ", ", at(tip.place));
    }
    if (running == 0) return;
    told_.push_back(fmt::format("At {} {} {} on, at {}{}, at up to {}.",
                                quantity(summary_.time, "s"), running,
                                running == 1 ? "tip runs" : "tips run", places,
                                running > max_told ? ", ..." : "", speed_text(fastest)));
  }

  void tell_fragments() {
    const FragmentList fragments = measured_fragments(simulation_.view());
    if (fragments.all.size() < 2) return;
    double area = 0.0;
    for (const MeasuredFragment& one : fragments.all) area += one.area;
    told_.push_back(fmt::format("The plate is in {} pieces, the largest with {:.3g} % of it.",
                                grouped(static_cast<long long>(fragments.all.size())),
                                100.0 * fragments.all.front().area / area));
  }

  // tests/README.md, "How far a fork can be trusted", has the measurement.
  void tell_trust() {
    const double horizon = simulation_.numerics().horizon_or_default();
    std::string text =
        fmt::format("The ledger of energy closes to {:.2g} %; the horizon is {}, ",
                    100.0 * std::abs(residual_share(summary_.energy)), quantity(horizon, "m"));
    const double horizons = narrowest(simulation_.plate()) / horizon;
    text += fmt::format("the narrowest part has {:.3g} of them.", horizons);
    told_.push_back(std::move(text));
    const bool forked = std::ranges::find(graph_.events, CrackEventKind::branch,
                                          &CrackEvent::kind) != graph_.events.end();
    if (forked)
      told_.push_back(fmt::format(
          "How far to trust it: on the paper's first plate another horizon or lattice moved the "
          "fork by up to {:.2g} horizons, here {}, and the tips by one.",
          spread_of_fork, quantity(spread_of_fork * horizon, "m")));
  }

  static constexpr double spread_of_fork = 3.0;

  const Simulation& simulation_;
  const Summary& summary_;
  const CrackGrowth& growth_;
  const CrackGraph& graph_;
  const PrefixedUnit unit_;
  std::vector<std::string> told_;
};

}  // namespace

std::vector<std::string> account_of(const Simulation& simulation, const Summary& summary,
                                    const CrackGrowth& growth, const CrackGraph& graph) {
  return Teller(simulation, summary, growth, graph).sentences();
}

}  // namespace hackle
