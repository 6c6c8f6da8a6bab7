// SPDX-License-Identifier: MIT
// What a fit says to a person and to other programs.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "study/fit.hpp"
#include "study/study_files.hpp"

namespace hackle {

// What is to be said of it: bounds, parameters that nothing reacts to, residuals that are large.
std::vector<std::string> remarks_of(const FitResult& result);

// {"schema":1,"kind":"fit","parameters":{..},"residuals":{..},"runs":N}
nlohmann::ordered_json to_json(const FitResult& result);

// All of it, without charts.
StudyFindings findings_of(const FitResult& result);

}  // namespace hackle
