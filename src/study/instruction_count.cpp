// SPDX-License-Identifier: MIT
#include "study/instruction_count.hpp"

#include <cstdlib>
#include <sstream>

#include "base/child_process.hpp"

namespace hackle {

std::optional<std::filesystem::path> find_valgrind() {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    std::error_code ignored;
    const std::filesystem::path file = std::filesystem::path(folder) / "valgrind";
    if (std::filesystem::is_regular_file(file, ignored)) return file;
  }
  return std::nullopt;
}

std::optional<double> collected_in(std::string_view report) {
  constexpr std::string_view word = "Collected : ";
  const std::size_t at = report.rfind(word);
  if (at == std::string_view::npos) return std::nullopt;
  return std::strtod(std::string(report.substr(at + word.size())).c_str(), nullptr);
}

std::optional<double> count_instructions(const std::filesystem::path& valgrind,
                                         std::vector<std::string> words) {
  words.insert(words.begin(),
               {valgrind.string(), "--tool=callgrind", "--callgrind-out-file=/dev/null"});
  const ChildResult result = run_child(words);
  return result.succeeded() ? collected_in(result.error) : std::nullopt;
}

}  // namespace hackle
