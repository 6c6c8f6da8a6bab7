// SPDX-License-Identifier: MIT
#include "app/command_chart.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <memory>
#include <string_view>

#include <fmt/format.h>

#include "app/exit_code.hpp"
#include "app/voice.hpp"
#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "base/streams.hpp"
#include "base/text.hpp"
#include "console/console.hpp"
#include "output/chart/chart.hpp"
#include "output/chart/chart_kind.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 3> source_endings{".h5", ".hdf5", ".csv"};
constexpr std::array<std::string_view, 3> chart_endings{".png", ".pdf", ".svg"};

bool ends_in_one_of(const std::string& name, std::span<const std::string_view> endings) {
  std::string end = fs::path(name).extension().string();
  std::ranges::transform(end, end.begin(), [](unsigned char c) { return std::tolower(c); });
  return std::ranges::find(endings, end) != endings.end();
}

std::string default_output(const ChartJob& job) {
  std::string what;
  for (const std::string& name : job.what) what += fmt::format("-{}", name);
  std::ranges::replace(what, '.', '_');
  return fs::path(job.sources.front()).stem().string() + what + ".png";
}

std::string script_of_chart(const ChartJob& job) {
  std::string sources, what;
  for (const std::string& source : job.sources)
    sources += fmt::format("{}{}", sources.empty() ? "" : ", ", quoted(source));
  for (const std::string& name : job.what) what += fmt::format(", {}", quoted(name));
  return fmt::format("chart {{ {}{}{}, of = {{ {} }} }}", quoted(job.out), what,
                     lua_text("chart", job.options, doc_of("", "chart")), sources);
}

// The user's own words are trusted.
ConsoleSettings chart_settings(const ChartRequest& request) {
  ConsoleSettings settings;
  settings.output_folder = ".";
  settings.talk = talk(request.quiet);
  settings.trust = true;
  return settings;
}

ChartSource opened(const fs::path& path) {
  if (path.extension() == ".csv") return ChartSource(path);
  return ChartSource(std::make_shared<Recording>(path));
}

// Lists the kinds of charts and the columns of the tables in the files.
void tell_what_can_be_drawn(const ChartJob& job) {
  for (const std::string& source : job.sources) {
    std::vector<std::string> names = opened(source).names();
    const std::vector<std::string_view> listed(names.begin(), names.end());
    print_out("{}: {}\n", printable(source),
              listed.empty() ? "no table; columns come from its records" : comma_list(listed));
  }
  std::vector<std::string_view> kinds;
  for (const ChartKind& kind : chart_kinds()) kinds.push_back(kind.name);
  print_out("charts: {}\nnext: hackle chart {} energy\n", comma_list(kinds),
            shell_word(job.sources.front()));
}

}  // namespace

ChartJob chart_job(const std::vector<std::string>& words) {
  ChartJob job;
  for (const std::string& word : words) {
    if (is_option(word)) {
      job.options.push_back(option_in(word));
    } else if (ends_in_one_of(word, source_endings)) {
      job.sources.push_back(word);
    } else if (ends_in_one_of(word, chart_endings)) {
      if (!job.out.empty())
        throw Error(ErrorKind::usage,
                    fmt::format("chart: '{}' and '{}' are to be written", job.out, word),
                    "name one picture at a time");
      job.out = word;
    } else {
      job.what.push_back(word);
    }
  }
  if (job.sources.empty())
    throw Error(ErrorKind::usage, "chart: there is neither a run file nor a table",
                "as in hackle chart run.h5 energy");
  if (job.what.empty() && !job.out.empty()) job.what.emplace_back("energy");
  if (job.what.empty() && !job.options.empty())
    throw Error(ErrorKind::usage, "chart: it is not clear what to draw",
                "name it after the file, as in hackle chart run.h5 energy");
  if (job.out.empty()) job.out = default_output(job);
  return job;
}

int command_chart(const ChartRequest& request) {
  const InterruptHandler handler;
  return exit_code_of([&] {
    const ChartJob job = chart_job(request.words);
    if (job.what.empty()) {
      tell_what_can_be_drawn(job);
      return 0;
    }
    Console console(chart_settings(request));
    check_values(console, "chart", job.options, doc_of("", "chart"));
    console.evaluate(script_of_chart(job));
    if (request.quiet) return 0;
    for (const fs::path& file : {fs::path(job.out), table_of_chart(job.out)}) tell_file(file);
    return 0;
  });
}

}  // namespace hackle
