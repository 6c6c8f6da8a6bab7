// SPDX-License-Identifier: MIT
// What a script asked of its simulations and what it was told, in order: with it the script can be
// run again up to that point without computing.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "solver/time_point.hpp"

namespace hackle {

// Throws this where a journal does not have what is read: it is damaged, or the script does
// something else.
struct JournalMismatch : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A journal is bytes: entries of a kind (one letter) and members in little-endian order, whole
// numbers in groups of seven bits.
enum class JournalEntry : char {
  call = 'C',     // of a function: its name, its arguments (see lua_values.hpp)
  done = 'D',     // it did what it does; replaying does it again
  values = 'V',   // it returned these
  failure = 'F',  // it threw this
  point = 'P',    // where the simulation then stood
  event = 'E',    // the engine called a function of the script: the number of its listener
  end = 'e',      // of that event
  thrown = 'x',   // the same, by an error
};

class JournalReader;

class JournalWriter {
 public:
  JournalWriter() = default;
  // Goes on behind what has been read.
  explicit JournalWriter(const JournalReader& read);

  void entry(JournalEntry kind) { bytes_ += static_cast<char>(kind); }
  void number(std::uint64_t value);
  void bits(double value);
  void text(std::string_view text);
  void point(const TimePoint& point);
  void failure(const Error& error);
  // What another writer has written.
  void raw(std::string_view bytes) { bytes_ += bytes; }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
  TimePoint last_;  // points are written as what is new in them
};

class JournalReader {
 public:
  explicit JournalReader(std::string bytes) : bytes_(std::move(bytes)) {}

  bool at_end() const { return next_ == bytes_.size(); }
  // Returns the kind of the next entry without passing it. Throws JournalMismatch at the end.
  JournalEntry peek() const;
  JournalEntry entry();
  // Passes an entry of that kind.
  void expect(JournalEntry kind);
  std::uint64_t number();
  double bits();
  std::string text();
  TimePoint point();
  Error failure();
  const std::string& bytes() const { return bytes_; }
  const TimePoint& last() const { return last_; }

 private:
  std::string_view take(std::uint64_t count);

  std::string bytes_;
  std::size_t next_ = 0;
  TimePoint last_;
};

}  // namespace hackle
