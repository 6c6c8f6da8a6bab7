// SPDX-License-Identifier: MIT
#include "app/voice.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <sstream>
#include <string_view>

#include <fmt/format.h>
#include <unistd.h>

#include "base/machine.hpp"
#include "base/streams.hpp"
#include "base/terminal.hpp"
#include "base/text.hpp"
#include "base/units.hpp"

namespace hackle {
namespace {

bool in_colour() {
  const char* refused = std::getenv("NO_COLOR");
  return stderr_is_terminal() && (refused == nullptr || *refused == '\0');
}

constexpr std::string_view red = "1;31", bold = "1", faint = "2";

std::string painted(const std::string& text, std::string_view how, bool colour) {
  return colour ? fmt::format("\033[{}m{}\033[0m", how, text) : text;
}

std::string size_text(const std::filesystem::path& file) {
  std::error_code failure;
  const auto bytes = std::filesystem::file_size(file, failure);
  return failure ? "" : fmt::format(" ({})", quantity(static_cast<double>(bytes), "B"));
}

}  // namespace

std::string error_text(const Error& error, bool colour, std::size_t columns) {
  constexpr std::size_t indent = 7;  // of what follows "error: "
  const auto broken = [&](const std::string& line) {
    return columns == 0 ? line : hanging(line, indent, std::max(columns, 2 * indent));
  };
  std::string text;
  for (const Problem& problem : error.problems()) {
    std::istringstream lines(problem.what);
    std::size_t used = 0;
    for (std::string line; std::getline(lines, line); used = indent + line.size())
      text += fmt::format("{}{} {}", text.empty() ? "" : "\n", painted("error:", red, colour),
                          painted(broken(line), bold, colour));
    if (problem.remedy.empty()) continue;
    const std::string remedy = fmt::format("({})", problem.remedy);
    const bool beside = columns == 0 || used + 1 + remedy.size() <= columns;
    text += beside ? " " : fmt::format("\n{:{}}", "", indent);
    text += painted(broken(remedy), faint, colour);
  }
  return text + "\n";
}

void tell(const Error& error) {
  flush(stdout);
  const std::size_t columns = stderr_is_terminal() ? terminal_columns(STDERR_FILENO) : 0;
  say("{}", error_text(error, in_colour(), columns));
}

void tell_file(const std::filesystem::path& file) {
  say("wrote {}{}\n", file.string(), size_text(file));
}

void tell_files(const std::vector<Summary>& simulations) {
  flush(stdout);
  std::set<std::filesystem::path> told;
  for (const Summary& summary : simulations)
    for (const std::filesystem::path& file : summary.files)
      if (told.insert(file).second) tell_file(file);
  const auto run = std::ranges::find(told, ".h5", &std::filesystem::path::extension);
  if (run != told.end()) say("next: hackle render {}\n", shell_word(run->string()));
}

std::string printable(std::string text) {
  const auto controls = [](unsigned char c) { return std::iscntrl(c) != 0; };
  std::ranges::replace_if(text, controls, '?');
  return text;
}

Talk talk(bool quiet) {
  if (quiet) return Talk::quiet;
  return stderr_is_terminal() ? Talk::animated : Talk::plain;
}

}  // namespace hackle
