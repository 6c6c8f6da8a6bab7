// SPDX-License-Identifier: MIT
// The rooms of src/ and which others each may include (src/README.md).
#pragma once

#include <map>
#include <set>
#include <string>

namespace hackle {

inline const std::map<std::string, std::set<std::string>> may_see = {
    {"base", {}},
    {"scene", {"base"}},
    {"lattice", {"scene", "base"}},
    {"solver", {"lattice", "scene", "base"}},
    {"measure", {"solver", "lattice", "scene", "base"}},
    {"render", {"measure", "solver", "lattice", "scene", "base"}},
    {"store", {"measure", "solver", "lattice", "scene", "base"}},
    {"movie", {"base"}},
    {"output", {"movie", "render", "store", "measure", "solver", "lattice", "scene", "base"}},
    {"study",
     {"output", "movie", "render", "store", "measure", "solver", "lattice", "scene", "base"}},
    {"console",
     {"study", "output", "movie", "render", "store", "measure", "solver", "lattice", "scene",
      "base"}},
    {"app",
     {"console", "study", "output", "movie", "render", "store", "measure", "solver", "lattice",
      "scene", "base"}},
};

}  // namespace hackle
