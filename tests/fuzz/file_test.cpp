// SPDX-License-Identifier: MIT
// Reads damaged files for some seconds, or HACKLE_FUZZ_FILES of each kind.
#include <cstdlib>
#include <fstream>
#include <iostream>

#include <gtest/gtest.h>

#include "fuzz/file_runner.hpp"
#include "support/folder.hpp"

namespace hackle::test {
namespace {

std::uint64_t files() {
  const char* text = std::getenv("HACKLE_FUZZ_FILES");
  return text != nullptr ? std::strtoull(text, nullptr, 10) : 150;
}

class FuzzedFiles : public testing::TestWithParam<StoredFile> {};

TEST_P(FuzzedFiles, AreReadOrRefused) {
  const Folder folder;
  const std::string whole = whole_file(GetParam(), folder.path);
  ASSERT_TRUE(read_damaged(GetParam(), whole, folder.path));
  std::uint64_t read = 0;
  for (std::uint64_t seed = 1; seed <= files(); ++seed) {
    // After a crash this file tells what was read.
    std::ofstream(std::filesystem::path(testing::TempDir()) / "hackle_fuzz_seed") << seed;
    ASSERT_NO_THROW(read += read_damaged(GetParam(), damaged_file(whole, seed), folder.path))
        << "seed " << seed;
  }
  std::cout << read << " of " << files() << " were read\n";
}
INSTANTIATE_TEST_SUITE_P(Of, FuzzedFiles,
                         testing::Values(StoredFile::checkpoint, StoredFile::run_file),
                         [](const auto& info) {
                           return info.param == StoredFile::checkpoint ? "checkpoints"
                                                                       : "run_files";
                         });

}  // namespace
}  // namespace hackle::test
