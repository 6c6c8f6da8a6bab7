// SPDX-License-Identifier: MIT
#include "app/voice.hpp"

#include <cstdio>
#include <cstdlib>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "base/machine.hpp"
#include "base/units.hpp"

namespace hackle {
namespace {

bool in_colour() {
  const char* refused = std::getenv("NO_COLOR");
  return stderr_is_terminal() && (refused == nullptr || *refused == '\0');
}

std::string size_text(const std::filesystem::path& file) {
  std::error_code failure;
  const auto bytes = std::filesystem::file_size(file, failure);
  return failure ? "" : fmt::format(" ({})", quantity(static_cast<double>(bytes), "B"));
}

}  // namespace

void tell(const Error& error) {
  std::fflush(stdout);
  const char* label = in_colour() ? "\033[1;31merror:\033[0m" : "error:";
  std::istringstream lines(error.what());
  for (std::string line; std::getline(lines, line);) fmt::print(stderr, "{} {}\n", label, line);
}

void tell_files(const std::vector<Summary>& simulations) {
  std::fflush(stdout);
  std::set<std::filesystem::path> told;
  for (const Summary& summary : simulations)
    for (const std::filesystem::path& file : summary.files)
      if (told.insert(file).second)
        fmt::print(stderr, "wrote {}{}\n", file.string(), size_text(file));
}

Talk talk(bool quiet) {
  if (quiet) return Talk::quiet;
  return stderr_is_terminal() ? Talk::animated : Talk::plain;
}

}  // namespace hackle
