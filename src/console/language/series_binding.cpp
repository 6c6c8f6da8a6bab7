// SPDX-License-Identifier: MIT
#include "console/language/series_binding.hpp"

#include <array>

#include "console/language/noun_options.hpp"
#include "console/language/picture_options.hpp"
#include "console/language/scripted_column.hpp"
#include "console/language/scripted_recording.hpp"
#include "console/language/scripted_run.hpp"
#include "console/schema/arguments.hpp"
#include "console/schema/object_type.hpp"
#include "output/files/series_output.hpp"

namespace hackle {
namespace {

constexpr std::array columns_option{Option{
    .name = "columns",
    .type = OptionType::columns,
    .read = read_columns,
    .range = at_least(1.0),
    .rest = true,
    .fallback = "the useful ones",
    .sentence =
        "What each row holds behind its time, in order: names of help \"columns\", functions "
        "of the simulation that return a number, {name = function}; they may stand behind "
        "the file."}};

constexpr auto log_options = joined(joined(file_option, columns_option), options_of<SeriesOptions>);

constexpr FunctionDoc log_doc{
    .name = "log",
    .owner = "s",
    .sentence =
        "Writes numbers of the following run as a table, CSV in SI units that pandas, gnuplot and "
        "a spreadsheet read, while it goes on; a run file gets a copy at its end. Rows lie at the "
        "times asked for (help \"times\").",
    .options = log_options,
    .example =
        "s:log { \"run.csv\", every = 1*us, \"external\", \"tip.x\", \"tip.speed\", "
        "\"max.stress_1\","
        "\n        { middle = function(s) return s:at({50*mm, 30*mm}).uy end } }\n"
        "s:log \"steps.csv\" s:run(2*us)"};

constexpr FunctionDoc recorded_log_doc{
    .name = "log",
    .owner = "r",
    .sentence = "Writes numbers of the records as a table, CSV, with what a recording knows.",
    .options = log_options,
    .example = "r:log { \"records.csv\", \"kinetic\", \"bonds\", \"tip.x\" }"};

// Columns are named before anything is written.
std::vector<Column> columns_of_run(lua_State* L, const Arguments& arguments,
                                   const SeriesOptions& options, const Run& run) {
  const auto given = arguments.get<ScriptedColumns>("columns", {});
  const auto& checkpoints = session_of(L).checkpoints;
  const View view = run.simulation();
  return checked_columns(
      given.empty() ? usual_columns(view, true, !options.every)
                    : columns_of(given, run, checkpoints ? &checkpoints->replay() : nullptr),
      options, view, true, "log");
}

std::vector<Column> columns_of_records(const Arguments& arguments, const SeriesOptions& options,
                                       const View& view) {
  const auto given = arguments.get<ScriptedColumns>("columns", {});
  return checked_columns(
      given.empty() ? usual_columns(view, false, false) : columns_of(given, view), options, view,
      false, "log");
}

int log_run(lua_State* L) {
  ScriptedRun& scripted = self<ScriptedRun>(L, log_doc);
  const Arguments arguments = Arguments::from_table(L, 2, log_doc);
  arguments.problems.throw_if_any();
  const auto options = noun_of<SeriesOptions>(arguments);
  auto columns = columns_of_run(L, arguments, options, scripted.run());
  const auto path = session_of(L).output_path("log", arguments.text("file"));
  scripted.run().log(path, options, std::move(columns));
  scripted.promised.push_back(path);
  return 0;
}

int log_recording(lua_State* L) {
  Recording& recording = *self<ScriptedRecording>(L, recorded_log_doc).recording;
  const Arguments arguments = Arguments::from_table(L, 2, recorded_log_doc);
  arguments.problems.throw_if_any();
  const auto options = noun_of<SeriesOptions>(arguments);
  const auto columns = columns_of_records(arguments, options, recording.view());
  Session& session = session_of(L);
  const auto path = session.claim("log", arguments.text("file"), FileKind::table);
  if (session.settings.purpose != Purpose::results) return 0;
  write_table(recording, path, options, columns);
  session.names->complete(path);
  return 0;
}

}  // namespace

std::span<const Function> series_methods() {
  static constexpr std::array methods{Function{&log_doc, guarded<log_run>, Replayed::declares}};
  return methods;
}

std::span<const Function> recorded_series_methods() {
  static constexpr std::array methods{Function{&recorded_log_doc, guarded<log_recording>}};
  return methods;
}

}  // namespace hackle
