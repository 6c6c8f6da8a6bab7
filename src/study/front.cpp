// SPDX-License-Identifier: MIT
#include "study/front.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hackle {
namespace {

bool beats(const Candidate& one, const Candidate& other) {
  return std::isfinite(one.error) && one.cost <= other.cost && one.error <= other.error &&
         (one.cost < other.cost || one.error < other.error);
}

}  // namespace

std::vector<bool> front_of(std::span<const Candidate> all) {
  std::vector<bool> on_front(all.size());
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto beaten = [&](const Candidate& other) {
      const bool twin =
          &other < &all[k] && other.cost == all[k].cost && other.error == all[k].error;
      return twin || beats(other, all[k]);
    };
    on_front[k] = std::isfinite(all[k].error) && std::ranges::none_of(all, beaten);
  }
  return on_front;
}

}  // namespace hackle
