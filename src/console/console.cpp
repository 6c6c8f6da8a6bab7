// SPDX-License-Identifier: MIT
#include "console/console.hpp"

#include <functional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/files.hpp"
#include "console/language/chart_binding.hpp"
#include "console/language/checkpoint_binding.hpp"
#include "console/language/constant_calls.hpp"
#include "console/language/contact_sheet_binding.hpp"
#include "console/language/gauge_binding.hpp"
#include "console/language/material_binding.hpp"
#include "console/language/plate_binding.hpp"
#include "console/language/recording_binding.hpp"
#include "console/language/scripted_material.hpp"
#include "console/language/scripted_plate.hpp"
#include "console/language/scripted_recording.hpp"
#include "console/language/scripted_run.hpp"
#include "console/language/show_binding.hpp"
#include "console/language/simulation_binding.hpp"
#include "console/language/study_binding.hpp"
#include "console/language/units_binding.hpp"
#include "console/language/values_binding.hpp"
#include "console/lua/description.hpp"
#include "console/lua/guard.hpp"
#include "console/lua/interrupt_hook.hpp"
#include "console/lua/lua_function.hpp"
#include "console/lua/lua_state.hpp"
#include "console/lua/module_binding.hpp"
#include "console/lua/process_binding.hpp"
#include "console/lua/standard_library.hpp"
#include "console/lua/value_text.hpp"
#include "console/prompt/kept_locals.hpp"
#include "console/reference/help.hpp"
#include "console/reference/vocabulary.hpp"
#include "console/schema/object_type.hpp"
#include "store/inputs.hpp"

namespace hackle {
namespace {

// Removes a first line that begins with #, but keeps its end, so that line numbers stay right.
std::string_view without_shebang(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  if (text.starts_with('#')) text.remove_prefix(std::min(text.find('\n'), text.size()));
  return text;
}

// [-0, +1] Compiles the text, or pushes the message. Accepts source text only.
bool load(lua_State* L, std::string_view text, const std::string& chunk) {
  return luaL_loadbufferx(L, text.data(), text.size(), chunk.c_str(), "t") == LUA_OK;
}

// `=x` shows the same values as `x`, as in lua.
Transcript::Chunk chunk_of(std::string_view text) {
  if (text.starts_with('=')) text.remove_prefix(1);
  return {.text = with_locals_kept(text)};
}

// [-0, +1] Compiles the text as an expression if possible, else as statements. Returns false with
// the message pushed.
bool load_line(lua_State* L, Transcript::Chunk& chunk) {
  chunk.is_expression = load(L, "return " + chunk.text, prompt_chunk);
  chunk.is_statement = load(L, chunk.text, prompt_chunk);
  lua_remove(L, chunk.is_expression ? -1 : -2);
  return chunk.is_expression || chunk.is_statement;
}

void set_arguments(lua_State* L, const std::string& name,
                   const std::vector<std::string>& arguments) {
  lua_createtable(L, static_cast<int>(arguments.size()), 1);
  push_text(L, name);
  lua_rawseti(L, -2, 0);
  lua_Integer place = 0;
  for (const std::string& argument : arguments) {
    push_text(L, argument);
    lua_rawseti(L, -2, ++place);
  }
  lua_setglobal(L, "arg");
}

int to_texts(lua_State* L) {
  const int count = lua_gettop(L);
  luaL_checkstack(L, 2, "too many values");
  for (int i = 1; i <= count; ++i) {
    push_text(L, value_text(L, i));
    lua_replace(L, i);
  }
  return count;
}

struct CompletionJob {
  const std::string& text;
  Completion result;
};

int complete_job(lua_State* L) {
  auto& job = *static_cast<CompletionJob*>(lua_touserdata(L, 1));
  job.result = complete(L, job.text);
  return 0;
}

// Returns out/<name of the script>. Files delivered with a script must not redirect it elsewhere.
std::filesystem::path default_output_folder(const std::filesystem::path& script, bool trust) {
  std::filesystem::path folder = "out" / script.stem();
  if (trust || real_path(folder) == real_path(".") / folder) return folder;
  throw Error(ErrorKind::refused,
              "the output folder '" + folder.string() + "' lies in '" +
                  real_path(folder).parent_path().string() + "'",
              "use -o to allow writing there");
}

// [-0, +0] Sets `_` to the value at 1, without calling a metamethod of _G.
void keep_last_value(lua_State* L) {
  lua_pushcfunction(L, [](lua_State* inner) {
    lua_pushglobaltable(inner);
    lua_insert(inner, 1);
    lua_pushliteral(inner, "_");
    lua_insert(inner, 2);
    lua_rawset(inner, 1);
    return 0;
  });
  lua_pushvalue(L, 1);
  protected_call(L, 1, 0);
}

Run* run_at(lua_State* L, int index) {
  const ScriptedRun* scripted = object_at<ScriptedRun>(L, index);
  return scripted != nullptr ? &scripted->run() : nullptr;
}

// A simulation has its number, a plate all that it is made of.
std::string name_in_journal(lua_State* L, int index) {
  if (const Run* run = run_at(L, index))
    return fmt::format("simulation {}", session_of(L).number_of(*run));
  if (const Plate* plate = object_at<Plate>(L, index)) return inputs_of(*plate, Numerics());
  return description(L, index);
}

// Calls of these are kept in the journal of a script.
void know_all(Replay& replay) {
  replay.know(simulation_type());
  replay.know(values_type());
  for (const auto functions : {simulation_functions(), checkpoint_functions(), show_functions(),
                               contact_sheet_functions(), chart_functions()})
    for (const Function& function : functions) replay.know(function);
}

// While it lives, printing clears the prompt's line first.
class Interlude {
 public:
  Interlude(Session& session, const MakeRoom& make_room) : session_(session) {
    session_.make_room = make_room;
  }
  ~Interlude() { session_.make_room = nullptr; }
  Interlude(const Interlude&) = delete;
  Interlude& operator=(const Interlude&) = delete;

