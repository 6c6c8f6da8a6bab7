// SPDX-License-Identifier: MIT
#include "app/command_line.hpp"
#include "base/machine.hpp"
#include "base/streams.hpp"

int main(int argc, char** argv) {
  hackle::hold_standard_streams();
  hackle::keep_freed_memory();
  return hackle::run_program({argv + 1, argv + argc});
}
