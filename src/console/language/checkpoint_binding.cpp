// SPDX-License-Identifier: MIT
#include "console/language/checkpoint_binding.hpp"

#include <array>
#include <memory>
#include <string_view>
#include <utility>

#include "console/language/background_binding.hpp"
#include "console/language/picture_options.hpp"
#include "console/language/scripted_run.hpp"
#include "console/lua/guard.hpp"
#include "console/schema/arguments.hpp"
#include "store/recorded_run.hpp"

namespace hackle {
namespace {

constexpr const char* lua_load = "hackle.lua_load";

constexpr FunctionDoc save_doc{
    .name = "save",
    .owner = "s",
    .sentence =
        "Writes the whole state, to the last bit, as a checkpoint: load goes on from it. "
        "The one before is kept as NAME_prev.ckpt.",
    .options = file_option,
    .example = "s:save { \"before.ckpt\" }"};

constexpr std::array checkpoint_options{
    Option{.name = "file",
           .type = OptionType::text,
           .required = true,
           .positional = true,
           .sentence = "File written by s:save{}, .ckpt, or by s:record{}, .h5, beside the script "
                       "or in the output folder."},
    Option{.name = "time",
           .unit = "s",
           .range = at_least(0.0),
           .fallback = "its last exact record",
           .sentence = "Time of a record of a run file; the nearest one is taken, which must be "
                       "exact."},
};

constexpr FunctionDoc load_doc{
    .name = "load",
    .sentence =
        "Returns the simulation of a checkpoint, or of an exact record, with the loads of that "
        "moment; its bits are the same on any number of threads. Any other text it compiles, as in "
        "Lua.",
    .options = checkpoint_options,
    .example =
        "s:run(1*us) s:save { \"a.ckpt\" }\nt = load \"a.ckpt\" t:run(1*us)\n"
        "s:record { \"a.h5\", every = 1*us, exact = true } s:run(2*us) s:close()\n"
        "u = load { \"a.h5\", time = 2*us } u:run(1*us)"};

int save(lua_State* L) {
  const ScriptedRun& scripted = self<ScriptedRun>(L, save_doc);
  const Arguments arguments = Arguments::from_table(L, 2, save_doc);
  arguments.problems.throw_if_any();
  if (session_of(L).follows()) return 0;
  scripted.run().save(session_of(L).output_path("save", arguments.text("file")));
  return 0;
}

bool is_name_of_run_file(std::string_view name) {
  return name.ends_with(".h5") || name.ends_with(".hdf5");
}

// Whether the first argument is neither Lua text nor a function that gives pieces of it.
bool names_file(lua_State* L) {
  if (lua_type(L, 1) != LUA_TSTRING) return !lua_isfunction(L, 1);
  std::size_t size = 0;
  const char* text = lua_tolstring(L, 1, &size);
  const std::string_view name(text, size);
  return (name.ends_with(".ckpt") || is_name_of_run_file(name)) &&
         name.find('\n') == std::string_view::npos;
}

int call_load_of_lua(lua_State* L) {
  lua_getfield(L, LUA_REGISTRYINDEX, lua_load);
  lua_insert(L, 1);
  lua_call(L, lua_gettop(L) - 1, LUA_MULTRET);
  return lua_gettop(L);
}

std::size_t last_exact(const RecordedRun& recorded) {
  for (std::size_t record = recorded.times().size() - 1; record > 0; --record)
    if (recorded.is_exact(record)) return record;
  return 0;
}

std::shared_ptr<Run> go_on_from_record(Session& session, const std::filesystem::path& path,
                                       const Arguments& arguments) {
  const RecordedRun recorded(path);
  const std::size_t record =
      arguments.has("time") ? recorded.nearest(arguments.number("time")) : last_exact(recorded);
  auto run = std::make_shared<Run>(recorded.simulation_at(record, session.settings.execution),
                                   session.settings.talk, session.origin);
  run->limit_output(session.settings.output_limit);
  run->share_names(session.names);
  return session.adopt(std::move(run));
}

std::shared_ptr<Run> go_on_from(Session& session, const std::filesystem::path& path,
                                const Arguments& arguments) {
  if (is_name_of_run_file(path.string())) return go_on_from_record(session, path, arguments);
  if (arguments.has("time"))
    throw Error(ErrorKind::refused, "load: a checkpoint has one time only",
                "leave `time` out; a run file with exact records has several");
  return session.resume(path);
}

int load(lua_State* L) {
  if (!names_file(L)) return call_load_of_lua(L);
  Session& session = session_of(L);
  const Arguments arguments = Arguments::from_table(L, 1, load_doc);
  arguments.problems.throw_if_any();
  const auto path = session.input_path("load", arguments.text("file"));
  collect_simulations(L);
  push_object(L, ScriptedRun(go_on_from(session, path, arguments), session));
  remember_simulation(L, -1);
  return 1;
}

}  // namespace

void keep_load_of_lua(lua_State* L) {
  lua_getglobal(L, "load");
  lua_setfield(L, LUA_REGISTRYINDEX, lua_load);
}

std::span<const Function> checkpoint_methods() {
  static constexpr std::array methods{Function{&save_doc, guarded<save>}};
  return methods;
}

std::span<const Function> checkpoint_functions() {
  static constexpr std::array functions{Function{&load_doc, guarded<load>, Replayed::declares}};
  return functions;
}

}  // namespace hackle
