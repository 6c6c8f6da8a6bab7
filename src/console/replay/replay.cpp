// SPDX-License-Identifier: MIT
#include "console/replay/replay.hpp"

#include <exception>
#include <utility>

#include <fmt/format.h>

#include "base/interrupt.hpp"
#include "console/lua/value_text.hpp"
#include "solver/simulation.hpp"

namespace hackle {
namespace {

constexpr std::size_t max_journal = std::size_t{64} << 20U;  // bytes

bool advances(Replayed how) {
  return how == Replayed::runs || how == Replayed::advances;
}

}  // namespace

// While it lives, calls within a call are not kept.
struct Replay::Scope {
  Scope(Replay& replay, Replayed how)
      : of(replay),
        quiet_before(std::exchange(replay.quiet_, true)),
        running_before(std::exchange(replay.running_, advances(how))) {}
  ~Scope() {
    of.quiet_ = quiet_before;
    of.running_ = running_before;
  }
  Scope(const Scope&) = delete;
  Scope& operator=(const Scope&) = delete;

  Replay& of;
  bool quiet_before, running_before;
};

void Replay::begin_with(std::string journal) {
  reader_.emplace(std::move(journal));
}

void Replay::know(const TypeDoc& type) {
  for (const Function& method : type.methods) know(method);
  for (const Property& field : type.fields)
    known_[&field] = {fmt::format("s.{}", field.name), Replayed::tells};
}

void Replay::know(const Function& function) {
  known_[reinterpret_cast<const void*>(function.call)] = {call_name(*function.doc),
                                                          function.replayed};
}

int Replay::call(lua_State* L, const void* what, lua_CFunction function) {
  const auto known = known_.find(what);
  if (known == known_.end() || known->second.how == Replayed::outside) return function(L);
  if (advances(known->second.how) && host_.run_at(L, 1) == nullptr) return function(L);  // throws
  if (diverged_) throw Error(*diverged_);
  if (quiet_) {
    if (running_)
      spoil(fmt::format("a function of place or time asked for {}", known->second.name));
    return function(L);
  }
  if (!reader_) return record(L, known->second, function);
  if (reader_->at_end()) {
    go_live();
    return record(L, known->second, function);
  }
  try {
    return replay(L, known->second, function);
  } catch (const JournalMismatch& mismatch) {
    refuse(fmt::format("at {}: {}", known->second.name, mismatch.what()));
  }
  return 0;
}

// What a person may read of a call.
std::string call_text(lua_State* L, const std::string& name) {
  std::string text = name + "(";
  for (int index = 2; index <= lua_gettop(L); ++index) {
    const bool plain = lua_type(L, index) == LUA_TNUMBER || lua_type(L, index) == LUA_TSTRING;
    text += fmt::format("{}{}", index > 2 ? ", " : "", plain ? value_text(L, index) : "...");
  }
  return text + ")";
}

int Replay::record(lua_State* L, const Known& known, lua_CFunction function) {
  writer_.entry(JournalEntry::call);
  const std::string values = texts_of(L, 1, lua_gettop(L), host_.name);
  writer_.text(known.name);
  writer_.text(values);
  if (host_.note) host_.note(call_text(L, known.name), values, advances(known.how));
  if (advances(known.how)) {
    writer_.point(host_.run_at(L, 1)->simulation().time_point());
    mark_safe();
  }
  if (events_ > 0 && known.how == Replayed::declares) changed_in_event_ = true;
  return finish_record(L, known, [&] { return function(L); });
}

// Keeps what comes of the work of a call.
int Replay::finish_record(lua_State* L, const Known& known, const std::function<int()>& work) {
  const Run* run = advances(known.how) ? host_.run_at(L, 1) : nullptr;
  const auto keep_point = [&] {
    if (run == nullptr) return;
    writer_.entry(JournalEntry::point);
    writer_.point(run->simulation().time_point());
  };
  int count = 0;
  try {
    const Scope scope(*this, known.how);
    count = work();
  } catch (const Error& error) {
    has_failed_ = run != nullptr;
    if (error.kind() == ErrorKind::interrupted && interrupted()) throw;  // the call is open
    keep_point();
    writer_.entry(JournalEntry::failure);
    writer_.failure(error);
    mark_safe();
    throw;
  } catch (...) {  // of Lua itself
    spoil(fmt::format("{} failed in Lua", known.name));
    throw;
  }
  keep_point();
  const int top = lua_gettop(L);
  const bool tells = known.how != Replayed::declares && known.how != Replayed::hands;
  writer_.entry(tells ? JournalEntry::values : JournalEntry::done);
  if (tells && !write_values(L, top - count + 1, top, writer_))
    spoil(fmt::format("{} returned an object", known.name));
  has_failed_ = false;
  mark_safe();
  return count;
}

void Replay::mark_safe() {
  if (events_ > 0) return;
  safe_end_ = writer_.bytes().size();
  if (safe_end_ > max_journal) spoil("the script asked for too much");
}

void Replay::spoil(std::string why) {
  if (obstacle_.empty()) obstacle_ = std::move(why);
}

int Replay::replay(lua_State* L, const Known& known, lua_CFunction function) {
  compare(L, known);
  if (advances(known.how)) return replay_run(L, known, function);
  if (known.how == Replayed::tells) return outcome(L);
  if (known.how == Replayed::hands && reader_->peek() == JournalEntry::failure) return outcome(L);
  if (known.how == Replayed::hands) {
    reader_->expect(JournalEntry::done);
    host_.push_empty(L, known.name);
    return 1;
  }
  int count = 0;
  try {
    const Scope scope(*this, known.how);
    count = function(L);
  } catch (const Error&) {
    if (reader_->peek() == JournalEntry::failure) outcome(L);
    throw;
  }
  reader_->expect(JournalEntry::done);
  return count;
}

void Replay::compare(lua_State* L, const Known& known) {
  reader_->expect(JournalEntry::call);
  const std::string name = reader_->text(), given = reader_->text();
  if (name != known.name) throw JournalMismatch(fmt::format("there it called {}", name));
  if (given != texts_of(L, 1, lua_gettop(L), host_.name))
    throw JournalMismatch("there it had other arguments");
}

// Returns the values that the call returned, or throws what it threw.
int Replay::outcome(lua_State* L) {
  const JournalEntry kind = reader_->entry();
  if (kind == JournalEntry::failure) throw Error(reader_->failure());
  if (kind != JournalEntry::values) throw JournalMismatch("its outcome is missing");
  return push_values(L, *reader_);
}

int Replay::replay_run(lua_State* L, const Known& known, lua_CFunction function) {
  Run& run = *host_.run_at(L, 1);
  const Aim before = reader_->point().aim;
  while (!reader_->at_end() && reader_->peek() == JournalEntry::event) replay_event();
  if (reader_->at_end()) {
    go_live();
    return go_on(L, known, function, before);
  }
  reader_->expect(JournalEntry::point);
  run.pretend(reader_->point());
  return outcome(L);
}

// The call was interrupted: goes on with what it had begun.
int Replay::go_on(lua_State* L, const Known& known, lua_CFunction function, const Aim& aim_before) {
  Run& run = *host_.run_at(L, 1);
  const Aim aim = run.simulation().time_point().aim;
  const bool has_aimed =
      aim.end_time != aim_before.end_time || aim.last_step != aim_before.last_step;
  return finish_record(L, known, [&] {
    if (known.how != Replayed::runs || !has_aimed) return function(L);
    run.go_on_to_aim();
    return 0;
  });
}

void Replay::replay_event() {
  reader_->expect(JournalEntry::event);
  const std::uint64_t listener = reader_->number();
  Run* run = host_.run(static_cast<int>(reader_->number()));
  if (listener >= listeners_.size() || run == nullptr)
    throw JournalMismatch("a function was called that is not there");
  run->pretend(reader_->point());
  try {
    listeners_[listener]();
  } catch (const Error&) {
    if (diverged_) throw;
    return reader_->expect(JournalEntry::thrown);
  }
  reader_->expect(JournalEntry::end);
}

void Replay::go_live() {
  try {
    host_.go_live();
  } catch (const Error& error) {
    diverged_ = error;
    throw;
  }
  writer_ = JournalWriter(*reader_);
  safe_end_ = writer_.bytes().size();
  reader_.reset();
}

void Replay::refuse(const std::string& what) {
  diverged_.emplace(ErrorKind::refused,
                    fmt::format("the script does not do again what it did in the run that it is "
                                "to continue: {}",
                                what),
                    "a clock, a file or chance decides in it; --fresh starts anew");
  throw Error(*diverged_);
}

std::uint64_t Replay::enlist(std::function<void()> again) {
  listeners_.push_back(std::move(again));
  return listeners_.size() - 1;
}

Replay::Event::Event(Replay& replay, std::uint64_t listener, const Run& run)
    : replay_(replay),
      quiet_before_(std::exchange(replay.quiet_, false)),
      exceptions_(std::uncaught_exceptions()) {
  if (replay_.reader_) return;
  ++replay_.events_;
  replay_.changed_in_event_ = false;
  replay_.writer_.entry(JournalEntry::event);
  replay_.writer_.number(listener);
  replay_.writer_.number(static_cast<std::uint64_t>(replay_.host_.number_of(run)));
  replay_.writer_.point(run.simulation().time_point());
}

Replay::Event::~Event() {
  replay_.quiet_ = quiet_before_;
  if (replay_.reader_) return;
  const bool threw = std::uncaught_exceptions() > exceptions_;
  replay_.writer_.entry(threw ? JournalEntry::thrown : JournalEntry::end);
  --replay_.events_;
  replay_.has_failed_ = threw;
  if (threw) return;
  replay_.changed_in_event_ = false;
  replay_.mark_safe();
}

void Replay::finish() {
  if (diverged_) throw Error(*diverged_);
  if (!reader_) return;
  try {
    while (!reader_->at_end() && reader_->peek() == JournalEntry::event) replay_event();
    if (!reader_->at_end()) throw JournalMismatch("there it went on");
  } catch (const JournalMismatch& mismatch) {
    refuse(fmt::format("at its end: {}", mismatch.what()));
  }
  go_live();
}

}  // namespace hackle
