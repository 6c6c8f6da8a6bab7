// SPDX-License-Identifier: MIT
#include "console/language/show_binding.hpp"

#include <array>
#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

#include "base/streams.hpp"
#include "console/language/live_view.hpp"
#include "console/language/picture_options.hpp"
#include "console/language/picture_text.hpp"
#include "console/language/scripted_recording.hpp"
#include "console/language/scripted_run.hpp"
#include "console/lua/description.hpp"
#include "console/schema/arguments.hpp"
#include "console/schema/object_type.hpp"
#include "output/files/replay.hpp"
#include "output/picture/chart_data.hpp"
#include "output/picture/painting.hpp"

namespace hackle {
namespace {

constexpr auto show_options = joined(options_of<ShownRecord>, unsized_picture_options);

constexpr FunctionDoc show_doc{
    .name = "show",
    .leading = "s",
    .sentence =
        "Shows the present state of a simulation, or a recording, in the terminal; without a "
        "terminal, as show_1.png, show_2.png, ... in the output folder.",
    .options = show_options,
    .example = "show(s) show(s, { zoom = {60*mm, 20*mm, 10*mm} })"};

constexpr auto watch_options = joined(options_of<WatchOptions>, unsized_picture_options);

constexpr FunctionDoc watch_doc{.name = "watch",
                                .owner = "s",
                                .sentence =
                                    "Redraws it in the terminal while it runs, always in the same "
                                    "place; without a terminal does nothing.",
                                .options = watch_options,
                                .example = "s:watch { every = 0.5*us } s:run(2*us) s:watch()"};

// show { s, zoom = ... } means show(s, { zoom = ... }): copies the options in the braces, without
// the simulation.
void open_braces(lua_State* L) {
  if (lua_type(L, 1) != LUA_TTABLE) return;
  lua_settop(L, 1);
  lua_newtable(L);
  for (lua_pushnil(L); lua_next(L, 1) != 0; lua_pop(L, 1)) {
    lua_pushvalue(L, -2);
    lua_pushvalue(L, -2);
    lua_rawset(L, 2);
  }
  lua_rawgeti(L, 1, 1);
  lua_replace(L, 1);
  lua_pushnil(L);
  lua_rawseti(L, 2, 1);
}

void check_is_shown(lua_State* L, int index) {
  if (object_at<ScriptedRun>(L, index) != nullptr) return;
  if (object_at<ScriptedRecording>(L, index) != nullptr) return;
  throw Error(ErrorKind::refused,
              fmt::format("show: expected a simulation first, got {}", description(L, index)),
              fmt::format("as in {}", show_doc.example));
}

// Returns what to show: a simulation in its present state, or a recording at the requested time.
View view_at(lua_State* L, int index, const Arguments& arguments) {
  if (const ScriptedRun* scripted = object_at<ScriptedRun>(L, index)) {
    if (arguments.has("time"))
      throw Error(ErrorKind::refused, "show: time is for recordings",
                  "a simulation shows its present state; s:run() continues it");
    return scripted->simulation();
  }
  Recording& recording = *object_at<ScriptedRecording>(L, index)->recording;
  show_record(recording, noun_of<ShownRecord>(arguments));
  return recording.view();
}

void show_in_terminal(const Session& session, const View& view, const PictureOptions& options) {
  const Terminal terminal = terminal_of(STDOUT_FILENO);
  std::string text = picture_text(view, options, terminal);
  // During a run, the progress bar is on this line.
  if (session.settings.talk == Talk::animated) text.insert(0, "\r\033[K");
  flush(stdout);
  write_picture(text, terminal, STDOUT_FILENO);
}

// A run counts its pictures; a recording does not.
void show_in_file(Session& session, Run* run, const View& view, const PictureOptions& options) {
  if (session.settings.no_pictures) return;
  const std::string name = fmt::format("show_{}.png", ++session.pictures_shown);
  const auto path = session.output_path("show", name);
  if (run != nullptr)
    run->frame(path, options);
  else
    session.write_picture("show", name,
                          [&](const auto& file) { write_picture(view, options, file); });
  std::FILE* file = session.settings.print_to_stderr ? stderr : stdout;
  write_to(file, fmt::format("{}: {}\n", caption(view, options), path.string()));
  flush(file);
}

int show(lua_State* L) {
  open_braces(L);
  check_is_shown(L, 1);
  if (lua_isnoneornil(L, 2)) {
    lua_settop(L, 1);
    lua_newtable(L);
  }
  const Arguments arguments = Arguments::from_table(L, 2, show_doc);
  arguments.problems.throw_if_any();
  const PictureOptions options = noun_of<PictureOptions>(arguments);
  const View view = view_at(L, 1, arguments);
  check("show", options, view.lattice().grid);
  check_alone("show", options);
  if (object_at<ScriptedRecording>(L, 1) != nullptr) check_recorded("show", options);
  Session& session = session_of(L);
  const ScriptedRun* scripted = object_at<ScriptedRun>(L, 1);
  if (session.settings.show_in_terminal)
    show_in_terminal(session, view, options);
  else
    show_in_file(session, scripted != nullptr ? &scripted->run() : nullptr, view, options);
  return 0;
}

int watch(lua_State* L) {
  ScriptedRun& scripted = self<ScriptedRun>(L, watch_doc);
  const Arguments arguments = Arguments::from_table(L, 2, watch_doc);
  arguments.problems.throw_if_any();
  const PictureOptions options = noun_of<PictureOptions>(arguments);
  const Simulation& simulation = scripted.simulation();
  check("watch", options, simulation.lattice().grid);
  Session& session = session_of(L);
  std::shared_ptr<LiveView> view;
  const auto watched = noun_of<WatchOptions>(arguments);
  if (watched.every && session.settings.show_in_terminal) {
    view = std::make_shared<LiveView>(session, options, *watched.every, simulation);
    scripted.run().watch(view);
  }
  if (scripted.view) scripted.view->end();
  scripted.view = std::move(view);
  return 0;
}

}  // namespace

std::span<const Function> show_methods() {
  static constexpr std::array methods{Function{&watch_doc, guarded<watch>, Replayed::declares}};
  return methods;
}

std::span<const Function> show_functions() {
  static constexpr std::array functions{Function{&show_doc, guarded<show>}};
  return functions;
}

}  // namespace hackle
