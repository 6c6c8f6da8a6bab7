// SPDX-License-Identifier: MIT
#include "output/export/export_choice.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/units.hpp"
#include "measure/field_by_name.hpp"

namespace hackle {
namespace {

std::size_t nearest_state(const std::vector<double>& times, double time) {
  const auto closer = [&](double one, double other) {
    return std::abs(one - time) < std::abs(other - time);
  };
  return static_cast<std::size_t>(std::ranges::min_element(times, closer) - times.begin());
}

std::vector<double> multiples(double every, const std::vector<double>& times) {
  if (!(every > 0.0))
    throw Error(ErrorKind::refused,
                fmt::format("export: every is {}, it must be above 0 s", quantity(every, "s")));
  std::vector<double> list;
  // Not more than there are states: nearer ones would be the same.
  const double step = std::max(every, (times.back() - times.front()) / 1e6);
  for (double k = std::ceil(times.front() / step - 1e-9); k * step <= times.back() * (1.0 + 1e-9);
       ++k)
    list.push_back(k * step);
  return list;
}

std::vector<std::size_t> states_at(const std::vector<double>& times,
                                   const std::vector<double>& wanted) {
  std::vector<std::size_t> states;
  states.reserve(wanted.size());
  for (const double time : wanted) states.push_back(nearest_state(times, time));
  std::ranges::sort(states);
  states.erase(std::unique(states.begin(), states.end()), states.end());
  return states;
}

std::vector<std::size_t> chosen_states(const std::vector<double>& times,
                                       const ExportWishes& wishes) {
  if (!wishes.times.empty()) return states_at(times, wishes.times);
  if (wishes.every) return states_at(times, multiples(*wishes.every, times));
  return wishes.all_times ? states_at(times, times) : states_at(times, {times.back()});
}

}  // namespace

ExportChoice chosen(const StoredRun& run, const ExportWishes& wishes) {
  ExportChoice choice{chosen_states(run.times(), wishes), {}};
  for (const std::string& name : wishes.fields)
    if (std::ranges::find(choice.fields, name) == choice.fields.end())
      choice.fields.push_back(name);
  if (choice.fields.empty())
    for (const std::string_view name : standard_fields(run.view()))
      choice.fields.emplace_back(name);
  for (const std::string& name : choice.fields) field_by_name(run.view(), name);
  return choice;
}

std::vector<ExportNode> export_nodes(const Lattice& lattice) {
  std::vector<ExportNode> nodes;
  for (int j = 0; j < lattice.grid.ny; ++j)
    for (int i = 0; i < lattice.grid.nx; ++i)
      if (!lattice.is_void(i, j)) nodes.emplace_back(i, j);
  return nodes;
}

std::vector<Field> export_fields(const StoredRun& run, const ExportChoice& choice) {
  std::vector<Field> fields;
  for (const std::string& name : choice.fields) fields.push_back(field_by_name(run.view(), name));
  return fields;
}

}  // namespace hackle
