// SPDX-License-Identifier: MIT
#include "measure/node_values.hpp"

#include <utility>

#include "lattice/carve.hpp"
#include "measure/between_nodes.hpp"
#include "measure/links.hpp"
#include "measure/scalar.hpp"

namespace hackle {

NodeValues::NodeValues(std::string_view field, const View& view)
    : name_(field), time_(view.time()), grid_(view.lattice().grid), links_(links(view)) {
  const Scalar& scalar = scalar_of(field);
  unit_ = scalar.unit;
  values_ = scalar.values(view);
  for (const std::uint8_t material : view.lattice().material)
    there_.push_back(material == Lattice::void_node ? 0 : 1);
}

NodeValues::Place NodeValues::max() const {
  std::optional<Place> best;
  for_each([&](int i, int j, double value) {
    if (!best || value > best->value) best = {value, grid_.position(i, j)};
  });
  return best.value_or(Place());
}

NodeValues::Place NodeValues::min() const {
  std::optional<Place> best;
  for_each([&](int i, int j, double value) {
    if (!best || value < best->value) best = {value, grid_.position(i, j)};
  });
  return best.value_or(Place());
}

std::optional<double> NodeValues::mean(const Region& region) const {
  double sum = 0.0, count = 0.0;
  for_nodes_in(region, grid_, [&](int i, int j) {
    if (!is_there(i, j)) return;
    sum += static_cast<double>(values_[grid_.index(i, j)]);
    count += 1.0;
  });
  return count > 0.0 ? std::optional(sum / count) : std::nullopt;
}

// Nodes keep the bits of bonds to the right and above.
bool NodeValues::joined(int i, int j, int column, int row) const {
  if (row < 0 || (row == 0 && column < 0)) return joined(i + column, j + row, -column, -row);
  const std::uint8_t bit = row == 0      ? Link::right
                           : column < 0  ? Link::above_left
                           : column == 0 ? Link::above
                                         : Link::above_right;
  return (links_[grid_.index(i, j)] & bit) != 0;
}

std::optional<double> NodeValues::at(const Vec2& place) const {
  const auto nodes =
      surrounding({grid_, [this](int i, int j) { return is_there(i, j); },
                   [this](int i, int j, int column, int row) { return joined(i, j, column, row); }},
                  place);
  if (!nodes) return std::nullopt;
  return interpolated(
      *nodes, [&](int i, int j) { return static_cast<double>(values_[grid_.index(i, j)]); });
}

}  // namespace hackle
