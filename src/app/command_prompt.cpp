// SPDX-License-Identifier: MIT
#include "app/command_prompt.hpp"

#include <memory>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

#include "app/exit_code.hpp"
#include "app/voice.hpp"
#include "base/child_process.hpp"
#include "base/interrupt.hpp"
#include "base/machine.hpp"
#include "base/ranks/mpi_module.hpp"
#include "base/streams.hpp"
#include "base/terminal.hpp"
#include "base/text.hpp"
#include "base/version.hpp"
#include "console/prompt/line_reader.hpp"
#include "console/prompt/pager.hpp"
#include "console/prompt/prompt.hpp"

namespace hackle {
namespace {

Prompt::Reader line_reader(const std::shared_ptr<LineEditor>& editor) {
  if (!editor) {
    const auto reader = std::make_shared<LineReader>();
    return [reader](const std::string&, std::string& line, const Idle& idle) {
      return reader->read(line, idle);
    };
  }
  print_out("{}\n", fitted(fmt::format("Hackle {}  -  help() tells more, Ctrl-D leaves", version()),
                           terminal_columns(STDOUT_FILENO)));
  return [editor](const std::string& prompt, std::string& line, const Idle& idle) {
    return editor->read(prompt, line, idle);
  };
}

// Nothing runs in the background meanwhile: ranks do the same between the same lines.
Prompt::Reader shared(Ranks& ranks, Prompt::Reader reader) {
  return [&ranks, reader = std::move(reader)](const std::string& prompt, std::string& line,
                                              const Idle&) {
    std::string told;
    if (ranks.leads()) {
      const LineEnd end = reader(prompt, line, [](const MakeRoom&) { return false; });
      told = static_cast<char>(end) + line;
    }
    ranks.share(told);
    line = told.substr(1);
    return static_cast<LineEnd>(told.front());
  };
}

void print_note(const std::string& note) {
  say_note(note);
}

void print_value(const std::string& value) {
  print_out("{}\n", stdout_is_terminal() ? fitted(value, terminal_columns(STDOUT_FILENO)) : value);
  flush(stdout);
}

}  // namespace

int ask(Console& console, const Company& company, int code) {
  const InterruptHandler handler(InterruptHandler::Keyboard::left_alone);
  Ranks* ranks = company.ranks();
  const bool person = ranks == nullptr && isatty(STDIN_FILENO) != 0;
  const auto editor = person ? std::make_shared<LineEditor>(history_file()) : nullptr;
  Prompt::Reader reader = line_reader(editor);
  if (ranks != nullptr) reader = shared(*ranks, std::move(reader));
  Prompt prompt(console, std::move(reader), {print_value, tell, print_note});
  if (editor)
    editor->complete_with(
        [&](const std::string& before) { return console.complete(prompt.begun() + before); });
  if (person && stdout_is_terminal()) console.page_with(show_in_pages);
  const int first_error = prompt.run();
  // A person has seen the errors; a program that feeds lines needs the exit code.
  if (!person && !asked_to_leave()) console.finish_work();
  if (person) code = console.exit_code().value_or(0);
  if (!person && code == 0) code = first_error;
  if (asked_to_leave()) code = static_cast<int>(ErrorKind::interrupted);
  const int closing = exit_code_of([&] {
    console.close_all();
    return 0;
  });
  tell_files(console.simulations());
  return code != 0 ? code : closing;
}

int command_prompt(const Limits& limits) {
  return exit_code_of([&limits] {
    const Company company(find_ranks(0.0));
    ConsoleSettings settings;
    settings.program = this_program();
    settings.output_folder = "out/prompt";
    settings.talk = talk(false);
    settings.show_in_terminal = stdout_is_terminal();
    limits.apply(settings);
    company.join(settings);
    Console console(settings);
    return company.leave(ask(console, company));
  });
}

}  // namespace hackle
