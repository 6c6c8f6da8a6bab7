// SPDX-License-Identifier: MIT
// The materials that ship with Hackle.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scene/material.hpp"

namespace hackle {

struct KnownMaterial {
  std::string key;  // "duran50"
  Material material;
  std::string source;  // who says so
};

class Materials {
 public:
  // Reads a Lua file that returns { key = { title=, E=, rho=, nu=, G0=, source= }, ... }, where
  // alpha, alphaT and s0 (instead of G0) may be given, too; in it
  // the unit constants are known. Throws Error (files) when it cannot be read or makes no sense.
  explicit Materials(const std::filesystem::path& file);

  // Throws Error (refused) with the nearest name and all that are known.
  const KnownMaterial& find(std::string_view key) const;

  // Ordered by key.
  const std::vector<KnownMaterial>& list() const { return list_; }

 private:
  std::vector<KnownMaterial> list_;
};

}  // namespace hackle
