// SPDX-License-Identifier: MIT
#include "console/language/graph_binding.hpp"

#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>

#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "console/language/scripted_recording.hpp"
#include "console/language/scripted_run.hpp"
#include "console/schema/arguments.hpp"
#include "console/schema/object_type.hpp"
#include "console/schema/result_table.hpp"
#include "output/files/graph_file.hpp"

namespace hackle {
namespace {

constexpr auto table_names = std::to_array<std::string_view>({"paths", "tips", "events"});

constexpr std::array graph_options{
    Option{.name = "file",
           .type = OptionType::text,
           .positional = true,
           .alternative = true,
           .sentence = "File to write: .json with all of it, or .csv with one table."},
    Option{.name = "table",
           .type = OptionType::choice,
           .fallback = "paths",
           .choices = table_names,
           .sentence = "Table of a .csv: the points of all paths, the tips, or the events."},
};
constexpr FunctionDoc graph_doc{
    .name = "graph",
    .owner = "s",
    .sentence =
        "Returns the cracks as a graph: time (s), c_R (m/s), cracks, tips (as s:tips returns them) "
        "and events. A crack is a piece without a fork: number, parent (0: none), initial (of the "
        "scene), length (m), born (s), max_speed (m/s), points (a list of x, y and t). An event "
        "has kind (nucleation, branch, coalescence, arrest, arrival), time, x, y, crack, other, "
        "angle (rad, between branches), speed (m/s), site (inside, edge, hole).",
    .options = graph_options,
    .example =
        "for _, e in ipairs(s:graph().events) do print(e.kind, e.time, e.x, e.y) end\n"
        "s:graph { \"cracks.json\" }"};
constexpr FunctionDoc recorded_graph_doc{
    .name = "graph",
    .owner = "r",
    .sentence = "Returns the cracks as a graph, as s:graph does; times are those of the records.",
    .options = graph_options,
    .example = "print(#r:graph().cracks)"};
constexpr FunctionDoc tips_doc{
    .name = "tips",
    .owner = "s",
    .call = Call::values,
    .sentence =
        "Lists the tips of all cracks: crack (its number in s:graph), x, y (m), direction (rad), "
        "speed (m/s, over the last two horizons), share (of c_R), state (initial, running, "
        "arrested, arrived, joined), length of its piece (m), born (s), born_x, born_y.",
    .example = "for _, tip in ipairs(s:tips()) do print(tip.x, tip.y, tip.speed) end"};

constexpr auto graph_names =
    std::to_array<std::string_view>({"time", "c_R", "cracks", "tips", "events"});
constexpr auto crack_names = std::to_array<std::string_view>(
    {"number", "parent", "initial", "length", "born", "max_speed", "points"});
constexpr auto point_names = std::to_array<std::string_view>({"x", "y", "t"});
constexpr auto tip_names =
    std::to_array<std::string_view>({"crack", "x", "y", "direction", "speed", "share", "state",
                                     "length", "born", "born_x", "born_y"});
constexpr auto crack_event_names = std::to_array<std::string_view>(
    {"kind", "time", "x", "y", "crack", "other", "angle", "speed", "site"});

void set_if(lua_State* L, const char* name, const std::optional<double>& value) {
  if (value) set_number(L, name, *value);
}
void set_time(lua_State* L, const char* name, double time) {
  if (std::isfinite(time)) set_number(L, name, time);
}
void set_text(lua_State* L, const char* name, std::string_view text) {
  push_text(L, text);
  lua_setfield(L, -2, name);
}
void set_place(lua_State* L, const Vec2& place) {
  set_number(L, "x", place.x());
  set_number(L, "y", place.y());
}

// Lists begin at 1 in Lua.
int number_in_list(int number) {
  return number + 1;
}

// [-0, +1] Pushes a list, each item by `push`.
template <class Items, class Push>
void push_each(lua_State* L, const Items& items, const Push& push) {
  lua_createtable(L, static_cast<int>(items.size()), 0);
  for (std::size_t k = 0; k < items.size(); ++k) {
    push(items[k], static_cast<int>(k));
    lua_rawseti(L, -2, static_cast<lua_Integer>(k) + 1);
  }
}

void push_crack(lua_State* L, const CrackPiece& piece, int number) {
  lua_createtable(L, 0, crack_names.size());
  close_names(L, "s:graph().cracks", crack_names);
  set_integer(L, "number", number_in_list(number));
  set_integer(L, "parent", number_in_list(piece.parent));
  lua_pushboolean(L, piece.initial ? 1 : 0);
  lua_setfield(L, -2, "initial");
  set_number(L, "length", piece.length);
  set_time(L, "born", piece.times.front());
  set_if(L, "max_speed", piece.max_speed);
  push_each(L, piece.points, [&](const Vec2& point, int k) {
    lua_createtable(L, 0, point_names.size());
    close_names(L, "s:graph().cracks.points", point_names);
    set_place(L, point);
    set_time(L, "t", piece.times[static_cast<std::size_t>(k)]);
  });
  lua_setfield(L, -2, "points");
}

void push_tip(lua_State* L, const CrackTip& tip, const CrackGraph& graph) {
  const CrackPiece& piece = graph.cracks[static_cast<std::size_t>(tip.crack)];
  lua_createtable(L, 0, tip_names.size());
  close_names(L, "s:tips()", tip_names);
  set_integer(L, "crack", number_in_list(tip.crack));
  set_place(L, tip.place);
  set_number(L, "direction", std::atan2(tip.direction.y(), tip.direction.x()));
  set_number(L, "speed", tip.speed);
  set_number(L, "share", graph.rayleigh > 0.0 ? tip.speed / graph.rayleigh : 0.0);
  set_text(L, "state", name_of(tip.state));
  set_number(L, "length", piece.length);
  set_time(L, "born", piece.times.front());
  set_number(L, "born_x", piece.points.front().x());
  set_number(L, "born_y", piece.points.front().y());
}

void push_event(lua_State* L, const CrackEvent& event) {
  lua_createtable(L, 0, crack_event_names.size());
  close_names(L, "s:graph().events", crack_event_names);
  set_text(L, "kind", name_of(event.kind));
  set_if(L, "time", event.time);
  set_place(L, event.place);
  set_integer(L, "crack", number_in_list(event.crack));
  if (event.other >= 0) set_integer(L, "other", number_in_list(event.other));
  set_if(L, "angle", event.angle);
  set_if(L, "speed", event.speed);
  set_text(L, "site", name_of(event.site));
}

void push_tips(lua_State* L, const CrackGraph& graph) {
  push_each(L, graph.tips, [&](const CrackTip& tip, int) { push_tip(L, tip, graph); });
}

void push_graph(lua_State* L, const CrackGraph& graph) {
  lua_createtable(L, 0, graph_names.size());
  close_names(L, "s:graph()", graph_names);
  set_number(L, "time", graph.time);
  set_number(L, "c_R", graph.rayleigh);
  push_each(L, graph.cracks,
            [&](const CrackPiece& piece, int number) { push_crack(L, piece, number); });
  lua_setfield(L, -2, "cracks");
  push_tips(L, graph);
  lua_setfield(L, -2, "tips");
  push_each(L, graph.events, [&](const CrackEvent& event, int) { push_event(L, event); });
  lua_setfield(L, -2, "events");
}

void save_graph(lua_State* L, const CrackGraph& graph, const Arguments& arguments) {
  if (!arguments.has("file")) return;
  Session& session = session_of(L);
  const std::filesystem::path name = arguments.text("file");
  const FileKind kind = name.extension() == ".csv" ? FileKind::table : FileKind::text;
  const auto path = session.claim("graph", name, kind);
  if (session.settings.purpose != Purpose::results) return;
  write_graph(graph, arguments.choice<GraphTable>("table"), path);
  session.names->complete(path);
}

Arguments arguments_of(lua_State* L, const FunctionDoc& doc) {
  Arguments arguments = Arguments::from_table(L, 2, doc);
  arguments.problems.throw_if_any();
  if (arguments.has("file")) check_graph_ending("graph", arguments.text("file"));
  return arguments;
}

int graph_of_run(lua_State* L) {
  const ScriptedRun& scripted = self<ScriptedRun>(L, graph_doc);
  const Arguments arguments = arguments_of(L, graph_doc);
  scripted.run().look();
  const CrackGraph graph = scripted.run().crack_graph();
  save_graph(L, graph, arguments);
  push_graph(L, graph);
  return 1;
}

int tips_of_run(lua_State* L) {
  const ScriptedRun& scripted = self<ScriptedRun>(L, tips_doc);
  Arguments::from_values(L, 2, tips_doc).problems.throw_if_any();
  scripted.run().look();
  push_tips(L, scripted.run().crack_graph());
  return 1;
}

// Up to the last record; shows the same record as before.
CrackGraph graph_of(Recording& recording) {
  CrackGrowth growth;
  const std::size_t shown = recording.shown();
  for (std::size_t k = 0; k < recording.times().size(); ++k) {
    throw_if_interrupted();
    recording.go_to(k);
    growth.look(recording.view());
  }
  recording.go_to(shown);
  return crack_graph(growth);
}

int graph_of_recording(lua_State* L) {
  Recording& recording = *self<ScriptedRecording>(L, recorded_graph_doc).recording;
  const Arguments arguments = arguments_of(L, recorded_graph_doc);
  const CrackGraph graph = graph_of(recording);
  save_graph(L, graph, arguments);
  push_graph(L, graph);
  return 1;
}

}  // namespace

std::span<const Function> graph_methods() {
  static constexpr std::array methods{Function{&graph_doc, guarded<graph_of_run>},
                                      Function{&tips_doc, guarded<tips_of_run>}};
  return methods;
}

std::span<const Function> recorded_graph_methods() {
  static constexpr std::array methods{Function{&recorded_graph_doc, guarded<graph_of_recording>}};
  return methods;
}

}  // namespace hackle
