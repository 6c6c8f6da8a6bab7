// SPDX-License-Identifier: MIT
// recording "run.h5" and the methods of a recorded run.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/error.hpp"
#include "console/schema/schema.hpp"
#include "output/files/replay.hpp"

namespace hackle {

class Arguments;

// Returns the runs of the option `recordings` with their titles; `who` names the calling function.
Tiles tiles_of(Arguments& arguments, const char* who);

// Gives each of these its title, where there are titles; adds a problem unless they are as many.
// `what` they are.
template <class Titled>
void set_titles(const char* who, const char* what, const std::vector<std::string>& titles,
                std::vector<Titled>& titled, Problems& problems) {
  if (titled.empty() || titles.empty()) return;
  if (titles.size() != titled.size())
    problems.add(
        fmt::format("{}: there are {} titles for {} {}", who, titles.size(), titled.size(), what),
        "give as many, or none");
  for (std::size_t k = 0; k < std::min(titles.size(), titled.size()); ++k)
    titled[k].title = titles[k];
}

const TypeDoc& recording_type();
std::span<const Function> recording_functions();

}  // namespace hackle
