// SPDX-License-Identifier: MIT
#include "console/reference/see_also.hpp"

#include <algorithm>
#include <array>

#include "scene/loads.hpp"

namespace hackle {
namespace {

constexpr auto groups = std::to_array<std::string_view>({
    "plate material simulate help",
    "crack random_cracks notch hole mask keep",
    "inclusion grade material mask hole",
    "traction pressure body_force impactor temperature move",
    "clamp move release nofail",
    "ramp pulse step_at traction",
    "initial damping move",
    "strength grade nofail material",
    "contact impactor fragments",
    "run step start simulate on",
    "on stop run",
    "start wait status pause resume stop",
    "script interrupt simulations run",
    "fork rewind save simulations",
    "save load fork record",
    "load save recording",
    "relax quasistatic damping",
    "movie frame record report",
    "show watch frame status",
    "recording record frame movie show contact_sheet side_by_side",
    "contact_sheet side_by_side recording frame",
    "close movie record",
    "cracks fragments fracture at report",
    "graph tips on cracks fracture",
    "fracture log relax cracks",
    "log record report on chart",
    "chart log recording frame contact_sheet",
    "gauge read at values log",
    "values at max min mean save frame",
    "reaction clamp move roller platen log",
    "expect report gauge read options",
    "options help",
    "study.trade study.convergence study.ensemble study.sweep simulate",
    "study.convergence study.trade study.sweep",
    "study.ensemble study.trade study.sweep strength",
    "study.sweep study.convergence study.trade contact_sheet",
});

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::size_t begin = 0, end = 0; end < line.size(); begin = end + 1) {
    end = std::min(line.find(' ', begin), line.size());
    words.push_back(line.substr(begin, end - begin));
  }
  return words;
}

// What a load says of itself, which introduces itself.
template <class Load>
void add_introduced(std::string_view function, const std::vector<Load>&,
                    std::vector<std::string_view>& names) {
  if (function != description_of<Load>.noun || introduction_of<Load>.see_also.empty()) return;
  for (const std::string_view name : words_of(introduction_of<Load>.see_also))
    names.push_back(name);
}

}  // namespace

std::vector<std::string_view> see_also(std::string_view function) {
  std::vector<std::string_view> names;
  for_each_list(Loads(), [&](const auto& list) { add_introduced(function, list, names); });
  for (const std::string_view line : groups) {
    const std::vector<std::string_view> group = words_of(line);
    if (std::ranges::count(group, function) == 0) continue;
    for (const std::string_view name : group)
      if (name != function && std::ranges::count(names, name) == 0) names.push_back(name);
  }
  return names;
}

}  // namespace hackle
