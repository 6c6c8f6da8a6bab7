// SPDX-License-Identifier: MIT
#include "base/error.hpp"

#include <utility>

namespace hackle {
namespace {

std::string lines(const std::vector<Problem>& problems) {
  std::string text;
  for (const Problem& problem : problems) {
    if (!text.empty()) text += '\n';
    text += problem.what;
    if (!problem.remedy.empty()) text.append(" (").append(problem.remedy).append(")");
  }
  return text;
}

}  // namespace

Error::Error(ErrorKind kind, std::string what, std::string remedy)
    : Error(kind, std::vector<Problem>{{std::move(what), std::move(remedy)}}) {
}

Error::Error(ErrorKind kind, std::vector<Problem> problems)
    : std::runtime_error(lines(problems)), kind_(kind), problems_(std::move(problems)) {
}

void Problems::add(std::string what, std::string remedy) {
  list_.push_back({std::move(what), std::move(remedy)});
}

void Problems::throw_if_any(ErrorKind kind) const {
  if (!list_.empty()) throw Error(kind, list_);
}

}  // namespace hackle
