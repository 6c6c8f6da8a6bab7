// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <string_view>

#include "base/partial_file.hpp"

namespace hackle {

// A text file that takes its name when it is complete. Throws Error (files) if it cannot be
// written.
class TextOutput {
 public:
  explicit TextOutput(const std::filesystem::path& path);

  void write(std::string_view text) { file_ << text; }
  void finish();

 private:
  std::filesystem::path path_;
  PartialFile held_;
  std::ofstream file_;
};

}  // namespace hackle
