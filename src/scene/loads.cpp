// SPDX-License-Identifier: MIT
#include "scene/loads.hpp"

#include "base/text.hpp"
#include "scene/check_members.hpp"

namespace hackle {

void check(const Loads& loads, Problems& problems) {
  for_each_list(loads, [&](const auto& list) {
    for (const auto& load : list) check_members(load, problems);
  });
  check_members(loads, problems);
}

double spring_stiffness(const Loads& loads) {
  double sum = 0.0;
  for_each_list(loads, [&](const auto& list) {
    if constexpr (requires { spring_stiffness(list.front()); })
      for (const auto& load : list) sum += spring_stiffness(load);
  });
  return sum;
}

std::string describe(const Loads& loads) {
  std::string text;
  for_each_list(loads, [&](const auto& list) {
    using Load = typename std::remove_cvref_t<decltype(list)>::value_type;
    text += counted(list.size(), std::string(description_of<Load>.counted).c_str());
  });
  return text + (loads.damping > 0.0 ? ", damping" : "");
}

}  // namespace hackle
