// SPDX-License-Identifier: MIT
#include "measure/averages.hpp"

#include <algorithm>

namespace hackle {
namespace {

// Calls visit(one, other) for the two nodes of every intact bond.
template <class Visit>
void for_intact_bonds(const View& view, const Visit& visit) {
  const Lattice& lattice = view.lattice();
  const Grid& grid = lattice.grid;
  const NodeLayout layout = grid.layout();
  lattice.family.for_each_bond([&](int column, int row, const Vec2&, double, int bit) {
    for (int j = 0; j < grid.ny; ++j)
      for (int i = 0; i < grid.nx; ++i)
        if (view.state().bonds.holds(layout.at(i, j), bit))
          visit(grid.index(i, j), grid.index(i + column, j + row));
  });
}

// A sum, value by value; `add` adds one value to another and `scale` multiplies one.
template <class Value, class Add, class Scale>
std::vector<Value> means(const View& view, const std::vector<Value>& values, const Add& add,
                         const Scale& scale) {
  std::vector<Value> sums = values;
  std::vector<int> counts(values.size(), 1);
  for_intact_bonds(view, [&](std::size_t one, std::size_t other) {
    add(sums[one], values[other]);
    add(sums[other], values[one]);
    ++counts[one];
    ++counts[other];
  });
  for (std::size_t node = 0; node < sums.size(); ++node) scale(sums[node], 1.0 / counts[node]);
  return sums;
}

}  // namespace

std::vector<float> averaged(const View& view, const std::vector<float>& values) {
  const std::vector<double> exact(values.begin(), values.end());
  const std::vector<double> found = means(
      view, exact, [](double& sum, double value) { sum += value; },
      [](double& sum, double factor) { sum *= factor; });
  return {found.begin(), found.end()};
}

std::vector<Stress> averaged(const View& view, const std::vector<Stress>& values) {
  const auto add = [](Stress& sum, const Stress& value) {
    sum.xx += value.xx;
    sum.yy += value.yy;
    sum.xy += value.xy;
    sum.zz += value.zz;
  };
  const auto scale = [](Stress& sum, double factor) {
    sum.xx *= factor;
    sum.yy *= factor;
    sum.xy *= factor;
    sum.zz *= factor;
  };
  return means(view, values, add, scale);
}

}  // namespace hackle
