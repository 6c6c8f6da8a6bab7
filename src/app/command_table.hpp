// SPDX-License-Identifier: MIT
// The command line as data, read from its parser: what the manual and the shells need to know.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}  // namespace CLI

namespace hackle {

struct CommandOption {
  std::vector<std::string> names;    // "-o", "--output"; the one word of a value without a name
  std::string value;                 // "DIR", or "" for a flag
  std::vector<std::string> choices;  // every value, where they are known
  std::string sentence;
  bool nameless = false;  // a value that stands by itself, as FILE does
};

struct Command {
  std::string name;  // "run"; "" for hackle itself
  std::string sentence;
  std::string footer;
  std::vector<CommandOption> options;
};

// hackle itself, then its commands.
std::vector<Command> command_table(const CLI::App& app);

// "hackle run [options] FILE"
std::string synopsis(const Command& command);
// "-o, --output DIR"
std::string usage(const CommandOption& option);

}  // namespace hackle