 private:
  Session& session_;
};

// Returns the Error that `work` threw, or nothing.
std::optional<Error> failure_of(const std::function<void()>& work) {
  try {
    work();
    return std::nullopt;
  } catch (const Error& error) {
    return error;
  }
}

void throw_both(const std::optional<Error>& first, const std::optional<Error>& second) {
  if (!first && !second) return;
  std::vector<Problem> problems;
  for (const auto& error : {first, second})
    if (error) problems.insert(problems.end(), error->problems().begin(), error->problems().end());
  throw Error((first ? first : second)->kind(), std::move(problems));
}

}  // namespace

struct Console::Parts {
  explicit Parts(ConsoleSettings settings)
      : session(std::move(settings)), L(session.settings.lua_memory) {
    set_session(L, &session);
    session.objects.run_at = run_at;
    session.objects.name = name_in_journal;
    session.objects.push_empty = [](lua_State* l, const std::string&) {
      push_object(l, ScriptedValues());
    };
    session.names->place = [this] {
      const std::string text = place(L, 1);
      return text.substr(0, text.find_last_of(':'));
    };
    session.help_on = help_on;
    protect(L, [this](lua_State*) { open(); });
  }

  void open() {
    open_standard_library(L);
    open_errors(L);
    open_kept_functions(L);
    open_units(L);
    open_type(L, type_name<Material>, material_type());
    open_type(L, type_name<Plate>, plate_type());
    open_type(L, type_name<ScriptedRun>, simulation_type());
    open_type(L, type_name<ScriptedRecording>, recording_type());
    open_type(L, type_name<ScriptedGauge>, gauge_type());
    open_type(L, type_name<ScriptedValues>, values_type());
    keep_load_of_lua(L);
    open_functions(L, all_functions());
    close_study(L);
    open_exit(L);
    open_print(L);
  }

  // Calls the function below `arguments` values on the stack; os.exit is not a failure.
  void call(int arguments, int results) {
    const auto failure = failure_of([&] {
      const InterruptWatch watch(L);
      protected_call(L, arguments, results);
    });
    if (failure && !session.exit_code) throw Error(*failure);
  }

