// SPDX-License-Identifier: MIT
#include "console/language/recording_binding.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "base/units.hpp"
#include "console/language/background_binding.hpp"
#include "console/language/chart_binding.hpp"
#include "console/language/fracture_binding.hpp"
#include "console/language/gauge_binding.hpp"
#include "console/language/graph_binding.hpp"
#include "console/language/recording_docs.hpp"
#include "console/language/scripted_recording.hpp"
#include "console/language/series_binding.hpp"
#include "console/language/values_binding.hpp"
#include "console/schema/arguments.hpp"
#include "console/schema/object_type.hpp"
#include "console/session.hpp"
#include "output/files/panels.hpp"
#include "output/files/replay.hpp"
#include "output/picture/chart_data.hpp"
#include "output/picture/painting.hpp"

namespace hackle {
namespace {

// A script that is only checked may open a file that a real run would have written by then.
void check_is_there(const Session& session, const std::filesystem::path& path) {
  std::error_code ignored;
  if (session.settings.purpose == Purpose::check && !std::filesystem::exists(path, ignored))
    throw Error(ErrorKind::script,
                fmt::format("recording: '{}' does not exist yet", path.string()));
}

int open_recording(lua_State* L) {
  Session& session = session_of(L);
  const Arguments arguments = Arguments::from_table(L, 1, recording_doc);
  arguments.problems.throw_if_any();
  const auto path = session.input_path("recording", arguments.text("file"));
  check_is_there(session, path);
  collect_simulations(L);
  push_object(L, ScriptedRecording{session.open_recording(path)});
  return 1;
}

int frame(lua_State* L) {
  Recording& recording = *self<ScriptedRecording>(L, recorded_frame_doc).recording;
  const Arguments arguments = Arguments::from_table(L, 2, recorded_frame_doc);
  arguments.problems.throw_if_any();
  Session& session = session_of(L);
  const auto options = noun_of<PictureOptions>(arguments);
  check("frame", options, recording.view().lattice().grid);
  check_recorded("frame", options);
  check_alone("frame", options);
  session.write_picture("frame", arguments.text("file"), [&](const std::filesystem::path& path) {
    show_record(recording, noun_of<ShownRecord>(arguments));
    write_picture(recording.view(), options, path);
  });
  return 0;
}

// Under the ending that it is going to have.
std::filesystem::path claim_movie(Session& session, const char* who, const Arguments& arguments) {
  const bool fallback = arguments.flag("fallback");
  return session.claim(who, makeable(arguments.text("file"), fallback).path, FileKind::movie);
}

// Makes the movie at a claimed name. A call that is refused or fails releases the name.
void make_claimed(OutputNames& names, const std::filesystem::path& path, const auto& make) {
  try {
    make();
  } catch (...) {
    names.take_back(path);
    throw;
  }
  names.complete(path);
}

int movie(lua_State* L) {
  const auto recording = self<ScriptedRecording>(L, recorded_movie_doc).recording;
  const Arguments arguments = Arguments::from_table(L, 2, recorded_movie_doc);
  arguments.problems.throw_if_any();
  Session& session = session_of(L);
  const auto path = claim_movie(session, "movie", arguments);
  if (session.settings.purpose != Purpose::results) return 0;
  make_claimed(*session.names, path, [&] {
    film(recording, path, noun_of<MovieOptions>(arguments), noun_of<Moments>(arguments),
         session.settings.execution.thread_count(), session.settings.talk, session.names);
  });
  return 0;
}

int side_by_side(lua_State* L) {
  Arguments arguments = Arguments::from_table(L, 1, side_by_side_doc);
  const Tiles tiles = tiles_of(arguments, "side_by_side");
  arguments.problems.throw_if_any();
  Session& session = session_of(L);
  const auto path = claim_movie(session, "side_by_side", arguments);
  if (session.settings.purpose != Purpose::results) return 0;
  make_claimed(*session.names, path, [&] {
    const auto options = noun_of<SideBySideOptions>(arguments);
    auto movie = noun_of<MovieOptions>(arguments);
    movie.picture.width = options.width;
    film_side_by_side(tiles, path, movie, noun_of<Moments>(arguments),
                      {.columns = options.columns, .letters = options.letters},
                      session.settings.execution.thread_count(), session.settings.talk,
                      *session.names);
  });
  return 0;
}

Recording& recording_of(lua_State* L) {
  return *object_at<ScriptedRecording>(L, 1)->recording;
}

int recording_to_text(lua_State* L) {
  const Recording& recording = recording_of(L);
  push_text(
      L,
      fmt::format("{} records from {} to {}, {} nodes, {}",
                  grouped(static_cast<std::int64_t>(recording.times().size())),
                  quantity(recording.times().front(), "s"), quantity(recording.times().back(), "s"),
                  grouped(static_cast<std::int64_t>(recording.view().lattice().grid.nodes())),
                  describe(recording.plate())));
  return 1;
}

int push_times(lua_State* L) {
  lua_newtable(L);
  lua_Integer place = 0;
  for (const double time : recording_of(L).times()) {
    lua_pushnumber(L, time);
    lua_rawseti(L, -2, ++place);
  }
  return 1;
}

int push_recorded_nodes(lua_State* L) {
  lua_pushinteger(L, static_cast<lua_Integer>(recording_of(L).view().lattice().grid.nodes()));
  return 1;
}

int push_file(lua_State* L) {
  push_text(L, recording_of(L).path().string());
  return 1;
}

int push_script(lua_State* L) {
  push_text(L, recording_of(L).origin().script_name);
  return 1;
}

constexpr std::array own_methods{Function{&recorded_frame_doc, guarded<frame>},
                                 Function{&recorded_movie_doc, guarded<movie>}};

std::vector<Function> all_methods_of_recording() {
  std::vector<Function> all(own_methods.begin(), own_methods.end());
  for (const std::span<const Function> part :
       {recorded_series_methods(), recorded_chart_methods(), recorded_gauge_methods(),
        recorded_values_methods(), recorded_fracture_methods(), recorded_graph_methods()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

constexpr std::array recording_fields{
    Property{"times", "s", "Times of the records, a list.", push_times},
    Property{"nodes", "", "Number of nodes of the lattice.", push_recorded_nodes},
    Property{"file", "", "Path of the run file.", push_file},
    Property{"script", "", "Name of the script that made the run.", push_script},
};

}  // namespace

Tiles tiles_of(Arguments& arguments, const char* who) {
  Tiles tiles;
  for (const auto& recording : arguments.get<Recordings>("recordings", {}))
    tiles.push_back({recording, ""});
  std::vector<std::filesystem::path> paths;
  for (const Tile& tile : tiles) paths.push_back(tile.recording->path());
  const std::vector<std::string> names = panel_names(paths);
  for (std::size_t k = 0; k < tiles.size(); ++k) tiles[k].title = names[k];
  if (tiles.size() == 1) tiles.front().title.clear();  // its pictures say enough
  set_titles(who, "recordings", arguments.texts("titles"), tiles, arguments.problems);
  return tiles;
}

const TypeDoc& recording_type() {
  static const std::vector<Function> methods = all_methods_of_recording();
  static const TypeDoc type{.name = "recording",
                            .sentence = "A recorded run, for pictures, movies and tables.",
                            .methods = methods,
                            .fields = recording_fields,
                            .to_text = guarded<recording_to_text>,
                            .destroy = destroy_object<ScriptedRecording>};
  return type;
}

std::span<const Function> recording_functions() {
  static constexpr std::array functions{Function{&recording_doc, guarded<open_recording>},
                                        Function{&side_by_side_doc, guarded<side_by_side>}};
  return functions;
}

}  // namespace hackle
