// SPDX-License-Identifier: MIT
#include "study/envelope.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace hackle {
namespace {

// s of wall time; a light cell takes a fraction of a second, a heavy one up to two minutes.
constexpr double light_limit = 60.0, heavy_limit = 600.0;

CaseRunner runner_for(std::string_view family, const EnvelopeOptions& options, bool heavy) {
  RunnerOptions own = options.runner;
  own.folder /= family;
  own.threads_per_case = heavy ? own.threads : 1;
  return {{.program = options.program, .path = options.scripts / fmt::format("{}.lua", family)},
          own};
}

// Fills the results of one family, light or heavy.
void run_family(std::string_view family, const EnvelopeOptions& options, bool heavy,
                std::vector<CellResult>& results, Sharing& sharing) {
  std::vector<Case> cases;
  std::vector<CellResult*> of_family;
  for (CellResult& result : results)
    if (result.cell.family == family && result.cell.heavy == heavy) {
      cases.push_back({.settings = result.cell.settings});
      of_family.push_back(&result);
    }
  if (cases.empty()) return;
  CaseRunner runner = runner_for(family, options, heavy);
  const auto outcomes = runner.run(cases, std::string(family), heavy ? heavy_limit : light_limit);
  for (std::size_t k = 0; k < outcomes.size(); ++k) {
    of_family[k]->verdict = verdict_of(outcomes[k], of_family[k]->cell.demand);
    of_family[k]->seconds = outcomes[k].wall;
  }
  sharing.add(runner.sharing());
}

}  // namespace

std::vector<CellResult> run_envelope(const std::vector<EnvelopeCell>& cells,
                                     const EnvelopeOptions& options, Sharing& sharing) {
  std::vector<CellResult> results;
  results.reserve(cells.size());
  for (const EnvelopeCell& cell : cells) results.push_back({cell, {}, 0.0});
  for (const bool heavy : {false, true})
    for (const EnvelopeFamily& family : envelope_families())
      run_family(family.name, options, heavy, results, sharing);
  return results;
}

std::size_t count(const std::vector<CellResult>& results, CellEnd end) {
  return static_cast<std::size_t>(std::ranges::count_if(
      results, [end](const CellResult& one) { return one.verdict.end == end; }));
}

}  // namespace hackle
