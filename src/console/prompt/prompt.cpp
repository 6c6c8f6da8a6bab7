// SPDX-License-Identifier: MIT
#include "console/prompt/prompt.hpp"

#include <utility>

#include "base/interrupt.hpp"

namespace hackle {
namespace {

constexpr const char* first_prompt = "> ";
constexpr const char* next_prompt = ">> ";

}  // namespace

Prompt::Prompt(Console& console, Reader reader, Voice voice)
    : console_(console), reader_(std::move(reader)), voice_(std::move(voice)) {
}

int Prompt::run() {
  std::string chunk;
  while (!console_.exit_code() && !asked_to_leave() && read_chunk(chunk))
    if (!chunk.empty()) evaluate(chunk);
  return console_.exit_code().value_or(first_code_);
}

// Reads lines until they form a chunk; returns false at the end of the input.
bool Prompt::read_chunk(std::string& chunk) {
  chunk.clear();
  std::string line;
  for (;;) {
    begun_ = chunk.empty() ? "" : chunk + "\n";
    const LineEnd end = reader_(chunk.empty() ? first_prompt : next_prompt, line,
                                [this](const MakeRoom& make_room) { return work(make_room); });
    if (end == LineEnd::cleared) {
      if (chunk.empty() && line.empty()) pause_work();
      chunk.clear();
      continue;
    }
    // An unfinished chunk is still run, for its error.
    if (end == LineEnd::end_of_input) return !chunk.empty();
    chunk += chunk.empty() ? line : "\n" + line;
    if (!console_.is_incomplete(chunk)) return true;
  }
}

void Prompt::evaluate(const std::string& chunk) {
  const InterruptHandler handler;
  clear_interrupt();
  try {
    for (const std::string& value : console_.evaluate(chunk)) voice_.value(value);
  } catch (const Error& error) {
    tell(error);
  }
  clear_interrupt();
}

void Prompt::tell(const Error& error) {
  voice_.error(error);
  if (first_code_ == 0) first_code_ = static_cast<int>(error.kind());
}

// Works so briefly that a typing person notices nothing. Returns whether there is more to do.
bool Prompt::work(const MakeRoom& make_room) {
  constexpr double moment = 0.02;  // s
  try {
    for (const std::string& news : console_.work(moment, make_room)) {
      make_room();
      voice_.note(news);
    }
  } catch (const Error& error) {
    make_room();
    tell(error);
  }
  return console_.is_working();
}

void Prompt::pause_work() {
  if (!console_.is_working()) return;
  console_.pause_work();
  voice_.note("paused; s:resume() continues");
}

}  // namespace hackle
