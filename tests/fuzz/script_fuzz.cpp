// SPDX-License-Identifier: MIT
// For libFuzzer, in preset `fuzz`: build/fuzz/bin/fuzz_script -max_len=400 CORPUS
#include <cstddef>
#include <cstdint>

#include "fuzz/script_runner.hpp"
#include "fuzz/script_writer.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto folder = std::filesystem::temp_directory_path() / "hackle_fuzz";
  hackle::test::run_fuzzed(hackle::test::script_of({data, size}), folder);
  return 0;
}
