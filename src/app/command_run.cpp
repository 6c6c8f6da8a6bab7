// SPDX-License-Identifier: MIT
#include "app/command_run.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/command_prompt.hpp"
#include "app/exit_code.hpp"
#include "app/voice.hpp"
#include "base/files.hpp"
#include "base/interrupt.hpp"
#include "base/machine.hpp"
#include "base/streams.hpp"
#include "console/console.hpp"

namespace hackle {

ConsoleSettings settings_of(const RunRequest& request) {
  ConsoleSettings settings;
  settings.output_folder = request.output_folder;
  if (request.output_folder.empty() && !request.text.empty())
    settings.output_folder = "out/command";
  if (request.output_folder.empty() && request.script == "-") settings.output_folder = "out/stdin";
  settings.overrides = request.overrides;
  settings.execution = request.execution;
  settings.talk = talk(request.quiet);
  settings.force = request.force;
  settings.checkpoint_every = request.checkpoint_every;
  settings.print_to_stderr = request.json;
  settings.show_in_terminal = stdout_is_terminal() && !request.json;
  request.limits.apply(settings);
  return settings;
}

void run(Console& console, const RunRequest& request) {
  const Ending ending = request.interactive ? Ending::go_on : Ending::close;
  if (!request.text.empty())
    console.run_text(request.text, "-e", request.arguments, ending);
  else if (request.script == "-")
    console.run_text(read_text("/dev/stdin"), "stdin", request.arguments, ending);
  else
    console.run_file(request.script, request.arguments, ending);
}

namespace {

void print_json(const Console& console, const RunRequest& request) {
  print_out("{}\n", json_of(console.simulations(), request.script.string()).dump());
}

}  // namespace

int command_run(const RunRequest& request) {
  return exit_code_of([&] {
    Console console(settings_of(request));
    const int code = exit_code_of([&] {
      const InterruptHandler handler;
      run(console, request);
      return console.exit_code().value_or(0);
    });
    if (request.interactive) return ask(console, code);
    if (!request.quiet) tell_files(console.simulations());
    const bool ended = code == 0 || code == static_cast<int>(ErrorKind::interrupted);
    if (request.json && ended) print_json(console, request);
    return code;
  });
}

nlohmann::ordered_json json_of(const std::vector<Summary>& simulations, const std::string& script) {
  auto list = nlohmann::ordered_json::array();
  for (const Summary& summary : simulations) list.push_back(to_json(summary));
  if (list.empty()) return {{"schema", 1}, {"script", script}, {"simulations", list}};
  nlohmann::ordered_json json = list.back();
  if (list.size() > 1) json["simulations"] = std::move(list);
  return json;
}

}  // namespace hackle
