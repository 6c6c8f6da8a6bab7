// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace hackle::test {

// Runs a script as from a stranger, writing below `folder`, and interrupts it after a second. An
// Error is what a script may end with; anything else leaves this function. Ends the process when
// the script does not heed the interrupt for a minute.
void run_fuzzed(const std::string& script, const std::filesystem::path& folder);

}  // namespace hackle::test
