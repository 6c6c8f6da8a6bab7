// SPDX-License-Identifier: MIT
#include "app/command_table.hpp"

#include <CLI/CLI.hpp>

namespace hackle {
namespace {

// Returns the choices that a check has added to the type name: "NAME:{auto,lammps,none}".
std::vector<std::string> choices_of(const std::string& type) {
  const std::size_t open = type.find(":{"), close = type.rfind('}');
  if (open == std::string::npos || close == std::string::npos) return {};
  return CLI::detail::split(type.substr(open + 2, close - open - 2), ',');
}

CommandOption option_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  CommandOption found;
  found.sentence = option.get_description();
  found.nameless = option.get_positional();
  if (found.nameless) found.names = {option.get_single_name()};
  for (const std::string& name : option.get_snames()) found.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) found.names.push_back("--" + name);
  if (option.get_items_expected_max() > 0 && !found.nameless)
    found.value = type.substr(0, type.find(':'));
  found.choices = choices_of(type);
  return found;
}

Command command_of(const CLI::App& app, const std::string& name) {
  Command command{name, app.get_description(), app.get_footer(), {}};
  for (const CLI::Option* option : app.get_options()) command.options.push_back(option_of(*option));
  return command;
}

}  // namespace

std::vector<Command> command_table(const CLI::App& app) {
  std::vector<Command> table{command_of(app, "")};
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    table.push_back(command_of(*command, command->get_name()));
  return table;
}

std::string synopsis(const Command& command) {
  std::string text = "hackle" + (command.name.empty() ? "" : " " + command.name) + " [options]";
  for (const CommandOption& option : command.options)
    if (option.nameless) text += " " + option.names.front();
  return text;
}

std::string usage(const CommandOption& option) {
  std::string text;
  for (const std::string& name : option.names) text += (text.empty() ? "" : ", ") + name;
  return option.value.empty() ? text : text + " " + option.value;
}

}  // namespace hackle
