// SPDX-License-Identifier: MIT
#include "console/reference/tour.hpp"

#include <array>
#include <span>

#include <fmt/format.h>

namespace hackle {
namespace {

struct Line {
  std::string_view code;
  std::string_view remark{};
};

constexpr std::array lines{
    Line{"p = plate { width = 100*mm, height = 40*mm, material = \"duran50\" }"},
    Line{"p:crack { from = {0, 20*mm}, to = {50*mm, 20*mm} }"},
    Line{"p:traction { edge = \"top\", stress = {0, 12*MPa} }"},
    Line{"p:traction { edge = \"bottom\", stress = {0, -12*MPa} }"},
    Line{"s = simulate(p, { spacing = 1*mm })", "puts it on a lattice"},
    Line{"s:run(20*us)", "Ctrl-C stops it after a step"},
    Line{"s.energy", "the energy balance"},
    Line{"s:frame { \"crack.png\" }", "a picture, in out/prompt"},
    Line{"s:traction { edge = \"top\", stress = {0, 24*MPa} }", "another load"},
    Line{"s:run(10*us)", "continues"},
};

constexpr std::array pages{
    Line{"help \"crack\"", "a function: options, units, ranges, an example"},
    Line{"help \"horizon\"", "an option: its meaning, and its functions"},
    Line{"help(p)", "the methods of a plate; help(s): of a simulation"},
    Line{"help \"functions\"", "everything; also \"materials\" and \"units\""},
};

std::string text_of(std::span<const Line> list, std::size_t column) {
  std::string text;
  for (const Line& line : list)
    text += line.remark.empty() ? fmt::format("  {}\n", line.code)
                                : fmt::format("  {:<{}}  -- {}\n", line.code, column, line.remark);
  return text;
}

}  // namespace

std::string tour() {
  return "Hackle breaks thin brittle plates. These lines break one; type or paste them:\n\n" +
         text_of(lines, 38) + "\nRead more with\n\n" + text_of(pages, 18) +
         "\nTab completes names, options and choices. The Up key recalls lines. _ is the\n"
         "last result. To run a script: hackle run script.lua";
}

std::vector<std::string_view> tour_lines() {
  std::vector<std::string_view> codes;
  codes.reserve(std::size(lines) + std::size(pages));
  for (const Line& line : lines) codes.push_back(line.code);
  for (const Line& line : pages) codes.push_back(line.code);
  return codes;
}

}  // namespace hackle
