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
  std::string source;  // origin of the values
};

class Materials {
 public:
  // Reads a Lua file that returns { key = { title=, E=, rho=, nu=, G0=, source= }, ... },
  // optionally with alpha, alphaT and s0 (instead of G0); it may use the unit constants. Throws
  // Error (files) if it cannot be read or is invalid.
  explicit Materials(const std::filesystem::path& file);

  // Throws Error (refused) with the nearest name and all known names.
  const KnownMaterial& find(std::string_view key) const;

  // Returns all materials, ordered by key.
  const std::vector<KnownMaterial>& list() const { return list_; }

 private:
  std::vector<KnownMaterial> list_;
};

}  // namespace hackle
