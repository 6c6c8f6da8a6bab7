// SPDX-License-Identifier: MIT
// What the machine can give: memory, cores, the end of a pipe.
#pragma once

#include <cstdint>
#include <string>

namespace hackle {

// Bytes that can be allocated without swapping: the smaller of what the kernel calls available and
// what the control group of the process leaves.
std::uint64_t available_memory();

// The largest resident size of this process so far, in bytes.
std::uint64_t peak_resident_memory();

// Processors this process may run on, at least 1.
int available_cores();

// From now on large blocks that are freed stay with the process, up to 256 MB: pictures come and go
// by megabytes, and fetching their pages anew takes a sixth of the time of a movie.
void keep_freed_memory();

// Whether stderr is a terminal that can redraw a line.
bool stderr_is_terminal();

// Whether what is written to stdout ends in front of a person.
bool stdout_is_terminal();

// The processor as it names itself.
std::string processor_name();

}  // namespace hackle
