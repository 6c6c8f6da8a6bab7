// SPDX-License-Identifier: MIT
#include "console/language/study_binding.hpp"

#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "console/lua/json_value.hpp"
#include "console/schema/arguments.hpp"
#include "console/schema/result_table.hpp"
#include "console/session.hpp"
#include "study/convergence_files.hpp"
#include "study/ensemble_report.hpp"
#include "study/study_files.hpp"
#include "study/sweep_files.hpp"
#include "study/sweep_report.hpp"
#include "study/trade.hpp"
#include "study/trade_report.hpp"

namespace hackle {
namespace {

constexpr std::array script_options{
    Option{.name = "script",
           .type = OptionType::text,
           .required = true,
           .positional = true,
           .sentence = "The script that is run many times, each time by a program of its own."},
    Option{.name = "set",
           .type = OptionType::texts,
           .range = at_least(1.0),
           .fallback = "none",
           .sentence = "Values for all runs as on the command line: \"load=24MPa\", "
                       "\"simulate.spacing=1mm\", \"material.G0=100\"."},
    Option{.name = "output",
           .type = OptionType::text,
           .fallback = "study/<name of the script>",
           .sentence =
               "Folder in the output folder for tables, charts and what was run, from which "
               "a later study goes on."}};

constexpr std::array compare_option{
    Option{.name = "compare",
           .type = OptionType::texts,
           .range = at_least(1.0),
           .fallback = "all",
           .sentence = "What is compared, as in --for: \"fork.time\", \"tip.path\", ..."}};

constexpr auto trade_options = joined(script_options, compare_option);
constexpr FunctionDoc trade_doc{
    .name = "study.trade",
    .sentence =
        "Measures what a script loses when it is solved faster, and what it costs to be "
        "surer; writes trade.csv, trade.json and trade.png, and returns their numbers.",
    .options = trade_options,
    .example =
        "t = study.trade { \"plate.lua\", compare = { \"tip.path\" } }\n"
        "for _, one in ipairs(t.recommended) do print(one.budget) end"};

constexpr std::array runs_option{
    Option{.name = "runs",
           .type = OptionType::integer,
           .range = between(2.0, 10000.0),
           .fallback = "32",
           .sentence = "How many runs, each with other last bits of E."}};
constexpr auto ensemble_options = joined(script_options, runs_option);
constexpr FunctionDoc ensemble_doc{
    .name = "study.ensemble",
    .sentence =
        "Runs a script with changed last digits: until when the paths of cracks agree, and "
        "statistics after that; writes ensemble.csv, .json and .png, and returns them.",
    .options = ensemble_options,
    .example = "e = study.ensemble { \"plate.lua\", runs = 8 }\nprint(e.agree_until_s)"};

constexpr auto convergence_options = joined(script_options, compare_option);
constexpr FunctionDoc convergence_doc{
    .name = "study.convergence",
    .sentence =
        "Refines horizon, spacing and step of a script, and says what converges, with "
        "observed order and limit; writes convergence.csv, .json and charts.",
    .options = convergence_options,
    .example =
        "c = study.convergence { \"plate.lua\", compare = { \"first_bond.time\" } }\n"
        "for _, axis in ipairs(c.axes) do print(axis.axis) end"};

constexpr std::array vary_option{Option{
    .name = "vary",
    .type = OptionType::texts,
    .range = at_least(1.0),
    .required = true,
    .sentence = "What varies, as --set of hackle study sweep: \"load=6:24:2MPa\" is a range, "
                "\"simulate.spacing=1mm,2mm\" a list; several make all combinations."}};
constexpr auto sweep_options = joined(joined(script_options, vary_option), compare_option);
constexpr FunctionDoc sweep_doc{
    .name = "study.sweep",
    .sentence = "Runs a script over ranges of its options; writes sweep.csv, .json and charts.",
    .options = sweep_options,
    .example =
        "w = study.sweep { \"plate.lua\", vary = { \"load=6:24:6MPa\" } }\n"
        "for _, run in ipairs(w.runs) do print(run.wall_s) end"};

Settings settings_in(Arguments& arguments, const std::string& who) {
  Settings settings;
  for (const std::string& word : arguments.texts("set")) {
    const std::size_t equals = word.find('=');
    if (equals == 0 || equals == std::string::npos)
      arguments.problems.add(fmt::format("{}: set has '{}', which is not key=value", who, word));
    else
      settings[word.substr(0, equals)] = word.substr(equals + 1);
  }
  return settings;
}

// A run of a study is one of many: it cannot begin a study itself.
void refuse_within_study(const Session& session, const std::string& who) {
  if (session.settings.sample_at)
    throw Error(ErrorKind::refused, fmt::format("{}: this run is itself one of a study", who),
                "study another script");
  if (session.settings.program.empty() && session.settings.purpose == Purpose::results)
    throw Error(ErrorKind::refused, fmt::format("{}: no program is known that runs scripts", who),
                "call it from a script of hackle run, or at the prompt");
}

CaseRunner runner_in(Session& session, Arguments& arguments, const FunctionDoc& doc) {
  const std::string who(doc.name);
  Settings settings = settings_in(arguments, who);
  arguments.problems.throw_if_any();
  refuse_within_study(session, who);
  const std::filesystem::path script = session.input_path(who, arguments.text("script"));
  const std::string usual = fmt::format("study/{}", script.stem().string());
  return {{.program = session.settings.program,
           .path = script,
           .settings = std::move(settings),
           .arguments = {}},
          {.folder = session.output_path(who, arguments.text("output", usual)),
           .threads = session.settings.execution.thread_count(),
           .talk = session.settings.talk}};
}

int finish(lua_State* L, const StudyFindings& findings, const nlohmann::ordered_json& json,
           const CaseRunner& runner) {
  write_findings(findings, json, runner.options().folder);
  push_json(L, json);
  return 1;
}

int study_trade(lua_State* L) {
  Arguments arguments = Arguments::from_table(L, 1, trade_doc);
  Session& session = session_of(L);
  const auto quantities = arguments.texts("compare");
  CaseRunner runner = runner_in(session, arguments, trade_doc);
  if (session.settings.purpose != Purpose::results) return 0;
  const Trade found = trade(runner, quantities_named(quantities));
  return finish(L, {"trade", text_of(found), table_of(found), {chart_of(found)}}, to_json(found),
                runner);
}

int study_ensemble(lua_State* L) {
  Arguments arguments = Arguments::from_table(L, 1, ensemble_doc);
  Session& session = session_of(L);
  const EnsembleOptions options{.runs = static_cast<int>(arguments.integer("runs", 32))};
  CaseRunner runner = runner_in(session, arguments, ensemble_doc);
  if (session.settings.purpose != Purpose::results) return 0;
  const Ensemble all = ensemble(runner, options);
  return finish(L, {"ensemble", text_of(all), table_of(all), {chart_of(all)}}, to_json(all),
                runner);
}

int study_convergence(lua_State* L) {
  Arguments arguments = Arguments::from_table(L, 1, convergence_doc);
  Session& session = session_of(L);
  const auto quantities = arguments.texts("compare");
  CaseRunner runner = runner_in(session, arguments, convergence_doc);
  if (session.settings.purpose != Purpose::results) return 0;
  ConvergenceOptions options;
  options.quantities = quantities_named(quantities);
  const ConvergenceStudy found = convergence(runner, options);
  return finish(L, findings_of(found), to_json(found), runner);
}

int study_sweep(lua_State* L) {
  Arguments arguments = Arguments::from_table(L, 1, sweep_doc);
  Session& session = session_of(L);
  const auto quantities = arguments.texts("compare");
  const auto ranges = arguments.texts("vary");
  CaseRunner runner = runner_in(session, arguments, sweep_doc);
  if (session.settings.purpose != Purpose::results) return 0;
  SweepOptions options;
  for (const std::string& word : ranges) options.parameters.push_back(parameter_of(word, false));
  options.quantities = quantities_named(quantities);
  const Sweep found = sweep(runner, options);
  constexpr std::size_t columns = 80;
  return finish(L, findings_of(found, columns), to_json(found), runner);
}

}  // namespace

std::span<const Function> study_functions() {
  static constexpr std::array functions{Function{&trade_doc, guarded<study_trade>},
                                        Function{&ensemble_doc, guarded<study_ensemble>},
                                        Function{&convergence_doc, guarded<study_convergence>},
                                        Function{&sweep_doc, guarded<study_sweep>}};
  return functions;
}

void close_study(lua_State* L) {
  static constexpr std::array<std::string_view, 4> names{"trade", "ensemble", "convergence",
                                                         "sweep"};
  lua_getglobal(L, "study");
  close_names(L, "study", names);
  lua_pop(L, 1);
}

}  // namespace hackle
