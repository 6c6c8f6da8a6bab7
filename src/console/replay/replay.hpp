// SPDX-License-Identifier: MIT
// Runs a script again up to where it stopped, without computing. A journal is kept of what the
// script asks of its simulations. When the script is replayed, functions that only tell something
// return what they returned, functions that declare something (a movie, a load) are called again,
// and runs are passed over; functions of the script that a run called are called again at the same
// points. Every call is compared with the journal, with its arguments. At the end of the journal
// the simulations get their states back, and the script goes on for real.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "console/replay/journal.hpp"
#include "console/replay/lua_values.hpp"
#include "console/schema/schema.hpp"
#include "output/run/run.hpp"

namespace hackle {

// What a replay needs of the session: the objects of the script, whose simulations are numbered
// from 1 in the order they were made.
struct ReplayHost {
  std::function<Run*(lua_State* L, int index)> run_at;  // null for anything but a simulation
  NameObject name;
  // [-0, +1] Pushes an object without content such as the function of that name hands out.
  std::function<void(lua_State* L, const std::string& name)> push_empty;
  std::function<int(const Run& run)> number_of;
  std::function<Run*(int number)> run;  // null once it is gone
  // Told of every call, with what it was given in bytes, and whether it steps; may be empty.
  std::function<void(const std::string& call, const std::string& values, bool steps)> note;
  // Gives every simulation the state that it had at the end of the journal.
  std::function<void()> go_live;
};

class Replay {
 public:
  explicit Replay(ReplayHost host) : host_(std::move(host)) {}
  // Replays the journal before anything is computed.
  void begin_with(std::string journal);
  bool is_replaying() const { return reader_.has_value(); }

  // From now on calls of the methods and fields of the type, or of the function, are kept.
  void know(const TypeDoc& type);
  void know(const Function& function);
  // Calls a bound function, or the push of a property, for the script. `what` tells which: the
  // function or the property. Throws what it throws, and Error (refused) where the script does
  // something else than in the journal.
  int call(lua_State* L, const void* what, lua_CFunction function);

  // Adds somebody who calls functions of the script in the middle of a run; `again` does it in a
  // replay. Returns the number of the listener.
  std::uint64_t enlist(std::function<void()> again);
  // While it lives, such a function is called.
  class Event {
   public:
    Event(Replay& replay, std::uint64_t listener, const Run& run);
    ~Event();
    Event(const Event&) = delete;
    Event& operator=(const Event&) = delete;

   private:
    Replay& replay_;
    bool quiet_before_;
    int exceptions_;
  };

  // Replays what runs did after the last call of the script. Throws Error (refused) if the script
  // has ended before the journal.
  void finish();

  // Returns the journal up to the last point at which the script can go on.
  std::string journal() const { return writer_.bytes().substr(0, safe_end_); }
  // Returns why it cannot; empty if it can.
  const std::string& obstacle() const { return obstacle_; }
  // Whether loads may have been changed since that point: by a function that has not returned.
  bool is_behind() const { return changed_in_event_; }
  // Whether the last run failed: there is nothing behind it to go on with.
  bool has_failed() const { return has_failed_; }

 private:
  struct Known {
    std::string name;
    Replayed how = Replayed::tells;
  };
  struct Scope;

  int record(lua_State* L, const Known& known, lua_CFunction function);
  int finish_record(lua_State* L, const Known& known, const std::function<int()>& work);
  int replay(lua_State* L, const Known& known, lua_CFunction function);
  int replay_run(lua_State* L, const Known& known, lua_CFunction function);
  int go_on(lua_State* L, const Known& known, lua_CFunction function, const Aim& aim_before);
  void replay_event();
  void compare(lua_State* L, const Known& known);
  int outcome(lua_State* L);
  void go_live();
  void refuse(const std::string& what);
  void spoil(std::string why);
  void mark_safe();

  ReplayHost host_;
  std::unordered_map<const void*, Known> known_;
  std::vector<std::function<void()>> listeners_;
  JournalWriter writer_;
  std::optional<JournalReader> reader_;  // while it replays
  std::size_t safe_end_ = 0;
  std::string obstacle_;
  std::optional<Error> diverged_;
  bool quiet_ = false;  // what is called is the affair of a call that is kept
  bool running_ = false;
  int events_ = 0;
  bool changed_in_event_ = false;
  bool has_failed_ = false;
};

}  // namespace hackle
