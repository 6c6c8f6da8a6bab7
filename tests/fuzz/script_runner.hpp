// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace hackle::test {

// Runs a script as untrusted, writing below `folder`, and interrupts it after a second. A script
// may end with an Error; any other exception leaves this function. Ends the process if the script
// ignores the interrupt for a minute.
void run_fuzzed(const std::string& script, const std::filesystem::path& folder);

}  // namespace hackle::test
