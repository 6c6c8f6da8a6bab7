// SPDX-License-Identifier: MIT
#include "study/case_batch.hpp"

#include <algorithm>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "base/interrupt.hpp"
#include "base/terminal.hpp"

namespace hackle {
namespace {

using Json = nlohmann::ordered_json;
using Milliseconds = std::chrono::milliseconds;

constexpr Milliseconds pause_between_child_polls{2};
// Between looks at what other processes do; longer while nothing happens.
constexpr Milliseconds shortest_interval{10}, longest_interval{100};
constexpr std::size_t looks_while_full = 16;

// The error message of a program without what it says besides.
std::string last_error(const std::string& text) {
  const std::size_t at = text.find("error: ");
  std::string message = at == std::string::npos ? text : text.substr(at + 7);
  while (!message.empty() && message.back() == '\n') message.pop_back();
  return message.empty() ? "it ended without a word" : message;
}

Outcome outcome_of_child(const Case& one, const Provenance& made, const ChildResult& result) {
  Outcome outcome{.setting = one,
                  .exit_code = result.exit_code,
                  .wall = result.wall,
                  .cpu = result.cpu,
                  .peak_bytes = result.peak_bytes,
                  .made = made};
  if (result.timed_out) {
    outcome.state = CaseState::stopped;
    outcome.reason = fmt::format("stopped after {:.1f} s", result.wall);
    return outcome;
  }
  outcome.told = Json::parse(result.out, nullptr, false);
  const bool told = result.exit_code == 0 && outcome.told.is_object();
  outcome.state = told ? CaseState::finished : CaseState::failed;
  if (!told) {
    outcome.told = nullptr;
    outcome.reason = last_error(result.error);
  }
  return outcome;
}

}  // namespace

CaseBatch::CaseBatch(const CaseStore& store, const StudySession& session,
                     std::span<const Case> cases, BatchOptions options)
    : store_(&store),
      session_(&session),
      cases_(cases),
      options_(std::move(options)),
      outcomes_(cases.size()),
      next_look_(Clock::now()),
      interval_(shortest_interval) {
}

std::vector<Outcome> CaseBatch::run() {
  for (std::size_t k = 0; k < cases_.size(); ++k)
    if (!recall(k)) waiting_.push_back(k);
  all_ = waiting_.size();
  progress_.emplace(options_.talk);
  while (done_ < all_) {
    throw_if_interrupted();
    end_some();
    look_around();
    show();
    if (done_ < all_) pause();
  }
  progress_.reset();
  return std::move(outcomes_);
}

bool CaseBatch::recall(std::size_t number) {
  auto kept = store_->outcome_of(cases_[number], options_.time_limit);
  if (!kept || (options_.fresh && !session_->includes(kept->made))) return false;
  outcomes_[number] = *std::move(kept);
  return true;
}

// Returns whether the case no longer waits: it runs here, or its outcome has appeared.
bool CaseBatch::begin(std::size_t number) {
  const Case& one = cases_[number];
  Provenance made = provenance_now(session_->job());
  auto claim = CaseClaim::of(store_->lock_of(one), made, options_.must_lock);
  if (!claim) {
    elsewhere_ = number;
    return false;
  }
  // The process that had it may have ended since the last look.
  if (recall(number)) {
    ++done_;
    return true;
  }
  made.taken_over = claim->left_by().has_value();
  if (made.taken_over) note(*claim->left_by(), one);
  ChildProcess child(words_of(one), options_.time_limit, claim->descriptor());
  running_.push_back(Running{number, std::move(made), *std::move(claim), std::move(child)});
  return true;
}

// In order, because a study puts first what takes longest.
void CaseBatch::begin_some() {
  elsewhere_.reset();
  std::size_t at = 0;
  while (at < waiting_.size() && !is_full()) {
    const std::size_t number = waiting_[at];
    if (recall(number)) {
      ++done_;
    } else if (!begin(number)) {
      ++at;
      continue;
    }
    waiting_.erase(waiting_.begin() + static_cast<std::ptrdiff_t>(at));
  }
}

// While nothing can begin here, only progress is to know of what others have done.
void CaseBatch::look_for_outcomes() {
  for (std::size_t k = 0; k < looks_while_full && !waiting_.empty(); ++k) {
    if (cursor_ >= waiting_.size()) cursor_ = 0;
    if (recall(waiting_[cursor_])) {
      ++done_;
      waiting_.erase(waiting_.begin() + static_cast<std::ptrdiff_t>(cursor_));
    } else {
      ++cursor_;
    }
  }
}

void CaseBatch::look_around() {
  if (waiting_.empty() || Clock::now() < next_look_) return;
  const std::size_t before = waiting_.size();
  if (is_full())
    look_for_outcomes();
  else
    begin_some();
  const bool has_changed = waiting_.size() != before;
  interval_ = has_changed ? shortest_interval : std::min(2 * interval_, longest_interval);
  next_look_ = Clock::now() + interval_;
}

void CaseBatch::end_some() {
  std::vector<Running> still;
  for (Running& one : running_)
    if (const auto result = one.child.poll())
      end(one, *result);
    else
      still.push_back(std::move(one));
  running_.swap(still);
}

// The outcome of a program that was told to stop says nothing of its case.
void CaseBatch::end(Running& one, const ChildResult& result) {
  outcomes_[one.number] = outcome_of_child(cases_[one.number], one.made, result);
  const bool was_told_to_stop =
      interrupted() || result.exit_code == static_cast<int>(ErrorKind::interrupted);
  if (!was_told_to_stop) store_->keep(outcomes_[one.number], options_.time_limit);
  ++done_;
  next_look_ = Clock::now();
}

void CaseBatch::note(const Provenance& left_by, const Case& one) {
  if (!options_.notes) return;
  progress_.emplace(options_.talk);  // which clears its bar
  say_note(fmt::format("{} ended while it ran {}: {} runs it again", process_name(left_by),
                       name_of(one.settings), process_name(provenance_now(""))));
}

// Says whom this process waits for, if nothing runs here.
std::string CaseBatch::waits_for() const {
  if (!running_.empty() || !elsewhere_) return "";
  const auto holder = holder_in(store_->lock_of(cases_[*elsewhere_]));
  return holder ? fmt::format(", waiting for {}", process_name(*holder)) : "";
}

void CaseBatch::show() {
  const double fraction = static_cast<double>(done_) / static_cast<double>(all_);
  if (progress_->due(fraction))
    progress_->show(fraction,
                    fmt::format("{}: {} of {}{}", options_.what, done_, all_, waits_for()));
}

void CaseBatch::pause() const {
  std::this_thread::sleep_for(running_.empty() ? interval_ : pause_between_child_polls);
}

std::vector<std::string> CaseBatch::words_of(const Case& one) const {
  const StudyScript& script = store_->script();
  std::vector<std::string> words{
      script.program.string(), "run", script.path.string(), "--json", "--fresh", "--force",
      "--checkpoint",          "0s"};
  words.insert(words.end(),
               {"-j", std::to_string(options_.threads), "-o", store_->folder_of(one).string(),
                "--sample", fmt::format("{}", one.sample_at)});
  if (!one.with_pictures) words.emplace_back("--bare");
  if (one.with_last_picture)
    words.insert(words.end(), {"--picture", store_->picture_of(one).string()});
  for (const auto& [key, value] : joined(script.settings, one.settings))
    words.insert(words.end(), {"--set", fmt::format("{}={}", key, value)});
  if (!script.arguments.empty()) words.emplace_back("--");
  words.insert(words.end(), script.arguments.begin(), script.arguments.end());
  return words;
}

}  // namespace hackle
