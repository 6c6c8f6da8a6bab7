// SPDX-License-Identifier: MIT
// The processes that solve one plate together, each on a part of it. All of them run the same
// script and make the same calls in the same order: every function here is one that all ranks call.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace hackle {

// Bytes on their way to a rank, and the place for those that a rank sends.
struct Outgoing {
  int to = 0;
  std::span<const std::byte> bytes;
};
struct Incoming {
  int from = 0;
  std::span<std::byte> bytes;
};

// What went through since the start, of this rank alone.
struct Traffic {
  std::int64_t messages = 0;  // sent, and collective calls
  std::int64_t bytes = 0;     // given to them
};

// What every rank gave, in the order of the ranks.
struct Gathered {
  std::vector<std::byte> bytes;
  std::vector<std::size_t> begins;  // of the part of each rank, then the end of the last

  template <class T>
  std::vector<T> as() const {
    static_assert(std::is_trivially_copyable_v<T>);
    const auto* first = reinterpret_cast<const T*>(bytes.data());
    return {first, first + bytes.size() / sizeof(T)};
  }
};

// Failures of the network end all ranks; nothing here throws.
class Ranks {
 public:
  virtual ~Ranks() = default;

  virtual int rank() const = 0;   // of this process, from 0
  virtual int count() const = 0;  // at least 1

  // Sends and receives meanwhile, until end_exchange() returns. Neither what is sent may be changed
  // nor what is received be read before. Messages from one rank to another arrive in the order in
  // which both name them.
  virtual void begin_exchange(std::span<const Outgoing> sent,
                              std::span<const Incoming> received) = 0;
  virtual void end_exchange() = 0;

  // Returns what every rank gave.
  virtual Gathered gather(std::span<const std::byte> own) = 0;
  // Completes an array of rows on every rank: rank k has the rows begins[k] to begins[k + 1], each
  // of `row_bytes`.
  virtual void complete(std::span<std::byte> array, std::size_t row_bytes,
                        std::span<const int> begins) = 0;
  // Returns the bits that some rank has set.
  virtual std::uint64_t any(std::uint64_t bits) = 0;
  // Gives every rank the text of rank 0.
  virtual void share(std::string& text) = 0;
  // Waits until every rank has come here, at most for so many seconds. Returns whether all have.
  // The last call of a program.
  virtual bool meet(double seconds) = 0;
  // Says the text on stderr, and ends all ranks at once.
  [[noreturn]] virtual void end_all(int exit_code, const std::string& text) = 0;

  virtual Traffic traffic() const = 0;

  bool leads() const { return rank() == 0; }
};

template <class T>
std::span<const std::byte> bytes_to_send(const std::vector<T>& values) {
  static_assert(std::is_trivially_copyable_v<T>);
  return std::as_bytes(std::span(values));
}

}  // namespace hackle
