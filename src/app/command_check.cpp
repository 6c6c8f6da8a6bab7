// SPDX-License-Identifier: MIT
#include "app/command_check.hpp"

#include <optional>

#include <fmt/format.h>

#include "app/exit_code.hpp"
#include "base/interrupt.hpp"
#include "base/streams.hpp"
#include "console/console.hpp"

namespace hackle {
namespace {

ConsoleSettings settings_for(Purpose purpose, const RunRequest& request) {
  ConsoleSettings settings = settings_of(request);
  settings.purpose = purpose;
  settings.talk = Talk::quiet;
  return settings;
}

// An error of the script itself after its simulations may be due to missing results.
std::optional<Error> failure_of_script(Console& console, const RunRequest& request) {
  try {
    run(console, request);
    return std::nullopt;
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::script || console.simulations().empty()) throw;
    return error;
  }
}

}  // namespace

int command_check(const RunRequest& request) {
  const InterruptHandler handler;
  return exit_code_of([&] {
    Console console(settings_for(Purpose::check, request));
    const auto failure = failure_of_script(console, request);
    int number = 0;
    for (const Rehearsal& rehearsal : console.rehearsals())
      print_out("simulation {}\n{}\n", ++number, describe(rehearsal));
    if (number == 0) print_out("the script makes no simulation\n");
    if (failure)
      print_out("the script then needs results: {}\nthe rest is unknown\n",
                failure->problems().front().what);
    return console.exit_code().value_or(0);
  });
}

std::string options_text(const RunRequest& request) {
  Console console(settings_for(Purpose::options, request));
  run(console, request);
  const std::string name = request.script.filename().string();
  if (console.options().empty()) return fmt::format("{} has no options for --set.\n", name);
  std::string text = fmt::format("Options of {}, for --set:\n", name);
  for (const auto& [option, fallback] : console.options())
    text += fmt::format("  {} = {}\n", option, fallback);
  return text;
}

}  // namespace hackle
