// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/study_kinds.hpp"
#include "app/voice.hpp"
#include "study/study_files.hpp"
#include "study/trade.hpp"
#include "study/trade_report.hpp"
#include "study/trade_sheet.hpp"

namespace hackle {
namespace {

struct TradeRequest {
  StudyWords words;
  std::vector<std::string> quantities;
  bool sheet = false;
  TradeOptions options;
};

void describe_trade(CLI::App& kind, TradeRequest& request) {
  describe_study_words(kind, request.words);
  describe_set(kind, request.words);
  describe_quantities(kind, request.quantities);
  kind.add_flag("--sheet", request.sheet,
                "Make a sheet of the last states of what is recommended and of the reference");
  kind.add_option("--screen-above", request.options.costly,
                  fmt::format("CPU time in s of the script, above which ways are screened on a "
                              "coarser lattice first ({})",
                              TradeOptions{}.costly))
      ->type_name("S")
      ->check(CLI::NonNegativeNumber);
  kind.add_flag("!--no-pictures", request.options.pictures,
                "Do not try cadences and sizes of its movies");
  kind.footer(
      "Each run is compared with a reference that is finer in every respect. The error is the "
      "root\n"
      "mean square of all errors, each as a share of what counts as one: a horizon, 1 % of the "
      "time\n"
      "or of the displacements, 5 degrees, 5 % of a speed or an energy.");
}

void carry_out(const TradeRequest& request, const std::vector<std::string>& arguments) {
  CaseRunner runner = runner_of(request.words, arguments);
  const Trade found = trade(runner, quantities_named(request.quantities), request.options);
  finish({"trade", text_of(found), table_of(found), {chart_of(found)}}, to_json(found),
         request.words, runner, [&] {
           if (!request.sheet) return;
           const auto sheet = runner.options().folder / "trade-sheet.png";
           write_sheet(runner, found, sheet);
           if (!request.words.quiet && !request.words.json) tell_file(sheet);
         });
}

}  // namespace

void describe_study_trade(CLI::App& study, StudyAction& action) {
  describe_kind<TradeRequest>(study, action, "trade",
                              "What a scene loses when it is solved faster, and what more costs",
                              describe_trade, carry_out);
}

}  // namespace hackle
