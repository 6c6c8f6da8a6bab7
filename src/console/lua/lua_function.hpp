// SPDX-License-Identifier: MIT
// A function of a script that C++ stores and calls.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "console/lua/lua_state.hpp"

namespace hackle {

// Copies share one function. It may outlive its Lua state, but must not be called then.
class LuaFunction {
 public:
  // [-0, +0] Takes the function at `index`; `who` names it in messages: "traction: stress".
  LuaFunction(lua_State* L, int index, std::string who);

  // Calls the function with numbers and reads as many results as fit into `results`. Throws what
  // the function throws, and Error (refused) if it returns anything else, or does not return
  // within 200 million instructions of Lua though a result is due; messages end in `where`:
  // "at t = 2 us".
  void call(std::span<const double> arguments, std::span<double> results,
            const std::string& where) const;

  // Returns "function at script.lua:12".
  const std::string& text() const { return text_; }
  // Returns how many parameters the function names: 0 if it is written in C or takes (...).
  int parameters() const { return parameters_; }

 private:
  struct Reference;
  std::shared_ptr<const Reference> reference_;
  std::string who_;
  std::string text_;
  int parameters_ = 0;
};

// Call this once for a state whose functions are stored.
void open_kept_functions(lua_State* L);

}  // namespace hackle
