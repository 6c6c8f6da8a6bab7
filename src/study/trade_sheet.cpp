// SPDX-License-Identifier: MIT
#include "study/trade_sheet.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "render/contact_sheet.hpp"
#include "render/png.hpp"

namespace hackle {
namespace {

// From the cheapest to the reference, each once.
std::vector<const TradeRun*> shown(const Trade& trade) {
  std::vector<const TradeRun*> runs{&trade.runs.front()};
  for (const Recommendation& one : trade.recommended) runs.push_back(&trade.runs[one.run]);
  std::ranges::sort(runs, {}, [](const TradeRun* run) { return run->outcome.cpu; });
  runs.erase(std::unique(runs.begin(), runs.end()), runs.end());
  runs.push_back(&trade.reference);
  return runs;
}

std::string title_of(const TradeRun& run, const Trade& trade) {
  const std::string name = &run == &trade.reference ? "reference" : name_of(run.settings);
  return fmt::format("{:.2f} s, error {:.2f}: {}", run.outcome.cpu, run.error, name);
}

}  // namespace

void write_sheet(CaseRunner& runner, const Trade& trade, const std::filesystem::path& path) {
  const std::vector<const TradeRun*> runs = shown(trade);
  std::vector<Case> cases;
  for (const TradeRun* run : runs) {
    cases.push_back(run->outcome.setting);
    cases.back().repeat = 0;
    cases.back().with_last_picture = true;
  }
  const std::vector<Outcome> outcomes = runner.run(cases, "pictures");
  std::vector<SheetPicture> pictures;
  for (std::size_t k = 0; k < runs.size(); ++k)
    if (outcomes[k].finished())
      pictures.push_back({runner.picture_of(cases[k]), title_of(*runs[k], trade)});
  if (pictures.empty()) throw Error(ErrorKind::run_failed, "no run has left a picture");
  make_folder_of(path);
  write_png(contact_sheet(pictures, {.columns = 2, .width = 640, .font = 0.025}), path);
}

}  // namespace hackle
