// SPDX-License-Identifier: MIT
#include "measure/field_by_name.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/text.hpp"
#include "measure/scalar.hpp"

namespace hackle {

std::vector<std::string_view> field_names() {
  std::vector<std::string_view> names(scalar_names.begin(), scalar_names.end());
  names.emplace_back("velocity");  // displacement is among them
  return names;
}

Field field_by_name(const View& view, std::string_view name) {
  if (name == "displacement") return displacement(view);
  if (name == "velocity") return velocity(view);
  const auto names = field_names();
  if (std::ranges::find(names, name) == names.end())
    throw Error(
        ErrorKind::refused,
        fmt::format("there is no field '{}'{}", name.substr(0, 40), did_you_mean(name, names)),
        fmt::format("one of {}", comma_list(names)));
  const Scalar& scalar = scalar_of(name);
  if (name == fringes_name) check_fringes(view.lattice());
  return {std::string(name), std::string(scalar.unit), 1, scalar.values(view)};
}

std::vector<std::string_view> standard_fields(const View& view) {
  std::vector<std::string_view> names{"damage", "displacement", "velocity"};
  if (!view.thermal_strain().empty()) names.emplace_back("temperature");
  return names;
}

}  // namespace hackle
