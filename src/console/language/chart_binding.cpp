// SPDX-License-Identifier: MIT
#include "console/language/chart_binding.hpp"

#include <array>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "console/language/chart_docs.hpp"
#include "console/language/scripted_recording.hpp"
#include "console/language/scripted_run.hpp"
#include "console/language/scripted_source.hpp"
#include "console/schema/arguments.hpp"
#include "console/schema/object_type.hpp"
#include "console/session.hpp"
#include "output/chart/chart.hpp"

namespace hackle {
namespace {

ChartOptions options_in(const Arguments& arguments) {
  arguments.problems.throw_if_any();
  auto options = noun_of<ChartOptions>(arguments);
  check("chart", options);
  return options;
}

// A chart is a picture and the table behind it; drawn again, it replaces both.
void draw(Session& session, const Arguments& arguments, const auto& make_sources) {
  const ChartOptions options = options_in(arguments);
  const std::string name = arguments.text("file");
  std::vector<std::string> what = arguments.texts("what");
  if (what.empty()) what.emplace_back(usual_chart);
  const auto picture = session.claim("chart", name, FileKind::picture);
  const auto table = session.claim("chart", table_of_chart(name), FileKind::text);
  if (session.settings.purpose == Purpose::results)
    write_chart(chart_of(make_sources(), what, options), options, picture);
  for (const auto& path : {picture, table}) session.names->complete(path);
}

std::string name_of_run(const Session& session) {
  const std::string& script = session.origin.script_name;
  return script.empty() ? "run" : std::filesystem::path(script).stem().string();
}

ChartSource source_of(const Session& session, const Run& run) {
  return {name_of_run(session), run.tables(), run.simulation().view()};
}

ChartSource source_of(const Session& session, const ScriptedSource& given) {
  if (const auto* recording = std::get_if<std::shared_ptr<Recording>>(&given))
    return ChartSource(*recording);
  if (const auto* run = std::get_if<const Run*>(&given)) return source_of(session, **run);
  if (const auto* numbers = std::get_if<SeriesTable>(&given)) return ChartSource(*numbers);
  const auto path = session.input_path("chart", std::get<std::filesystem::path>(given));
  if (path.extension() == ".csv") return ChartSource(path);
  return ChartSource(std::make_shared<Recording>(path));
}

// Equal names get numbers, so that curves can be told apart.
void name_apart(std::vector<ChartSource>& sources) {
  std::set<std::string> taken;
  for (ChartSource& source : sources) {
    const std::string name = source.name();
    for (int number = 2; !taken.insert(source.name()).second; ++number)
      source.rename(fmt::format("{} {}", name, number));
  }
}

std::vector<ChartSource> sources_of(const Session& session, const Arguments& arguments) {
  std::vector<ChartSource> sources;
  for (const ScriptedSource& given : arguments.get<ScriptedSources>("of", {}))
    sources.push_back(source_of(session, given));
  const std::vector<std::string> names = arguments.texts("names");
  for (std::size_t k = 0; k < names.size() && k < sources.size(); ++k) sources[k].rename(names[k]);
  name_apart(sources);
  return sources;
}

// Each has a name, or all have that of their file.
void check_names(Arguments& arguments) {
  const std::size_t sources = arguments.get<ScriptedSources>("of", {}).size();
  const std::size_t names = arguments.texts("names").size();
  if (arguments.good({"of", "names"}) && names > 0 && names != sources)
    arguments.problems.add(fmt::format("chart: {} names for {} entries of of", names, sources),
                           "one for each");
}

int chart(lua_State* L) {
  Arguments arguments = Arguments::from_table(L, 1, chart_doc);
  check_names(arguments);
  Session& session = session_of(L);
  draw(session, arguments, [&] { return sources_of(session, arguments); });
  return 0;
}

int chart_run(lua_State* L) {
  const ScriptedRun& scripted = self<ScriptedRun>(L, run_chart_doc);
  const Arguments arguments = Arguments::from_table(L, 2, run_chart_doc);
  Session& session = session_of(L);
  scripted.results();
  draw(session, arguments, [&] { return std::vector{source_of(session, scripted.run())}; });
  return 0;
}

int chart_recording(lua_State* L) {
  const ScriptedRecording& scripted = self<ScriptedRecording>(L, recorded_chart_doc);
  const Arguments arguments = Arguments::from_table(L, 2, recorded_chart_doc);
  draw(session_of(L), arguments, [&] { return std::vector{ChartSource(scripted.recording)}; });
  return 0;
}

}  // namespace

std::span<const Function> chart_functions() {
  static constexpr std::array functions{Function{&chart_doc, guarded<chart>}};
  return functions;
}

std::span<const Function> chart_methods() {
  static constexpr std::array methods{Function{&run_chart_doc, guarded<chart_run>}};
  return methods;
}

std::span<const Function> recorded_chart_methods() {
  static constexpr std::array methods{Function{&recorded_chart_doc, guarded<chart_recording>}};
  return methods;
}

}  // namespace hackle
