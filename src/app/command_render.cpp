// SPDX-License-Identifier: MIT
#include "app/command_render.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include <fmt/format.h>

#include "app/exit_code.hpp"
#include "app/voice.hpp"
#include "app/word_options.hpp"
#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "base/streams.hpp"
#include "base/text.hpp"
#include "console/console.hpp"
#include "console/schema/shell_value.hpp"
#include "movie/movie_kind.hpp"

namespace hackle {
namespace {

bool ends_in(const std::string& name, std::string_view ending) {
  std::string end = std::filesystem::path(name).extension().string();
  std::ranges::transform(end, end.begin(), [](unsigned char c) { return std::tolower(c); });
  return end == ending;
}

bool is_run_file(const std::string& name) {
  return ends_in(name, ".h5") || ends_in(name, ".hdf5");
}

constexpr std::array<std::string_view, 3> picture_endings{".png", ".pdf", ".svg"};

void check_out(const std::string& name) {
  std::vector<std::string_view> endings(picture_endings.begin(), picture_endings.end());
  for (const MovieKind& kind : movie_kinds()) endings.push_back(kind.ending);
  if (std::ranges::any_of(endings, [&](std::string_view ending) { return ends_in(name, ending); }))
    return;
  const std::string ending = std::filesystem::path(name).extension().string();
  throw Error(ErrorKind::refused,
              fmt::format("render: '{}' is neither a picture nor a movie{}", name,
                          did_you_mean(ending, endings)),
              "one of " + comma_list(endings));
}

// Returns the function that makes the requested output.
const FunctionDoc& function_for(const RenderJob& job) {
  const auto has = [&](std::string_view name) {
    return std::ranges::any_of(job.options, [&](const auto& given) { return given.first == name; });
  };
  const bool picture = std::ranges::any_of(
      picture_endings, [&](std::string_view ending) { return ends_in(job.out, ending); });
  if (picture && (job.runs.size() > 1 || has("times"))) return doc_of("", "contact_sheet");
  if (job.runs.size() > 1) return doc_of("", "side_by_side");
  return picture ? doc_of("r", "frame") : doc_of("r", "movie");
}

std::string recordings_text(const std::vector<std::string>& runs) {
  std::string text;
  for (const std::string& run : runs)
    text += fmt::format("{}recording {}", text.empty() ? "" : ", ", quoted(run));
  return text;
}

ConsoleSettings settings_of(const RenderRequest& request) {
  ConsoleSettings settings;
  settings.output_folder = ".";
  settings.execution = request.execution;
  settings.talk = talk(request.quiet);
  settings.trust = true;  // the script consists of the user's own words
  return settings;
}

// Describes a run file, and what can be made of it.
void tell_of(Console& console, const std::string& run) {
  print_out("{}: {}\n", run, printable(console.evaluate("recording " + quoted(run)).at(0)));
  const std::string script = printable(console.evaluate("_.script").at(0));
  if (!script.empty()) print_out("  made by {}\n", script);
}

void tell_what_is_there(Console& console, const RenderJob& job) {
  for (const std::string& run : job.runs) tell_of(console, run);
  const std::string run = shell_word(job.runs.front());
  const std::filesystem::path stem = std::filesystem::path(job.runs.front()).stem();
  print_out(
      "next: hackle render {} {} field=stress_1\n"
      "      hackle render {} {} field=von_mises percentile=99\n",
      run, shell_word(stem.string() + ".png"), run, shell_word(stem.string() + ".mp4"));
}

}  // namespace

RenderJob render_job(const std::vector<std::string>& words) {
  RenderJob job;
  for (const std::string& word : words) {
    if (is_option(word))
      job.options.push_back(option_in(word));
    else
      job.runs.push_back(word);
  }
  if (job.runs.empty())
    throw Error(ErrorKind::usage, "render: there is no run file",
                "as in hackle render run.h5 picture.png");
  if (job.runs.size() > 1 && !is_run_file(job.runs.back())) {
    job.out = job.runs.back();
    job.runs.pop_back();
  }
  if (job.out.empty() && !job.options.empty())
    throw Error(ErrorKind::usage, "render: there is no file to write",
                "name it after the run file, as in hackle render run.h5 picture.png");
  return job;
}

std::string script_of(const RenderJob& job) {
  const FunctionDoc& doc = function_for(job);
  const std::string rest = quoted(job.out) + lua_text("render", job.options, doc);
  if (doc.owner == "r")
    return fmt::format("({}):{} {{ {} }}", recordings_text(job.runs), doc.name, rest);
  return fmt::format("{} {{ {}, recordings = {{ {} }} }}", doc.name, rest,
                     recordings_text(job.runs));
}

int command_render(const RenderRequest& request) {
  const InterruptHandler handler;
  return exit_code_of([&] {
    const RenderJob job = render_job(request.words);
    Console console(settings_of(request));
    if (job.out.empty()) {
      tell_what_is_there(console, job);
      return 0;
    }
    check_out(job.out);
    check_values(console, "render", job.options, function_for(job));
    console.evaluate(script_of(job));
    if (!request.quiet) tell_file(job.out);
    return 0;
  });
}

}  // namespace hackle
