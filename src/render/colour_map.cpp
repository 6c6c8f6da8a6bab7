// SPDX-License-Identifier: MIT
#include "render/colour_map.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
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

[[noreturn]] void refuse(const std::string& name) {
  const std::vector<std::string> known = colour_map_names();
  const std::vector<std::string_view> views(known.begin(), known.end());
  throw Error(ErrorKind::refused,
              "there is no colour map '" + name + "'" + did_you_mean(name, views),
              "one of " + comma_list(views));
}

}  // namespace

std::vector<std::string> colour_map_names() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(data_file(folder)))
    if (entry.path().extension() == ".csv") names.push_back(entry.path().stem().string());
  std::ranges::sort(names);
  return names;
}

ColourMap load_colour_map(const std::string& name) {
  const std::vector<std::string> known = colour_map_names();
  if (std::ranges::find(known, name) == known.end()) refuse(name);
  ColourMap map{name, {}};
  std::istringstream lines(read_text(data_file(folder / (name + ".csv"))));
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '#') continue;
    unsigned red = 0, green = 0, blue = 0;
    const bool read = std::sscanf(line.c_str(), "%u,%u,%u", &red, &green, &blue) == 3;
    if (!read || std::max({red, green, blue}) > 255 || count >= map.colours.size())
      throw Error(ErrorKind::files,
                  fmt::format("the colour map '{}' is damaged at '{}'", name, line));
    map.colours[count++] = {static_cast<std::uint8_t>(red), static_cast<std::uint8_t>(green),
                            static_cast<std::uint8_t>(blue)};
  }
  if (count != map.colours.size())
    throw Error(ErrorKind::files, "the colour map '" + name + "' has not 256 colours");
  return map;
}

}  // namespace hackle
