// SPDX-License-Identifier: MIT
// Resources of the machine: memory, cores, terminals.
#pragma once

#include <cstdint>
#include <string>

namespace hackle {

// Returns the bytes that can be allocated without swapping: the smaller of what the kernel reports
// as available and what the control group of the process leaves.
std::uint64_t available_memory();

// Returns the largest resident size of this process so far, in bytes.
std::uint64_t peak_resident_memory();

// Returns the number of processors this process may run on, at least 1.
int available_cores();

// Makes the process keep freed large blocks, up to 256 MB: pictures come and go by megabytes, and
// fetching their pages anew takes a sixth of the time of a movie.
void keep_freed_memory();

// Returns whether stderr is a terminal that can redraw a line.
bool stderr_is_terminal();

// Returns whether a person sees what is written to stdout.
bool stdout_is_terminal();

// Returns the processor's own name.
std::string processor_name();

}  // namespace hackle
