// SPDX-License-Identifier: MIT
#include "output/report/notes.hpp"

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "base/streams.hpp"
#include "base/terminal.hpp"
#include "measure/energy.hpp"
#include "output/report/ledger_remark.hpp"
#include "output/report/load_remarks.hpp"
#include "output/report/report.hpp"

namespace hackle {
namespace {

std::array<double, 3> situation_of(const Simulation& simulation) {
  const State& state = simulation.state();
  return {static_cast<double>(state.step), simulation.time(), state.external_work};
}

}  // namespace

void Notes::say(const std::vector<std::string>& remarks) {
  for (const std::string& remark : remarks) {
    if (std::ranges::find(all_, remark) != all_.end()) continue;
    all_.push_back(remark);
    if (talk_ != Talk::quiet) say_note(remark);
  }
}

void Notes::add(const std::string& remark) {
  if (!remark.empty()) say({remark});
}

void Notes::say_at_once(const std::vector<std::string>& remarks) {
  at_once_ = at_once_ || !remarks.empty();
  say(remarks);
}

void Notes::begin(const Simulation& simulation) {
  say(remarks(simulation));
  say_at_once(shock_remarks(simulation, {}));
}

void Notes::exchange_loads(const Simulation& simulation, const std::vector<double>& before) {
  say_at_once(shock_remarks(simulation, before));
  fresh_loads_ = true;
}

void Notes::look_at_loads(const Simulation& simulation) {
  const double end = simulation.end_time();
  try {
    say(load_remarks(simulation, end));
    say_at_once(at_once_remarks(simulation, end, std::exchange(fresh_loads_, false)));
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::interrupted) throw;  // others are good at the steps: enough
  }
}

void Notes::judge(const Simulation& simulation) {
  const Situation now = situation_of(simulation);
  if (std::exchange(judged_, now) == now) return;
  if (const auto remark = ledger_remark(simulation, energy(simulation), at_once_)) say({*remark});
}

void Notes::begin_judging_at(const Simulation& simulation) {
  judged_ = situation_of(simulation);
}

}  // namespace hackle
