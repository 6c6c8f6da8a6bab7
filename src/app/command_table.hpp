// SPDX-License-Identifier: MIT
// The command line as data, taken from its parser, for the manual and the shell completions.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}  // namespace CLI

namespace hackle {

struct CommandOption {
  std::vector<std::string> names;    // "-o", "--output"; one word for a positional value
  std::string value;                 // "DIR", or "" for a flag
  std::vector<std::string> choices;  // all values, if they are known
  std::string sentence;
  bool nameless = false;  // a positional value, such as FILE
};

struct Command {
  std::string name;  // "run"; "" for hackle itself
  std::string sentence;
  std::string footer;
  std::vector<CommandOption> options;
};

// Returns hackle itself, then its commands.
std::vector<Command> command_table(const CLI::App& app);

// Returns "hackle run [options] FILE".
std::string synopsis(const Command& command);
// Returns "-o, --output DIR".
std::string usage(const CommandOption& option);

}  // namespace hackle
