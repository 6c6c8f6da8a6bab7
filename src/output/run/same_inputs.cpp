// SPDX-License-Identifier: MIT
#include "output/run/same_inputs.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"

namespace hackle {
namespace {

using InputsJson = nlohmann::json;

// A function is known by its place in the script, which may have moved.
InputsJson without_functions(const InputsJson& json) {
  if (json.is_object() && json.contains("function")) return "function";
  InputsJson bare = json;
  for (auto& value : bare)
    if (value.is_structured()) value = without_functions(value);
  return bare;
}

}  // namespace

void check_same_inputs(const std::string& present, const std::string& former) {
  const InputsJson one = without_functions(InputsJson::parse(present)),
                   other = without_functions(InputsJson::parse(former));
  if (one == other) return;
  std::string places;
  for (const auto& step : InputsJson::diff(other, one))
    places += fmt::format("{}{}", places.empty() ? "" : ", ", step.at("path").get<std::string>());
  throw Error(ErrorKind::refused,
              fmt::format("the script describes another plate or other loads than the run that it "
                          "is to continue: {}",
                          places),
              "--fresh starts anew");
}

}  // namespace hackle
