// SPDX-License-Identifier: MIT
// hackle info
#pragma once

namespace hackle {

// Prints version, libraries and the resources of the machine. Returns the exit code.
int command_info(bool json);

}  // namespace hackle
