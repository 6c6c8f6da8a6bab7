// SPDX-License-Identifier: MIT
#include "app/command_run.hpp"

#include <optional>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/command_prompt.hpp"
#include "app/company.hpp"
#include "app/exit_code.hpp"
#include "app/voice.hpp"
#include "base/child_process.hpp"
#include "base/files.hpp"
#include "base/interrupt.hpp"
#include "base/machine.hpp"
#include "base/ranks/mpi_module.hpp"
#include "base/streams.hpp"
#include "base/terminal.hpp"
#include "console/console.hpp"
#include "output/files/output_names.hpp"
#include "store/checkpoint.hpp"

namespace hackle {

ConsoleSettings settings_of(const RunRequest& request) {
  ConsoleSettings settings;
  settings.output_folder = request.output_folder;
  if (request.output_folder.empty() && !request.text.empty())
    settings.output_folder = "out/command";
  if (request.output_folder.empty() && request.script == "-") settings.output_folder = "out/stdin";
  settings.overrides = request.overrides;
  settings.program = this_program();
  settings.execution = request.execution;
  settings.talk = talk(request.quiet);
  settings.force = request.force;
  settings.fresh = request.fresh;
  settings.checkpoint_every = request.checkpoint_every;
  settings.print_to_stderr = request.json;
  settings.only_verdicts = settings.no_pictures = request.bare;
  settings.sample_at = request.sample_at;
  settings.last_picture = request.picture;
  settings.show_in_terminal = stdout_is_terminal() && !request.json;
  request.limits.apply(settings);
  return settings;
}

Found checkpoint_of(const RunRequest& request) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (!fs::is_directory(request.resumed, ignored))
    return {request.resumed, continuation_of(read_continuation(request.resumed), request.resumed)};
  std::vector<std::string> damaged;
  std::optional<Found> found = find_continuation(request.resumed, "", damaged);
  if (found && !OutputFolder::is_finished(request.resumed, found->continuation.inputs.script))
    return std::move(*found);
  Problems problems;
  problems.add(fmt::format("folder '{}' has no run that was stopped", request.resumed.string()),
               "name the folder of its output, as in hackle resume out/plate");
  for (std::string& problem : damaged) problems.add(std::move(problem));
  problems.throw_if_any(ErrorKind::files);
  return {};
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
  auto json = json_of(console.simulations(), request.script.string(),
                      request.sample_at ? SummaryDetail::paths : SummaryDetail::usual);
  json["expectations"] = nlohmann::ordered_json::array();
  for (const Expectation& one : console.expectations())
    json["expectations"].push_back(to_json(one));
  print_out("{}\n", json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

// They hold for the script's own options. A quiet run tells only those that fail.
void print_verdicts(const std::vector<Expectation>& all, const RunRequest& request) {
  if (all.empty()) return;
  if (!request.quiet && !request.overrides.empty())
    say_note("expectations are those of the script without --set");
  for (const Expectation& one : all)
    if (!request.quiet || one.verdict() == Verdict::fail) print_out("{}\n", line_of(one));
}

}  // namespace

namespace {

int run_in_company(RunRequest request, const Company& company) {
  std::optional<Found> found;
  if (!request.resumed.empty()) {
    found = checkpoint_of(request);
    request.output_folder = found->checkpoint.parent_path();
    request.overrides = found->continuation.inputs.overrides;
    request.script = found->continuation.origin.script_name;
  }
  if (!request.picture.empty()) check_ending("--picture", request.picture, FileKind::picture);
  ConsoleSettings settings = settings_of(request);
  company.join(settings);
  Console console(std::move(settings));
  const int code = exit_code_of([&] {
    const InterruptHandler handler;
    if (found)
      console.run_on(std::move(*found));
    else
      run(console, request);
    return console.exit_code().value_or(0);
  });
  if (request.interactive) return ask(console, company, code);
  if (!request.quiet) tell_files(console.simulations());
  const bool ended = code == 0 || code == static_cast<int>(ErrorKind::interrupted);
  if (request.json && ended) print_json(console, request);
  if (!request.json && code == 0) print_verdicts(console.expectations(), request);
  return code;
}

}  // namespace

int command_run(const RunRequest& request) {
  return exit_code_of([&] {
    const Company company(find_ranks(request.interactive ? 0.0 : request.patience));
    return company.leave(exit_code_of([&] { return run_in_company(request, company); }));
  });
}

nlohmann::ordered_json json_of(const std::vector<Summary>& simulations, const std::string& script,
                               SummaryDetail detail) {
  auto list = nlohmann::ordered_json::array();
  for (const Summary& summary : simulations) list.push_back(to_json(summary, detail));
  if (list.empty()) return {{"schema", 1}, {"script", script}, {"simulations", list}};
  nlohmann::ordered_json json = list.back();
  if (list.size() > 1) json["simulations"] = std::move(list);
  return json;
}

}  // namespace hackle
