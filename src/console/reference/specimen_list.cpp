// SPDX-License-Identifier: MIT
#include "console/reference/specimen_list.hpp"

#include <filesystem>
#include <map>

#include <fmt/format.h>

#include "base/files.hpp"
#include "base/text.hpp"

namespace hackle {
namespace {

// Returns "the compact tension ..." of a file that begins with "-- NAME.lua: the compact ...".
std::string title_in(const std::filesystem::path& file) {
  const std::string text = read_text(file);
  const std::string line = text.substr(0, text.find('\n'));
  const std::size_t colon = line.find(": ");
  return colon == std::string::npos ? "" : line.substr(colon + 2);
}

std::map<std::string, std::string> titles() {
  std::map<std::string, std::string> found;
  const auto folder = find_data_file("scripts/specimens");
  if (!folder) return found;
  for (const auto& entry : std::filesystem::directory_iterator(*folder))
    if (entry.path().extension() == ".lua" && entry.path().stem() != "parts")
      found[entry.path().stem().string()] = title_in(entry.path());
  return found;
}

}  // namespace

std::string list_of_specimens(std::size_t width) {
  std::string text =
      "Ready specimens are functions of their dimensions, in modules of Hackle. They\n"
      "return a plate and a table of what belongs to it (specimens/parts.lua):\n\n"
      "  local p, at = require \"specimens.compact_tension\" { W = 50*mm, a = 25*mm }\n"
      "  local s = simulate(p, { spacing = 0.5*mm })\n"
      "  s:relax() print(at.measured(s), at.displacement, at.K)\n";
  const auto all = titles();
  if (all.empty()) return text + "\nNone are installed: they belong into scripts/specimens.";
  for (const auto& [name, title] : all)
    text += fmt::format("\n  {:<19}{}", name, hanging(title, 21, width));
  return text;
}

}  // namespace hackle
