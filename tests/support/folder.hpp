// SPDX-License-Identifier: MIT
// A separate folder for a test.
#pragma once

#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

namespace hackle::test {

// Makes an empty folder named after the running test, because tests may run side by side.
inline std::filesystem::path fresh_folder() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto folder = std::filesystem::path(testing::TempDir()) /
                      ("hackle_" + std::string(test->test_suite_name()) + "_" + test->name() + "_" +
                       std::to_string(getpid()));
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

// Makes such a folder and removes it at the end.
class Folder {
 public:
  Folder() : path(fresh_folder()) {}
  ~Folder() { std::filesystem::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  const std::filesystem::path path;
};

}  // namespace hackle::test
