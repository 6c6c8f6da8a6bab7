// SPDX-License-Identifier: MIT
#include "app/validation.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "base/stopwatch.hpp"
#include "base/text.hpp"
#include "console/console.hpp"
#include "console/schema/shell_value.hpp"

namespace hackle {
namespace fs = std::filesystem;
namespace {

constexpr std::array folders{"validation", "samples", "benchmarks", "gallery"};
constexpr std::string_view quick_option = "quick";

bool has(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

// Those of the quick validation say so in their header.
bool expects(const std::string& text, bool quick) {
  return has(text, "expect {") && (!quick || has(text, "hackle validate --quick"));
}

std::vector<ValidationScript> ready_scripts() {
  std::vector<ValidationScript> all;
  for (const char* folder : folders) {
    std::set<fs::path> sorted;
    for (const auto& entry : fs::directory_iterator(data_file(fs::path("scripts") / folder)))
      if (entry.path().extension() == ".lua") sorted.insert(entry.path());
    for (const fs::path& path : sorted)
      if (expects(read_text(path), false)) all.push_back({path.stem().string(), path});
  }
  return all;
}

[[noreturn]] void refuse(const std::string& name, const std::vector<ValidationScript>& all) {
  std::vector<std::string_view> known;
  known.reserve(all.size());
  for (const ValidationScript& script : all) known.push_back(script.name);
  throw Error(ErrorKind::usage,
              fmt::format("validate: there is no check '{}'{}", name, did_you_mean(name, known)),
              fmt::format("there are {}", comma_list(known)));
}

void add_named(const std::string& name, const std::vector<ValidationScript>& all,
               std::vector<ValidationScript>& chosen) {
  if (name.ends_with(".lua")) return chosen.push_back({fs::path(name).stem().string(), name});
  const std::size_t before = chosen.size();
  for (const ValidationScript& script : all)
    if (script.name.starts_with(name)) chosen.push_back(script);
  if (chosen.size() == before) refuse(name, all);
}

bool is_capital(char c) {
  return c >= 'A' && c <= 'Z';
}

// Returns where the sentence that begins there ends: at a full stop before a capital, or at the
// end.
std::size_t end_of_sentence(const std::string& line, std::size_t begin) {
  std::size_t end = line.find(". ", begin);
  while (end != std::string::npos && end + 2 < line.size() && !is_capital(line[end + 2]))
    end = line.find(". ", end + 1);
  return std::min(end, line.size());
}

// "-- hole.lua: the paper's third plate. A hole ..." -> "The paper's third plate"
std::string title_of(const std::string& text) {
  const std::string line = text.substr(0, text.find('\n'));
  const std::size_t begin = line.find(": ");
  if (!line.starts_with("--") || begin == std::string::npos) return "";
  std::string title = line.substr(begin + 2, end_of_sentence(line, begin + 2) - begin - 2);
  if (title.ends_with('.')) title.pop_back();
  if (!title.empty() && title[0] >= 'a' && title[0] <= 'z')
    title[0] = static_cast<char>(title[0] - 'a' + 'A');
  return title;
}

std::string place_of(const fs::path& path) {
  const fs::path folder = path.parent_path().filename();
  const bool ready = std::ranges::find(folders, folder.string()) != folders.end();
  return ready ? (fs::path("scripts") / folder / path.filename()).string() : path.string();
}

ConsoleSettings settings_for(const fs::path& folder, const Execution& execution) {
  ConsoleSettings settings;
  settings.output_folder = folder;
  settings.force = true;
  settings.checkpoint_every = 0.0;
  settings.execution = execution;
  settings.talk = Talk::quiet;
  settings.only_verdicts = true;
  return settings;
}

Expectation failed(const std::string& name, std::string reason) {
  Expectation check;
  check.name = name;
  check.quantity = "the script runs to its end";
  check.source = "the script";
  check.reason = std::move(reason);
  return check;
}

// Runs it; an error of anything but Ctrl-C is one more check, which failed.
void run(Console& console, Validated& result) {
  std::string reason;
  try {
    console.run_file(result.script.path);
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::interrupted) throw;
    reason = error.problems().front().what;
  }
  result.checks = console.expectations();
  if (reason.empty() && result.checks.empty()) reason = "it expects nothing";
  if (!reason.empty()) result.checks.push_back(failed(result.script.name, reason));
}

// The picture of the scene's own name, or else the first few.
std::vector<fs::path> pictures_of(const Console& console, const fs::path& folder,
                                  const std::string& name) {
  constexpr std::size_t enough = 4;
  const fs::path own = folder / (name + ".png");
  std::error_code ignored;
  if (fs::exists(own, ignored)) return {own};
  std::vector<fs::path> pictures;
  for (const Summary& summary : console.simulations())
    for (const fs::path& file : summary.files)
      if (file.extension() == ".png" && pictures.size() < enough) pictures.push_back(file);
  return pictures;
}

}  // namespace

std::vector<ValidationScript> validation_scripts(std::span<const std::string> names, bool quick) {
  const std::vector<ValidationScript> all = ready_scripts();
  std::vector<ValidationScript> chosen;
  for (const std::string& name : names) add_named(name, all, chosen);
  if (!names.empty()) return chosen;
  std::ranges::copy_if(all, std::back_inserter(chosen), [quick](const ValidationScript& script) {
    return expects(read_text(script.path), quick);
  });
  return chosen;
}

Validated validated(const ValidationScript& script, bool quick, const fs::path& folder,
                    const Execution& execution) {
  const std::string text = read_text(script.path);
  Validated result{script, title_of(text), place_of(script.path), {}, {}, 0.0};
  const fs::path own = folder / script.name;
  ConsoleSettings settings = settings_for(own, execution);
  if (quick && !option_expression(text, quick_option).empty())
    settings.overrides = {{std::string(quick_option), "true"}};
  {
    const Stopwatch watch(result.seconds);
    Console console(std::move(settings));
    run(console, result);
    result.pictures = pictures_of(console, own, script.name);
  }
  return result;
}

std::size_t count(std::span<const Validated> all, Verdict verdict) {
  std::size_t sum = 0;
  for (const Validated& one : all)
    sum += static_cast<std::size_t>(std::ranges::count(one.checks, verdict, &Expectation::verdict));
  return sum;
}

}  // namespace hackle
