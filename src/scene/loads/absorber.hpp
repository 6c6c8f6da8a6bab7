// SPDX-License-Identifier: MIT
#pragma once

#include "base/described.hpp"

namespace hackle {

// An edge behind which the plate seems to go on: waves that arrive there do not come back.
struct Absorber {
  enum class Where { all, left, right, bottom, top };
  Where edge = Where::all;
};

template <>
inline constexpr auto enum_names<Absorber::Where> =
    std::to_array<std::string_view>({"all", "left", "right", "bottom", "top"});

template <>
inline constexpr auto description_of<Absorber> =
    describe_noun("absorb", "absorbing edge",
                  member("edge", &Absorber::edge,
                         {.fallback = "all",
                          .sentence = "Edge that absorbs, over its whole length, or all four; "
                                      "several calls name several edges."}));

template <>
inline constexpr Introduction introduction_of<Absorber>{
    "Lets waves leave through an edge, or all edges, as if the plate went on there.",
    "p:absorb { edge = \"right\" }", "s:absorb { edge = \"right\" }", "damping initial impactor"};

inline bool same_place(const Absorber& one, const Absorber& other) {
  return one.edge == other.edge;
}

}  // namespace hackle