  // Runs the chunk that load_line has pushed.
  void carry_out(const Transcript::Chunk& chunk) {
    using Outcome = Transcript::Outcome;
    session.begin_line(chunk);
    try {
      call(0, LUA_MULTRET);
    } catch (const Error& error) {
      const bool interrupted = error.kind() == ErrorKind::interrupted;
      session.end_line(chunk, interrupted ? Outcome::interrupted : Outcome::failed);
      throw;
    }
    const bool has_value = lua_gettop(L) > 0 && !lua_isnil(L, 1);
    session.end_line(chunk, has_value ? Outcome::value : Outcome::nothing);
  }

  void run_chunk(std::string_view text, const std::string& chunk,
                 const std::vector<std::string>& arguments) {
    if (session.checkpoints) know_all(session.checkpoints->replay());
    lua_settop(L, 0);
    if (!load(L, text, chunk)) throw take_error(L);
    if (session.settings.purpose == Purpose::results) check_constant_calls(text);
    session.arguments = arguments;
    protect(L, [&](lua_State* l) { set_arguments(l, session.origin.script_name, arguments); });
    luaL_checkstack(L, static_cast<int>(arguments.size()) + 2, "too many arguments");
    for (const std::string& argument : arguments) push_text(L, argument);
    call(static_cast<int>(arguments.size()), 0);
    if (!session.exit_code) session.check_overrides_used();
  }

  void check_constant_calls(std::string_view text) {
    Problems problems;
    protect(L, [&](lua_State* l) {
      problems = problems_of_constant_calls(l, text, session.origin.script_name);
    });
    problems.throw_if_any();
  }

  // Their functions may run long, as those of any script.
  void settle_expectations() {
    const InterruptWatch watch(L);
    protect(L, [this](lua_State*) { session.settle_expectations(); });
  }

  void run_to_the_end(const std::string& text, const std::string& chunk,
                      const std::vector<std::string>& arguments) {
    run_chunk(without_shebang(text), chunk, arguments);
    if (!session.exit_code) session.finish_work();
    settle_expectations();
  }

  void run_before_the_prompt(const std::string& text, const std::string& chunk,
                             const std::vector<std::string>& arguments) {
    const std::string kept = with_locals_kept(without_shebang(text));
    const auto failure = failure_of([&] {
      run_chunk(kept, chunk, arguments);
      settle_expectations();
    });
    using Outcome = Transcript::Outcome;
    session.end_line({.text = kept}, failure ? Outcome::failed : Outcome::nothing);
    if (failure) throw Error(*failure);
  }

