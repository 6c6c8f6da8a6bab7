// SPDX-License-Identifier: MIT
#include "app/command_validate.hpp"

#include <algorithm>
#include <cstdio>
#include <span>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/exit_code.hpp"
#include "app/validation_page.hpp"
#include "app/voice.hpp"
#include "base/error.hpp"
#include "base/files.hpp"
#include "base/interrupt.hpp"
#include "base/progress.hpp"
#include "base/streams.hpp"
#include "base/text.hpp"
#include "base/version.hpp"

namespace hackle {
namespace {

using Json = nlohmann::ordered_json;

void print(const Validated& one) {
  print_out("{}{}{}  ({:.1f} s)\n", one.script.name, one.title.empty() ? "" : ": ", one.title,
            one.seconds);
  for (const Expectation& check : one.checks) print_out("  {}\n", line_of(check));
  flush(stdout);
}

std::vector<Validated> run_all(const ValidateRequest& request) {
  const std::vector<ValidationScript> scripts = validation_scripts(request.names, request.quick);
  std::vector<Validated> all;
  Progress progress(talk(request.quiet));
  for (const ValidationScript& script : scripts) {
    const double fraction = static_cast<double>(all.size()) / static_cast<double>(scripts.size());
    if (progress.due(fraction))
      progress.show(fraction,
                    fmt::format("{} of {}, {}", all.size() + 1, scripts.size(), script.name));
    all.push_back(validated(script, request.quick, request.folder, request.execution));
    if (!request.json && !request.quiet) print(all.back());
  }
  return all;
}

Json json_of(std::span<const Validated> all, bool quick) {
  Json json{{"schema", 1}, {"version", version()}, {"git", git_hash()}, {"quick", quick}};
  json["checks"] = Json::array();
  for (const Validated& one : all)
    for (const Expectation& check : one.checks) json["checks"].push_back(to_json(check));
  json["scripts"] = Json::array();
  for (const Validated& one : all)
    json["scripts"].push_back(
        {{"name", one.script.name}, {"file", one.place}, {"seconds", one.seconds}});
  return json;
}

void write_page(std::span<const Validated> all, const ValidateRequest& request) {
  const std::filesystem::path page = request.folder / "validate.html";
  make_folder_of(page);
  write_text(page, validation_page(all, request.quick));
  if (!request.quiet) tell_file(page);
  for (const std::filesystem::path& file : request.tables) {
    write_text(file, with_tables(read_text(file), all, file));
    if (!request.quiet) tell_file(file);
  }
}

std::string totals_of(std::span<const Validated> all) {
  return fmt::format("{} pass, {} fail, {} unsupported", count(all, Verdict::pass),
                     count(all, Verdict::fail), count(all, Verdict::unsupported));
}

}  // namespace

int command_validate(const ValidateRequest& request) {
  const InterruptHandler handler;
  return exit_code_of([&] {
    for (const std::filesystem::path& file : request.tables)
      with_tables(read_text(file), {}, file);  // refuses before anything is run
    const std::vector<Validated> all = run_all(request);
    if (request.json)
      print_out("{}\n",
                json_of(all, request.quick).dump(-1, ' ', false, Json::error_handler_t::replace));
    else
      print_out("{}\n", totals_of(all));
    flush(stdout);
    write_page(all, request);
    return count(all, Verdict::fail) > 0 ? static_cast<int>(ErrorKind::run_failed) : 0;
  });
}

}  // namespace hackle
