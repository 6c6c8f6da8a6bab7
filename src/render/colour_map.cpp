// SPDX-License-Identifier: MIT
#include "render/colour_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <sstream>
#include <string_view>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "base/text.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;

const fs::path folder = "assets/colour_maps";

constexpr std::size_t entries = 256;

}  // namespace

ColourMap fringe_map(double min, double max) {
  constexpr double entries_a_fringe = 64.0, max_entries = 8192.0;
  const double fringes = std::max(max - min, 1.0);
  const auto count =
      static_cast<std::size_t>(std::min(std::ceil(entries_a_fringe * fringes), max_entries));
  ColourMap map{"fringes", std::vector<Colour>(count)};
  for (std::size_t k = 0; k < count; ++k) {
    const double order =
        min + (max - min) * static_cast<double>(k) / static_cast<double>(count - 1);
    const double light = std::pow(std::sin(std::numbers::pi * order), 2);
    // Converts light to pixel values: approximately the curve of sRGB.
    const auto grey = static_cast<std::uint8_t>(std::lround(255.0 * std::pow(light, 1.0 / 2.2)));
    map.colours[k] = {grey, grey, grey};
  }
  return map;
}

ColourMap load_colour_map(const std::string& name) {
  if (std::ranges::find(colour_map_names, name) == colour_map_names.end())
    throw Error(ErrorKind::refused,
                "there is no colour map '" + name + "'" + did_you_mean(name, colour_map_names),
                "one of " + comma_list(colour_map_names));
  ColourMap map{name, {}};
  std::istringstream lines(read_text(data_file(folder / (name + ".csv"))));
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '#') continue;
    unsigned red = 0, green = 0, blue = 0;
    const bool read = std::sscanf(line.c_str(), "%u,%u,%u", &red, &green, &blue) == 3;
    if (!read || std::max({red, green, blue}) > 255 || map.colours.size() == entries)
      throw Error(ErrorKind::files,
                  fmt::format("the colour map '{}' is damaged at '{}'", name, line));
    map.colours.push_back({static_cast<std::uint8_t>(red), static_cast<std::uint8_t>(green),
                           static_cast<std::uint8_t>(blue)});
  }
  if (map.colours.size() != entries)
    throw Error(ErrorKind::files, "the colour map '" + name + "' has not 256 colours");
  return map;
}

}  // namespace hackle
