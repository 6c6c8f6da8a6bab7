// SPDX-License-Identifier: MIT
#include "console/language/error_budget.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "console/language/overrides.hpp"
#include "console/lua/lua_state.hpp"
#include "console/session.hpp"
#include "study/budget.hpp"

namespace hackle {
namespace {

// Nothing if it is not a number above 0: whoever reads the table says so.
std::optional<double> positive_in(lua_State* L, int index, const char* key) {
  lua_getfield(L, index, key);
  const double value = lua_type(L, -1) == LUA_TNUMBER ? lua_tonumber(L, -1) : 0.0;
  lua_pop(L, 1);
  return value > 0.0 && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

bool flag_in(lua_State* L, int index, const char* key) {
  lua_getfield(L, index, key);
  const bool value = lua_type(L, -1) == LUA_TBOOLEAN && lua_toboolean(L, -1) != 0;
  lua_pop(L, 1);
  return value;
}

std::string text_in(lua_State* L, int index, const char* key) {
  lua_getfield(L, index, key);
  std::string text = lua_type(L, -1) == LUA_TSTRING ? lua_tostring(L, -1) : "";
  lua_pop(L, 1);
  return text;
}

bool is_set(const Session& session, const std::string& key) {
  const auto at = session.settings.overrides.find(key);
  return at != session.settings.overrides.end() && at->second != "default";
}

// A script that can be run again, now being run for its results.
bool can_be_tried(const Session& session) {
  std::error_code ignored;
  return session.settings.purpose == Purpose::results && !session.has_prompt() &&
         !session.settings.program.empty() &&
         std::filesystem::is_regular_file(session.origin.script_name, ignored);
}

ErrorBudget tried(const Session& session, const BudgetOptions& options) {
  StudyScript script{.program = session.settings.program,
                     .path = session.origin.script_name,
                     .settings = session.settings.overrides,
                     .arguments = session.arguments};
  std::erase_if(script.settings, [](const auto& one) {
    return one.first == "simulate.within" || one.first == "simulate.verify" ||
           one.first == "simulate.spacing";
  });
  CaseRunner runner(script, {.folder = std::filesystem::path("out/study") / script.path.stem(),
                             .threads = session.settings.execution.thread_count(),
                             .talk = session.settings.talk});
  return budget_by_trials(runner, budget_calibration(), options);
}

}  // namespace

std::optional<ErrorBudget> spend_budget(lua_State* L, int index, const Plate& plate,
                                        const Session& session) {
  if (lua_type(L, index) != LUA_TTABLE || is_set(session, "simulate.spacing")) return std::nullopt;
  const std::optional<double> within = positive_in(L, index, "within");
  if (!within) return std::nullopt;
  const BudgetOptions options{.within = *within,
                              .verify = flag_in(L, index, "verify"),
                              .horizon = positive_in(L, index, "horizon"),
                              .max_spacing = positive_in(L, index, "spacing"),
                              .precision = text_in(L, index, "precision"),
                              .side = std::min(plate.width, plate.height)};
  ErrorBudget budget =
      can_be_tried(session) ? tried(session, options) : budget_from(budget_calibration(), options);
  copy_table(L, index);
  lua_pushnumber(L, budget.spacing);
  lua_setfield(L, index, "spacing");
  lua_pushlstring(L, budget.precision.data(), budget.precision.size());
  lua_setfield(L, index, "precision");
  return budget;
}

}  // namespace hackle
