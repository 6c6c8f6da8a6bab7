// SPDX-License-Identifier: MIT
#include "solver/statics/static_work.hpp"

namespace hackle {
namespace {

// One component of a configuration.
struct Along {
  const Values<double>&u, &pull, &load;
};

void add(const Along& before, const Along& after, const Values<double>& mobile, std::size_t at,
         StaticWork& sum) {
  const double half_way = 0.5 * (after.u[at] - before.u[at]);
  if (mobile[at] == 0.0) {
    // The load does its work, and the reaction -(pull + load) takes it away again.
    sum.external -= (before.pull[at] + after.pull[at]) * half_way;
    return;
  }
  sum.external += (before.load[at] + after.load[at]) * half_way;
  sum.released += (before.pull[at] + before.load[at]) * half_way;
}

}  // namespace

StaticWork work_between(const NodeLayout& layout, const Posture& before, const Posture& after,
                        const NodeVectors& mobile) {
  StaticWork sum;
  for (int j = 0; j < layout.ny; ++j)
    for (int i = 0; i < layout.nx; ++i) {
      const auto at = static_cast<std::size_t>(layout.at(i, j));
      add({before.u.x, before.pull.x, before.load.x}, {after.u.x, after.pull.x, after.load.x},
          mobile.x, at, sum);
      add({before.u.y, before.pull.y, before.load.y}, {after.u.y, after.pull.y, after.load.y},
          mobile.y, at, sum);
    }
  return sum;
}

}  // namespace hackle
