// SPDX-License-Identifier: MIT
// A folder of a test's own.
#pragma once

#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

namespace hackle::test {

// An empty folder that bears the names of the running test; tests may run side by side.
inline std::filesystem::path fresh_folder() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto folder = std::filesystem::path(testing::TempDir()) /
                      ("hackle_" + std::string(test->test_suite_name()) + "_" + test->name() + "_" +
                       std::to_string(getpid()));
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

// Such a folder, removed at the end.
class Folder {
 public:
  Folder() : path(fresh_folder()) {}
  ~Folder() { std::filesystem::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  const std::filesystem::path path;
};

}  // namespace hackle::test