  Session session;
  LuaState L;  // after the session, which its objects use in their destructors
};

Console::Console(ConsoleSettings settings) : parts_(std::make_unique<Parts>(std::move(settings))) {
}

Console::~Console() = default;

void Console::run_file(const std::filesystem::path& path, const std::vector<std::string>& arguments,
                       Ending ending) {
  const std::string text = read_text(path);
  protect(parts_->L, [&](lua_State* L) { look_for_modules_in(L, path.parent_path()); });
  ConsoleSettings& settings = parts_->session.settings;
  const bool named = !settings.output_folder.empty();
  if (!named) settings.output_folder = default_output_folder(path, settings.trust);
  using Choice = OutputFolder::Choice;
  parts_->session.folder.emplace(
      settings.output_folder,
      settings.force ? Choice::force : (named ? Choice::named : Choice::free),
      RunInputs{path.stem().string(), settings.overrides, arguments});
  parts_->session.origin = {path.string(), text};
  if (ending == Ending::close) parts_->session.begin_checkpoints();
  run_text(text, path.string(), arguments, ending);
}

void Console::run_on(Found found, Ending ending) {
  const Continuation& former = found.continuation;
  const std::filesystem::path path = former.origin.script_name;
  std::error_code ignored;
  const bool is_there = std::filesystem::is_regular_file(path, ignored);
  const std::string text = is_there ? read_text(path) : former.origin.script_text;
  protect(parts_->L, [&](lua_State* L) { look_for_modules_in(L, path.parent_path()); });
  Session& session = parts_->session;
  session.folder.emplace(session.settings.output_folder, OutputFolder::Choice::named,
                         former.inputs);
  session.origin = {path.string(), text};
  const std::vector<std::string> arguments = former.inputs.arguments;
  session.continue_from(std::move(found));
  run_text(text, path.string(), arguments, ending);
}

void Console::run_text(const std::string& text, const std::string& name,
                       const std::vector<std::string>& arguments, Ending ending) {
  parts_->session.origin = {name, text};
  if (ending == Ending::go_on) return parts_->run_before_the_prompt(text, "@" + name, arguments);
  const auto failure = failure_of([&] { parts_->run_to_the_end(text, "@" + name, arguments); });
  Session& session = parts_->session;
  if (failure && session.checkpoints) session.checkpoints->keep_last();
  throw_both(failure, failure_of([this] { close_all(); }));
  // In this order: a checkpoint without what it needs must not look like an unfinished run.
  if (session.folder) session.folder->finish();
  if (session.checkpoints) session.checkpoints->remove();
}

void Console::page_with(std::function<void(const std::string&)> page) {
  parts_->session.settings.page = std::move(page);
}

bool Console::is_incomplete(const std::string& text) const {
  lua_State* L = parts_->L;
  Transcript::Chunk chunk = chunk_of(text);
  const bool complete = load_line(L, chunk);
  constexpr std::string_view end = "<eof>";
  const std::string_view message = complete ? "" : lua_tostring(L, -1);
  const bool incomplete = !complete && message.ends_with(end);
  lua_settop(L, 0);
  return incomplete;
}

Completion Console::complete(const std::string& text) const {
  lua_State* L = parts_->L;
  CompletionJob job{text, {}};
  lua_pushcfunction(L, guarded<complete_job>);
  lua_pushlightuserdata(L, &job);
  protected_call(L, 1, 0);
  return std::move(job.result);
}

std::vector<std::string> Console::evaluate(const std::string& text) {
  lua_State* L = parts_->L;
  lua_settop(L, 0);
  Transcript::Chunk chunk = chunk_of(text);
  if (!load_line(L, chunk)) throw take_error(L);
  parts_->carry_out(chunk);
  if (lua_gettop(L) == 1 && is_exit(L, 1)) parts_->call(0, 0);
  const int count = lua_gettop(L);
  if (count > 0 && !lua_isnil(L, 1)) keep_last_value(L);
  lua_pushcfunction(L, to_texts);
  lua_insert(L, 1);
  parts_->call(count, LUA_MULTRET);
  std::vector<std::string> values;
  for (int i = 1; i <= lua_gettop(L); ++i) {
    std::size_t size = 0;
    const char* value = lua_tolstring(L, i, &size);
    values.emplace_back(value, size);
  }
  lua_settop(L, 0);
  return values;
}

bool Console::is_working() const {
  return parts_->session.is_working();
}

std::vector<std::string> Console::work(double seconds, const MakeRoom& make_room) {
  const Interlude interlude(parts_->session, make_room);
  std::vector<std::string> news;
  for (const int number : parts_->session.work(seconds))
    news.push_back(fmt::format("simulation {} has arrived", number));
  return news;
}

void Console::pause_work() {
  parts_->session.pause_work();
}

void Console::finish_work() {
  parts_->session.finish_work();
}

void Console::close_all() {
  parts_->session.close_all();
}

std::vector<Summary> Console::simulations() const {
  return parts_->session.summaries();
}

std::vector<Rehearsal> Console::rehearsals() const {
  return parts_->session.rehearsals();
}

std::vector<Expectation> Console::expectations() const {
  std::vector<Expectation> list;
  for (const OpenExpectation& expected : parts_->session.expectations)
    list.push_back(expected.expectation);
  return list;
}

const std::map<std::string, std::string>& Console::options() const {
  return parts_->session.declared_options;
}

std::optional<int> Console::exit_code() const {
  return parts_->session.exit_code;
}

}  // namespace hackle
