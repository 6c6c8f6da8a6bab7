// SPDX-License-Identifier: MIT
// Runs random scripts for some seconds, or for HACKLE_FUZZ_SECONDS; HACKLE_FUZZ_SEED sets the first
// seed. Under the sanitizers this serves as a fuzzer where libFuzzer is missing.
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <random>

#include <gtest/gtest.h>

#include "fuzz/script_runner.hpp"
#include "fuzz/script_writer.hpp"
#include "support/folder.hpp"

namespace hackle::test {
namespace {

double number_from(const char* variable, double fallback) {
  const char* text = std::getenv(variable);
  return text != nullptr ? std::strtod(text, nullptr) : fallback;
}

std::vector<std::uint8_t> random_bytes(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<std::uint8_t> bytes(20 + random() % 380);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random() >> 32U);
  return bytes;
}

TEST(Fuzz, NoScriptOfTheLanguageBreaksTheProgram) {
  const Folder folder;
  const auto until = std::chrono::steady_clock::now() +
                     std::chrono::duration<double>(number_from("HACKLE_FUZZ_SECONDS", 5.0));
  auto seed = static_cast<std::uint64_t>(number_from("HACKLE_FUZZ_SEED", 1.0));
  int scripts = 0;
  for (; std::chrono::steady_clock::now() < until; ++seed, ++scripts) {
    const std::string script = script_of(random_bytes(seed));
    // After a crash this file contains the script that crashed.
    std::ofstream(std::filesystem::path(testing::TempDir()) / "hackle_fuzz_last.lua") << script;
    ASSERT_NO_THROW(run_fuzzed(script, folder.path)) << "seed " << seed << "\n" << script;
  }
  std::cout << scripts << " scripts, up to seed " << seed << "\n";
}

TEST(Fuzz, TheSameBytesGiveTheSameScript) {
  EXPECT_EQ(script_of(random_bytes(7)), script_of(random_bytes(7)));
  EXPECT_NE(script_of(random_bytes(7)), script_of(random_bytes(8)));
}

}  // namespace
}  // namespace hackle::test
