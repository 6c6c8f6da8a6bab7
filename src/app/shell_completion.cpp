// SPDX-License-Identifier: MIT
#include "app/shell_completion.hpp"

#include <fmt/format.h>

namespace hackle {
namespace {

std::string spaced(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

// Quotes a text with single quotes, for any of the shells.
std::string in_quotes(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

std::vector<std::string> option_names(const Command& command) {
  std::vector<std::string> names;
  for (const CommandOption& option : command.options)
    if (!option.nameless) names.insert(names.end(), option.names.begin(), option.names.end());
  return names;
}

std::vector<std::string> command_names(const std::vector<Command>& commands) {
  std::vector<std::string> names;
  for (const Command& command : commands)
    if (!command.name.empty()) names.push_back(command.name);
  return names;
}

// Returns bash code that offers values of an option.
std::string bash_values(const CommandOption& option) {
  if (!option.choices.empty()) return fmt::format("-W {}", in_quotes(spaced(option.choices)));
  return option.value == "DIR" ? "-d" : "-W ''";
}

std::string bash_cases(const Command& command) {
  std::string text;
  for (const CommandOption& option : command.options) {
    if (option.value.empty() || option.nameless) continue;
    std::string names;
    for (const std::string& name : option.names)
      names += (names.empty() ? "" : "|") + command.name + ":" + name;
    text += fmt::format("    {}) _hackle_offer {}; return ;;\n", names, bash_values(option));
  }
  return text;
}

std::string bash_words(const Command& command, const std::vector<Command>& all) {
  const std::string names = spaced(option_names(command));
  if (!command.name.empty()) return fmt::format("    {}) words='{}' ;;\n", command.name, names);
  return fmt::format("    '') words='{} {}' ;;\n", spaced(command_names(all)), names);
}

constexpr std::string_view bash_head = R"(# bash completion for hackle
_hackle_offer() { mapfile -t COMPREPLY < <(compgen "$@" -- "${COMP_WORDS[COMP_CWORD]}"); }
_hackle() {
  local command='' words='' scripts
  [ "$COMP_CWORD" -gt 1 ] && command=${COMP_WORDS[1]}
  case $command in *.lua|-*) command=run ;; esac
  case "$command:${COMP_WORDS[COMP_CWORD-1]}" in
)";

constexpr std::string_view bash_tail = R"(  esac
  _hackle_offer -W "$words"
  case $command in ''|run|check)
    mapfile -t scripts < <(compgen -f -X '!*.lua' -- "${COMP_WORDS[COMP_CWORD]}"
                           compgen -d -- "${COMP_WORDS[COMP_CWORD]}")
    COMPREPLY+=("${scripts[@]}") ;;
  render|info|diff|export)
    mapfile -t scripts < <(compgen -f -- "${COMP_WORDS[COMP_CWORD]}")
    COMPREPLY+=("${scripts[@]}") ;;
  esac
}
complete -o filenames -F _hackle hackle
)";

std::string bash(const std::vector<Command>& commands) {
  std::string text(bash_head);
  for (const Command& command : commands) text += bash_cases(command);
  text += "  esac\n  case $command in\n";
  for (const Command& command : commands) text += bash_words(command, commands);
  return text.append(bash_tail);
}

// Returns "--peer[Compare with it]:NAME:(lammps none)".
std::string zsh_option(const CommandOption& option, const std::string& name) {
  std::string text = name + "[" + option.sentence + "]";
  if (option.value.empty()) return in_quotes(text);
  text += ":" + option.value + ":";
  if (!option.choices.empty()) return in_quotes(text + "(" + spaced(option.choices) + ")");
  return in_quotes(option.value == "DIR" ? text + "_files -/" : text);
}

std::string zsh_command(const Command& command) {
  std::string text = fmt::format("    {})\n      _arguments", command.name);
  for (const CommandOption& option : command.options) {
    if (option.nameless) continue;
    for (const std::string& name : option.names) text += " \\\n        " + zsh_option(option, name);
  }
  return text + " \\\n        '*:file:_files'\n      ;;\n";
}

std::string zsh(const std::vector<Command>& commands) {
  std::string list, cases;
  for (const Command& command : commands) {
    if (command.name.empty()) continue;
    list += "    " + in_quotes(command.name + ":" + command.sentence) + "\n";
    cases += zsh_command(command);
  }
  return "#compdef hackle\n"
         "_hackle() {\n"
         "  local -a commands=(\n" +
         list +
         "  )\n"
         "  if (( CURRENT == 2 )); then\n"
         "    _describe command commands\n"
         "    _files -g '*.lua'\n"
         "    return\n"
         "  fi\n"
         "  local command=$words[2]\n"
         "  case $command in *.lua|-*) command=run ;; esac\n"
         "  shift words\n"
         "  (( CURRENT-- ))\n"
         "  case $command in\n" +
         cases +
         "  esac\n"
         "}\n"
         "_hackle \"$@\"\n";
}

std::string fish_option(const CommandOption& option, const std::string& when) {
  std::string text = "complete -c hackle" + when;
  for (const std::string& name : option.names)
    text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (!option.value.empty() && option.value != "DIR") text += " -x";
  if (option.value == "DIR") text += " -r";
  if (!option.choices.empty()) text += " -a " + in_quotes(spaced(option.choices));
  return text + " -d " + in_quotes(option.sentence) + "\n";
}

std::string fish(const std::vector<Command>& commands) {
  std::string text = "# fish completion for hackle\n";
  for (const Command& command : commands) {
    if (!command.name.empty())
      text += fmt::format("complete -c hackle -n __fish_use_subcommand -a {} -d {}\n", command.name,
                          in_quotes(command.sentence));
    const std::string when =
        command.name.empty() ? " -n __fish_use_subcommand"
                             : fmt::format(" -n '__fish_seen_subcommand_from {}'", command.name);
    for (const CommandOption& option : command.options)
      if (!option.nameless) text += fish_option(option, when);
  }
  return text;
}

}  // namespace

std::string shell_completion(const std::vector<Command>& commands, std::string_view shell) {
  if (shell == "zsh") return zsh(commands);
  return shell == "fish" ? fish(commands) : bash(commands);
}

}  // namespace hackle
