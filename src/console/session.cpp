// SPDX-License-Identifier: MIT
#include "console/session.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/files.hpp"
#include "base/machine.hpp"
#include "base/terminal.hpp"
#include "base/units.hpp"
#include "base/version.hpp"
#include "console/language/override_keys.hpp"
#include "output/picture/picture.hpp"
#include "store/checkpoint.hpp"

namespace hackle {
namespace fs = std::filesystem;
namespace {

// The first call of a rank is that of the program.
std::string name_of_call(const std::map<std::string, std::string>& overrides) {
  std::string text = "hackle";
  for (const auto& [key, value] : overrides) text += fmt::format(" --set {}={}", key, value);
  return text;
}

bool works(const std::shared_ptr<Run>& run) {
  return run && run->under_way() && !run->paused();
}

}  // namespace

Session::Session(ConsoleSettings with)
    : settings(std::move(with)), memory_at_start_(available_memory()) {
  if (settings.execution.ranks != nullptr) {
    call_watch_.emplace(*settings.execution.ranks);
    call_watch_->note(name_of_call(settings.overrides), {});
  }
  names->rehearses = settings.purpose != Purpose::results;
}

Session::~Session() = default;

void Session::take_folder() {
  if (!folder || settings.purpose != Purpose::results) return;
  const std::string remark = folder->take();
  settings.output_folder = folder->path();
  if (remark.empty() || settings.talk == Talk::quiet) return;
  if (make_room) make_room();
  say_note(remark);
}

fs::path Session::output_path(const std::string& who, const fs::path& name) {
  take_folder();
  fs::path path = settings.output_folder / name;
  sandbox().check_output(who, path);
  return path;
}

fs::path Session::input_path(const std::string& who, const fs::path& name) const {
  std::error_code ignored;
  const bool named = std::ranges::find(arguments, name.string()) != arguments.end();
  if (named && fs::is_regular_file(name, ignored)) return name;
  fs::path path = script_folder() / name;
  if (!fs::exists(path, ignored)) {
    const fs::path written = leading_folder() / name;
    if (fs::exists(written, ignored)) path = written;
  }
  sandbox().check_input(who, path);
  return path;
}

// Of several ranks, that of the one which writes files, once it has come here too.
fs::path Session::leading_folder() const {
  Ranks* ranks = settings.execution.ranks;
  if (ranks == nullptr) return settings.output_folder;
  std::string path = fs::absolute(settings.output_folder).string();
  ranks->share(path);
  if (ranks->leads()) return settings.output_folder;
  leading_folder_ = path;
  return leading_folder_;
}

fs::path Session::written_path(const std::string& who, const fs::path& name) const {
  fs::path path = leading_folder() / name;
  sandbox().check_input(who, path);
  return path;
}

fs::path Session::claim(const std::string& who, const fs::path& name, FileKind kind) {
  fs::path path = output_path(who, name);
  names->claim_checked(who, path, kind);
  return path;
}

fs::path Session::write_picture(const std::string& who, const fs::path& name,
                                const std::function<void(const fs::path&)>& write) {
  fs::path path = claim(who, name, FileKind::picture);
  if (settings.purpose != Purpose::results || settings.no_pictures) return path;
  make_folder_of(path);
  write(path);
  return path;
}

fs::path Session::script_folder() const {
  return fs::path(origin.script_name).parent_path();
}

Sandbox Session::sandbox() const {
  std::vector<fs::path> readable{script_folder(), settings.output_folder};
  if (!leading_folder_.empty()) readable.push_back(leading_folder_);
  for (const char* folder : {"assets", "scripts"})
    if (const auto path = find_data_file(folder)) readable.push_back(*path);
  return {std::move(readable), settings.output_folder, settings.trust};
}

std::shared_ptr<Run> Session::simulate(Plate plate, Numerics numerics) {
  return begin(
      std::make_shared<Run>(std::move(plate), numerics, settings.execution, settings.talk, origin));
}

Run* Session::run_of(int number) const {
  const auto k = static_cast<std::size_t>(number) - 1;
  return k < entries_.size() ? entries_[k].run.get() : nullptr;
}

ScriptHost Session::script_host() {
  ReplayHost all = objects;
  all.number_of = [this](const Run& run) { return number_of(run); };
  all.run = [this](int number) { return run_of(number); };
  if (call_watch_)
    all.note = [this](const std::string& call, const std::string& values, bool steps) {
      call_watch_->note(call, values);
      if (steps) call_watch_->compare();
    };
  return {
      .inputs = folder->inputs(),
      .origin = origin,
      .talk = settings.talk,
      .folder =
          [this] {
            take_folder();
            return settings.output_folder;
          },
      .claim =
          [this](const fs::path& name) { return claim("checkpoint", name, FileKind::checkpoint); },
      .count = [this] { return static_cast<int>(entries_.size()); },
      .ranks = settings.execution.ranks,
      .summary =
          [this](int number) {
            const auto& entry = entries_[static_cast<std::size_t>(number) - 1];
            return entry.summary ? to_json(*entry.summary).dump() : std::string();
          },
      .objects = std::move(all)};
}

std::optional<Found> Session::find_unfinished() {
  const std::optional<fs::path> place = folder->unfinished();
  if (!place) return std::nullopt;
  take_folder();  // which nobody else has
  std::vector<std::string> damaged;
  std::optional<Found> found = find_continuation(*place, folder->inputs().script, damaged);
  if (settings.talk != Talk::quiet)
    for (const std::string& problem : damaged) say_note(problem);
  return found;
}

// All ranks go on with what rank 0 has found.
std::optional<Found> Session::found_by_first(std::optional<Found> found) const {
  Ranks* ranks = settings.execution.ranks;
  if (ranks == nullptr) return found;
  std::string path = found ? fs::absolute(found->checkpoint).string() : std::string();
  ranks->share(path);
  if (ranks->leads()) return found;
  if (path.empty()) return std::nullopt;
  return Found{path, continuation_of(read_continuation(path), path)};
}

// Of scripts alone: at a prompt a simulation outlives its failures.
void Session::begin_checkpoints() {
  if (!folder || settings.purpose != Purpose::results || settings.checkpoint_every <= 0.0) return;
  folder->clear = [script = folder->inputs().script](const fs::path& place) {
    std::error_code ignored;
    for (const fs::path& file : automatic_checkpoints(place, script)) fs::remove(file, ignored);
  };
  std::optional<Found> found = found_by_first(find_unfinished());
  checkpoints = std::make_unique<ScriptCheckpoints>(script_host());
  if (!found) return;
  const Continuation& former = found->continuation;
  const bool same =
      former.origin.script_text == origin.script_text && former.inputs == folder->inputs();
  if (same && !settings.fresh && former.obstacle.empty())
    return checkpoints->continue_from(std::move(*found));
  checkpoints->set_aside();
  if (settings.talk != Talk::quiet && !settings.fresh)
    say_note(
        fmt::format("'{}' has an unfinished run {}; it is made anew, and the state of that "
                    "one kept as {}.former.ckpt",
                    settings.output_folder.string(),
                    same ? fmt::format("that cannot be continued ({})", former.obstacle)
                         : "of an earlier version of this script, or with other options",
                    folder->inputs().script));
}

void Session::continue_from(Found found) {
  checkpoints = std::make_unique<ScriptCheckpoints>(script_host());
  take_folder();
  checkpoints->continue_from(std::move(found));
}

std::shared_ptr<Run> Session::resume(const fs::path& path) {
  Checkpoint checkpoint = read_checkpoint(path);
  return begin(std::make_shared<Run>(hackle::resume(std::move(checkpoint), settings.execution),
                                     settings.talk, origin));
}

std::shared_ptr<Run> Session::begin(std::shared_ptr<Run> run) {
  run->limit_output(settings.output_limit);
  run->share_names(names);
  if (settings.sample_at) run->sample_at(*settings.sample_at);
  return adopt(std::move(run));
}

std::shared_ptr<Run> Session::adopt(std::shared_ptr<Run> run) {
  if (settings.purpose == Purpose::check) run->rehearse();
  if (checkpoints)
    checkpoints->keep(*run, static_cast<int>(entries_.size()) + 1, settings.checkpoint_every);
  entries_.push_back({run, std::nullopt, std::nullopt, run->simulation().state().step, false});
  return run;
}

std::shared_ptr<Recording> Session::open_recording(const fs::path& path) {
  std::erase_if(recordings_, [](const auto& recording) { return recording.expired(); });
  check_memory("recording", 0);
  auto recording = std::make_shared<Recording>(path);
  recordings_.push_back(recording);
  return recording;
}

std::uint64_t Session::memory_left() const {
  std::uint64_t held = 0;
  const auto add = [&held](const auto& solved_or_recorded) {
    held += solved_or_recorded.bytes() + PlateMemory().grown(solved_or_recorded.plate());
  };
  for (const auto& run : open_runs()) add(run->simulation());
  for (const auto& recording : recordings_)
    if (const auto open = recording.lock()) add(*open);
  return std::min(memory_at_start_ - std::min(held, memory_at_start_), available_memory());
}

void Session::check_memory(const std::string& who, std::uint64_t bytes) const {
  const std::uint64_t left = memory_left();
  if (bytes < left) return;
  throw Error(ErrorKind::run_failed,
              fmt::format("{}: out of memory: {} are left, the simulations of this script hold "
                          "the rest",
                          who, quantity(static_cast<double>(left), "B")),
              "release some: set the variables that hold them to nil");
}

int Session::number_of(const Run& run) const {
  const auto entry = std::ranges::find(entries_, &run, [](const Entry& e) { return e.run.get(); });
  return static_cast<int>(entry - entries_.begin()) + 1;
}

bool Session::is_working() const {
  return std::ranges::any_of(entries_, works, &Entry::run);
}

// Returns a copy: functions of a script called meanwhile may make and release simulations.
std::vector<std::shared_ptr<Run>> Session::open_runs() const {
  std::vector<std::shared_ptr<Run>> runs;
  for (const Entry& entry : entries_)
    if (entry.run) runs.push_back(entry.run);
  return runs;
}

std::vector<int> Session::work(double seconds) {
  std::vector<std::shared_ptr<Run>> runs = open_runs();
  std::erase_if(runs, std::not_fn(works));
  std::vector<int> arrived;
  for (const auto& run : runs) {
    const int number = number_of(*run);
    try {
      run->go_on(seconds / static_cast<double>(runs.size()));
    } catch (const Error&) {
      entries_[static_cast<std::size_t>(number) - 1].has_failed = true;
      throw;
    }
    if (!run->under_way()) arrived.push_back(number);
  }
  return arrived;
}

void Session::finish_work() {
  if (checkpoints) checkpoints->finish();
  for (const auto& run : open_runs())
    if (run->under_way()) run->wait();
}

void Session::pause_work() {
  for (const auto& run : open_runs())
    if (works(run)) run->pause();
}

void Session::begin_line(const Transcript::Chunk& chunk) {
  has_prompt_ = true;
  names->replaces_complete = true;
  ++said;
  for (Entry& entry : entries_) {
    if (!entry.run) continue;
    const Simulation& simulation = entry.run->simulation();
    if (simulation.state().step != entry.noted_step || entry.has_failed)
      transcript_.went_on(number_of(*entry.run), simulation.state().step, simulation.time(),
                          entry.has_failed);
    entry.has_failed = false;
  }
  origin.script_text = transcript_.text() + chunk.text + "\n";
}

void Session::end_line(const Transcript::Chunk& chunk, Transcript::Outcome outcome) {
  for (Entry& entry : entries_) {
    if (!entry.run) continue;
    const std::optional<std::int64_t> interrupt = entry.run->take_interrupt();
    if (interrupt && outcome == Transcript::Outcome::interrupted)
      transcript_.interrupted(number_of(*entry.run), *interrupt);
    entry.noted_step = entry.run->simulation().state().step;
    if (!entry.run->under_way()) entry.run->judge();
  }
  transcript_.typed(chunk, outcome);
}

std::string Session::script() const {
  if (!has_prompt_) return origin.script_text;
  std::string text = fmt::format(
      "-- Typed at the prompt of Hackle {}. Does the same again, to the bit.\n", version());
  text += transcript_.text();
  for (const auto& run : open_runs()) {
    const int number = number_of(*run);
    if (run->under_way()) text += fmt::format("simulations()[{}]:stop()\n", number);
    text += fmt::format("-- simulation {}: {} steps, hash {}\n", number,
                        run->simulation().state().step, run->simulation().state().hash());
  }
  return text;
}

void Session::retire(const Run* run) noexcept {
  const auto entry = std::ranges::find(entries_, run, [](const Entry& e) { return e.run.get(); });
  if (entry == entries_.end()) return;
  close(*entry->run);
  try {
    entry->summary = entry->run->summary();
    if (checkpoints) {
      checkpoints->let_go(*run);
      entry->summary->told = checkpoints->told(number_of(*run));
    }
    if (settings.purpose == Purpose::check) entry->rehearsal = entry->run->rehearsal();
  } catch (const std::exception& error) {
    closing_problems_.push_back({error.what(), {}});
  }
  entry->run.reset();
}

// The last simulation may be closed before others.
void Session::paint_last(Run& run) {
  const int number = number_of(run);
  if (settings.last_picture.empty() || settings.purpose != Purpose::results || number <= painted_)
    return;
  painted_ = number;
  run.frame(settings.last_picture, {});
}

void Session::close(Run& run) noexcept {
  try {
    run.close();
    paint_last(run);
  } catch (const Error& error) {
    closing_kind_ = error.kind();
    for (const Problem& problem : error.problems()) closing_problems_.push_back(problem);
  } catch (const std::exception& error) {
    closing_kind_ = ErrorKind::run_failed;
    closing_problems_.push_back({error.what(), {}});
  }
}

void Session::close_all() {
  for (const Entry& entry : entries_)
    if (entry.run) close(*entry.run);
  const std::vector<Problem> problems = std::exchange(closing_problems_, {});
  if (!problems.empty()) throw Error(closing_kind_, problems);
}

std::vector<Summary> Session::summaries() const {
  std::vector<Summary> list;
  for (const Entry& entry : entries_)
    if (entry.run || entry.summary)
      list.push_back(entry.run ? entry.run->summary() : *entry.summary);
  return list;
}

std::vector<Rehearsal> Session::rehearsals() const {
  std::vector<Rehearsal> list;
  for (const Entry& entry : entries_)
    if (entry.run || entry.rehearsal)
      list.push_back(entry.run ? entry.run->rehearsal() : *entry.rehearsal);
  return list;
}

void Session::settle_expectations() {
  for (std::size_t k = 0; k < expectations.size(); ++k)
    if (const auto settle = std::exchange(expectations[k].settle, nullptr)) {
      Expectation settled = settle();
      expectations[k].expectation = std::move(settled);
    }
}

const Materials& Session::materials() {
  if (!materials_) materials_.emplace(data_file("assets/materials.lua"));
  return *materials_;
}

void Session::leave(int code) {
  exit_code = code;
  throw Error(ErrorKind::interrupted, "os.exit");
}

void Session::check_overrides_used() const {
  Problems problems;
  for (const auto& [key, value] : settings.overrides)
    if (!declared_options.contains(key) && !is_of_language(key))
      problems.add(fmt::format("--set {}={}: the script has no options to set", key, value),
                   fmt::format("declare them in it: local o = options {{ {} = ... }}", key));
  problems.throw_if_any();
}

}  // namespace hackle
