// SPDX-License-Identifier: MIT
#include "store/json_key.hpp"

#include <algorithm>

namespace hackle {

std::string key_of(std::string_view name, std::string_view unit) {
  std::string key(name);
  if (unit.empty() || unit == "rad") return key;
  key.append("_").append(unit);
  std::ranges::replace(key, '/', '_');
  return key;
}

}  // namespace hackle
