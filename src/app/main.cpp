// SPDX-License-Identifier: MIT
#include "app/command_line.hpp"

int main(int argc, char** argv) {
  return hackle::run_program({argv + 1, argv + argc});
}
