// SPDX-License-Identifier: MIT
// For libFuzzer, in preset `fuzz`: build/fuzz/bin/fuzz_checkpoint CORPUS, and fuzz_run_file
// likewise.
#include <cstddef>
#include <cstdint>

#include "fuzz/file_runner.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto folder = [] {
    auto path = std::filesystem::temp_directory_path() / "hackle_fuzz_files";
    std::filesystem::create_directories(path);
    return path;
  }();
  hackle::test::read_damaged(hackle::test::StoredFile::HACKLE_FUZZED,
                             {reinterpret_cast<const char*>(data), size}, folder);
  return 0;
}
