// SPDX-License-Identifier: MIT
#include "console/replay/journal.hpp"

#include <bit>
#include <cstring>

namespace hackle {
namespace {

constexpr unsigned group = 7;
constexpr std::uint64_t more = 0x80;

// What is new in a point: the clock, the aim, or a time that is not that of the step.
enum News : std::uint64_t { nothing = 0, clock = 1, aim = 2, time_seen = 4 };

bool same(const Aim& one, const Aim& other) {
  return one.end_time == other.end_time && one.last_step == other.last_step;
}

}  // namespace

JournalWriter::JournalWriter(const JournalReader& read) : bytes_(read.bytes()), last_(read.last()) {
}

void JournalWriter::number(std::uint64_t value) {
  for (; value >= more; value >>= group) bytes_ += static_cast<char>(value | more);
  bytes_ += static_cast<char>(value);
}

void JournalWriter::bits(double value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes_.append(raw, sizeof value);
}

void JournalWriter::text(std::string_view text) {
  number(text.size());
  bytes_ += text;
}

void JournalWriter::point(const TimePoint& point) {
  std::uint64_t news = time_seen;
  if (!(point.clock == last_.clock)) news |= clock;
  if (!same(point.aim, last_.aim)) news |= aim;
  number(news);
  number(static_cast<std::uint64_t>(point.step));
  bits(point.time);
  if ((news & clock) != 0) {
    bits(point.clock.moment);
    number(static_cast<std::uint64_t>(point.clock.since));
  }
  if ((news & aim) != 0) {
    bits(point.aim.end_time);
    number(static_cast<std::uint64_t>(point.aim.last_step));
  }
  last_ = point;
}

void JournalWriter::failure(const Error& error) {
  number(static_cast<std::uint64_t>(error.kind()));
  number(error.problems().size());
  for (const Problem& problem : error.problems()) {
    text(problem.what);
    text(problem.remedy);
  }
}

std::string_view JournalReader::take(std::uint64_t count) {
  if (count > bytes_.size() - next_) throw JournalMismatch("it ends early");
  const std::string_view taken = std::string_view(bytes_).substr(next_, count);
  next_ += count;
  return taken;
}

JournalEntry JournalReader::peek() const {
  if (at_end()) throw JournalMismatch("it ends early");
  return static_cast<JournalEntry>(bytes_[next_]);
}

JournalEntry JournalReader::entry() {
  return static_cast<JournalEntry>(take(1).front());
}

void JournalReader::expect(JournalEntry kind) {
  if (peek() != kind) throw JournalMismatch("something else follows there");
  ++next_;
}

std::uint64_t JournalReader::number() {
  std::uint64_t value = 0;
  for (unsigned shift = 0; shift < 64; shift += group) {
    const auto byte = static_cast<std::uint8_t>(take(1).front());
    value |= (byte & (more - 1)) << shift;
    if ((byte & more) == 0) return value;
  }
  throw JournalMismatch("a number is too long");
}

double JournalReader::bits() {
  double value = 0.0;
  std::memcpy(&value, take(sizeof value).data(), sizeof value);
  return value;
}

std::string JournalReader::text() {
  return std::string(take(number()));
}

TimePoint JournalReader::point() {
  const std::uint64_t news = number();
  TimePoint point = last_;
  point.step = static_cast<std::int64_t>(number());
  point.time = bits();
  if ((news & clock) != 0) point.clock = {bits(), static_cast<std::int64_t>(number())};
  if ((news & aim) != 0) point.aim = {bits(), static_cast<std::int64_t>(number())};
  return last_ = point;
}

Error JournalReader::failure() {
  const auto kind = static_cast<ErrorKind>(number());
  std::vector<Problem> problems;
  for (std::uint64_t count = number(); count > 0; --count) {
    std::string what = text();
    problems.push_back({std::move(what), text()});
  }
  return Error(kind, std::move(problems));
}

}  // namespace hackle
