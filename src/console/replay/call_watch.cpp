// SPDX-License-Identifier: MIT
#include "console/replay/call_watch.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/hash.hpp"

namespace hackle {
namespace {

constexpr std::size_t kept = 256;  // calls by which two ranks may be told apart

struct Standing {
  std::uint64_t count;
  std::uint64_t digest;
  bool operator==(const Standing&) const = default;
};

std::uint64_t digest_of(std::uint64_t before, const std::string& text) {
  return std::hash<std::string>()(fmt::format("{} {}", before, text));
}

// The digests of the last calls of every rank: the number of its calls, then those of the last.
class Histories {
 public:
  explicit Histories(const Gathered& gathered)
      : numbers_(gathered.as<std::uint64_t>()), begins_(gathered.begins) {}

  // A call by which a rank differs from rank 0.
  struct Difference {
    std::uint64_t call = std::numeric_limits<std::uint64_t>::max();
    int rank = 0;
  };
  // Returns the first one.
  Difference first_difference() const {
    Difference first;
    for (int rank = 1; rank + 1 < static_cast<int>(begins_.size()); ++rank) {
      const std::uint64_t call = first_difference(of(0), of(rank));
      if (call < first.call) first = {call, rank};
    }
    return first;
  }

 private:
  using History = std::span<const std::uint64_t>;

  History of(int rank) const {
    const auto begin = begins_[static_cast<std::size_t>(rank)] / sizeof(std::uint64_t);
    const auto end = begins_[static_cast<std::size_t>(rank) + 1] / sizeof(std::uint64_t);
    return History(numbers_).subspan(begin, end - begin);
  }
  static std::uint64_t first_known(History history) { return history[0] - (history.size() - 1); }
  static std::uint64_t digest(History history, std::uint64_t call) {
    const bool known = call >= first_known(history) && call < history[0];
    return known ? history[1 + call - first_known(history)] : 0;
  }
  static std::uint64_t first_difference(History one, History other) {
    const std::uint64_t end = std::max(one[0], other[0]);
    std::uint64_t call = std::max(first_known(one), first_known(other));
    while (call < end && digest(one, call) == digest(other, call)) ++call;
    return call < end ? call : std::numeric_limits<std::uint64_t>::max();
  }

  std::vector<std::uint64_t> numbers_;
  std::vector<std::size_t> begins_;
};

}  // namespace

void CallWatch::note(std::string call, const std::string& values) {
  const std::uint64_t before = last_.empty() ? 0 : last_.back().digest;
  const std::uint64_t digest = digest_of(before, call + values);
  last_.push_back({std::move(call), digest});
  if (last_.size() > kept) last_.pop_front();
  ++count_;
}

void CallWatch::compare() {
  const std::vector<Standing> own{{count_, last_.empty() ? 0 : last_.back().digest}};
  const auto all = ranks_.gather(bytes_to_send(own)).as<Standing>();
  if (!std::ranges::all_of(all, [&](const Standing& one) { return one == all.front(); })) tell();
}

std::string CallWatch::text_of(std::uint64_t call) const {
  const std::uint64_t first = count_ - last_.size();
  if (call < first) return "something else, too long ago to tell";
  return call < count_ ? last_[call - first].text : "nothing more";
}

// Call 0 is that of the program.
void CallWatch::tell() {
  std::vector<std::uint64_t> own{count_};
  for (const Call& call : last_) own.push_back(call.digest);
  const auto [call, stray] = Histories(ranks_.gather(bytes_to_send(own))).first_difference();
  const std::string mine = text_of(call);
  const Gathered texts = ranks_.gather(std::as_bytes(std::span(mine)));
  const auto text = [&](int rank) {
    const auto k = static_cast<std::size_t>(rank);
    const auto* all = reinterpret_cast<const char*>(texts.bytes.data());
    return std::string(all + texts.begins[k], all + texts.begins[k + 1]);
  };
  throw Error(ErrorKind::run_failed,
              fmt::format("the ranks have diverged at call {} of the script: rank 0 calls {}, rank "
                          "{} {}",
                          call, text(0), stray, text(stray)),
              "a clock, a file or chance decides in the script");
}

}  // namespace hackle
