// SPDX-License-Identifier: MIT
#include "console/language/checkpoint_binding.hpp"

#include <array>
#include <string_view>

#include "console/language/background_binding.hpp"
#include "console/language/picture_options.hpp"
#include "console/language/scripted_run.hpp"
#include "console/lua/guard.hpp"
#include "console/schema/arguments.hpp"

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
           .sentence = "File written by s:save{}, .ckpt, beside the script or in the output "
                       "folder."},
};

constexpr FunctionDoc load_doc{
    .name = "load",
    .sentence =
        "Returns the simulation of a checkpoint, with the loads of that moment; its bits "
        "are the same on any number of threads. Any other text it compiles, as in Lua.",
    .options = checkpoint_options,
    .example = "s:run(1*us) s:save { \"a.ckpt\" }\nt = load \"a.ckpt\" t:run(1*us)"};

int save(lua_State* L) {
  const ScriptedRun& scripted = self<ScriptedRun>(L, save_doc);
  const Arguments arguments = Arguments::from_table(L, 2, save_doc);
  arguments.problems.throw_if_any();
  scripted.run().save(session_of(L).output_path("save", arguments.text("file")));
  return 0;
}

// Whether the first argument is neither Lua text nor a function that gives pieces of it.
bool names_checkpoint(lua_State* L) {
  if (lua_type(L, 1) != LUA_TSTRING) return !lua_isfunction(L, 1);
  std::size_t size = 0;
  const char* text = lua_tolstring(L, 1, &size);
  const std::string_view name(text, size);
  return name.ends_with(".ckpt") && name.find('\n') == std::string_view::npos;
}

int call_load_of_lua(lua_State* L) {
  lua_getfield(L, LUA_REGISTRYINDEX, lua_load);
  lua_insert(L, 1);
  lua_call(L, lua_gettop(L) - 1, LUA_MULTRET);
  return lua_gettop(L);
}

int load(lua_State* L) {
  if (!names_checkpoint(L)) return call_load_of_lua(L);
  Session& session = session_of(L);
  const Arguments arguments = Arguments::from_table(L, 1, load_doc);
  arguments.problems.throw_if_any();
  const auto path = session.input_path("load", arguments.text("file"));
  collect_simulations(L);
  push_object(L, ScriptedRun(session.resume(path), session));
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
  static constexpr std::array functions{Function{&load_doc, guarded<load>}};
  return functions;
}

}  // namespace hackle
