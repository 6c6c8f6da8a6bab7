// SPDX-License-Identifier: MIT
#include "app/man_page.hpp"

#include <array>
#include <string_view>

#include <fmt/format.h>

#include "app/exit_code.hpp"
#include "base/markup.hpp"
#include "base/version.hpp"
#include "console/reference/reference_pages.hpp"

namespace hackle {
namespace {

struct Variable {
  std::string_view name;
  std::string_view sentence;
};

constexpr std::array variables{
    Variable{"HACKLE_DATA", "Folder with shaders and assets, instead of the installed ones."},
    Variable{"NO_COLOR", "If it is set and not empty, messages have no colour."},
    Variable{"XDG_STATE_HOME",
             "The prompt keeps its history in hackle/history below it, or below ~/.local/state."},
};

std::string sentence(const std::string& text) {
  return text.ends_with('.') ? text : text + ".";
}

std::string roff_options(const Command& command) {
  std::string text;
  for (const CommandOption& option : command.options)
    text += fmt::format(".TP\n{}\n{}\n", roff_code(usage(option)), roff(sentence(option.sentence)));
  return text;
}

std::string roff_commands(const std::vector<Command>& commands) {
  std::string text;
  for (const Command& command : commands) {
    text += command.name.empty()
                ? ".SH OPTIONS\n" + roff_options(command) + ".SH COMMANDS\n"
                : fmt::format(".SS {}\n{}\n{}", synopsis(command), roff(sentence(command.sentence)),
                              roff_options(command));
    if (!command.name.empty() && !command.footer.empty())
      text += ".PP\n" + roff(command.footer) + "\n";
  }
  return text;
}

std::string roff_exit_codes() {
  std::string text = ".SH EXIT STATUS\n";
  for (const ExitCode& code : exit_codes())
    text += fmt::format(".TP\n{}\n{}.\n", code.number, roff(code.meaning));
  return text;
}

std::string roff_variables() {
  std::string text = ".SH ENVIRONMENT\n";
  for (const Variable& variable : variables)
    text += fmt::format(".TP\n{}\n{}\n", roff_code(variable.name), roff(variable.sentence));
  return text;
}

std::string roff_synopsis(const std::vector<Command>& commands) {
  std::string text = ".SH SYNOPSIS\n.nf\n";
  for (const Command& command : commands) text += roff_code(synopsis(command)) + "\n";
  return text + ".fi\n";
}

std::string markdown_command(const Command& command) {
  std::string text =
      fmt::format("### `{}`\n\n{}\n\n", synopsis(command), markdown(sentence(command.sentence)));
  if (!command.options.empty()) text += "| | |\n|---|---|\n";
  for (const CommandOption& option : command.options)
    text += fmt::format("| {} | {} |\n", markdown_code(usage(option)), markdown(option.sentence));
  return text + (command.footer.empty() ? "\n" : "\n" + command.footer + "\n\n");
}

}  // namespace

std::string man_page(const std::vector<Command>& commands) {
  const Command& hackle = commands.front();
  return fmt::format(".TH HACKLE 1 \"\" \"Hackle {}\" \"User Commands\"\n", version()) +
         ".SH NAME\nhackle \\- breaks thin brittle plates with peridynamics and films it\n" +
         roff_synopsis(commands) + ".SH DESCRIPTION\n" + roff(hackle.sentence) + "\n" +
         roff(hackle.footer) + "\n" + roff_commands(commands) + roff_reference() +
         roff_exit_codes() + roff_variables();
}

std::string markdown_page(const std::vector<Command>& commands) {
  std::string text = fmt::format(
      "# Reference of Hackle {}\n\nWritten by `hackle docs` from the tables that check what is "
      "written in a script and on the command line.\n\n## Command line\n\n",
      version());
  for (const Command& command : commands) text += markdown_command(command);
  text += "### Exit codes\n\n| | |\n|---|---|\n";
  for (const ExitCode& code : exit_codes())
    text += fmt::format("| {} | {} |\n", code.number, markdown(code.meaning));
  return text + "\n" + markdown_reference();
}

}  // namespace hackle
