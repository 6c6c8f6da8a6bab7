// SPDX-License-Identifier: MIT
#include "app/command_line.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/command_bench.hpp"
#include "app/command_chart.hpp"
#include "app/command_check.hpp"
#include "app/command_diff.hpp"
#include "app/command_docs.hpp"
#include "app/command_export.hpp"
#include "app/command_info.hpp"
#include "app/command_new.hpp"
#include "app/command_prompt.hpp"
#include "app/command_render.hpp"
#include "app/command_replay.hpp"
#include "app/command_run.hpp"
#include "app/command_validate.hpp"
#include "app/exit_code.hpp"
#include "app/libraries.hpp"
#include "app/shell_completion.hpp"
#include "app/study_kinds.hpp"
#include "app/voice.hpp"
#include "base/streams.hpp"
#include "base/text.hpp"
#include "base/version.hpp"

namespace hackle {
namespace {

constexpr std::array<std::string_view, 14> commands{
    "run",    "resume", "check", "render",   "chart", "replay", "diff",
    "export", "new",    "bench", "validate", "study", "info",   "docs"};
constexpr int max_threads = 1024;

// The parsed command line.
struct Request {
  RunRequest run;
  RenderRequest render;
  ChartRequest chart;
  ReplayRequest replay;
  BenchRequest bench;
  ValidateRequest validate;
  std::vector<std::string> settings;
  std::string new_name;
  InfoRequest info;
  DiffRequest diff;
  ExportRequest exported;
  DocsRequest docs;
  StudyAction study;
};

bool is_command(const std::string& word) {
  return std::ranges::find(commands, word) != commands.end();
}

// Removes the words after "--" and returns them.
std::vector<std::string> cut_script_arguments(std::vector<std::string>& words) {
  const auto dashes = std::ranges::find(words, "--");
  if (dashes == words.end()) return {};
  std::vector<std::string> arguments(std::next(dashes), words.end());
  words.erase(dashes, words.end());
  return arguments;
}

std::string version_text() {
  return fmt::format("hackle {} (git {}), compiled by {}\n{}", version(), git_hash(), compiler(),
                     libraries_line());
}

std::string check_setting(const std::string& setting) {
  const std::size_t equals = setting.find('=');
  return equals == 0 || equals == std::string::npos ? "'" + setting + "' is not key=value" : "";
}

// Options of execution, which do not change a single bit of the results.
void describe_execution(CLI::App& command, Execution& execution) {
  command.add_option("-j,--threads", execution.threads, "Number of threads (one per core)")
      ->type_name("N")
      ->check(CLI::Range(1, max_threads));
  std::vector<std::string> names;
  for (std::size_t set = 0; set < instruction_set_names.size(); ++set)
    if (is_supported(static_cast<InstructionSet>(set)))
      names.emplace_back(instruction_set_names[set]);
  const auto choose = [&execution](const std::string& name) {
    const auto set = std::ranges::find(instruction_set_names, name);
    execution.instruction_set = static_cast<InstructionSet>(set - instruction_set_names.begin());
  };
  command
      .add_option_function<std::string>("--instructions", choose,
                                        "Instruction set (the best available)")
      ->type_name("NAME")
      ->check(CLI::IsMember(names));
}

// Options that limit what a script may do to this machine.
void describe_limits(CLI::App& command, Limits& limits) {
  command.add_flag("--trust", limits.trust,
                   "Allow the script all of Lua's library, any file, and other programs");
  command
      .add_option("--lua-memory", limits.lua_memory, "Memory limit of its Lua values in MB (1024)")
      ->type_name("MB")
      ->check(CLI::Range(1, 1 << 20));
  command
      .add_option("--output-limit", limits.output,
                  "Limit on the estimated size of a simulation's movies and records in GB (20)")
      ->type_name("GB")
      ->check(CLI::Range(0.001, 1e6));
}

void describe_script(CLI::App& command, Request& request) {
  CLI::Option* file =
      command.add_option("FILE", request.run.script, "The script; - reads it from stdin");
  command.add_option("-e", request.run.text, "Run this text in place of a script")
      ->type_name("TEXT")
      ->excludes(file);
  command
      .add_option("-o,--output", request.run.output_folder,
                  "Folder for output files (out/<name of the script>)")
      ->type_name("DIR");
  command
      .add_option(
          "--set", request.settings,
          "Override an option of the script, simulate.KEY of every simulate, or material.KEY "
          "and scatter.KEY of its plate; repeatable")
      ->type_name("key=value")
      ->check(check_setting, "")
      ->take_all()
      ->allow_extra_args(false);
  describe_execution(command, request.run.execution);
  describe_limits(command, request.run.limits);
}

void describe_check(CLI::App& app, Request& request) {
  CLI::App* check = app.add_subcommand(
      "check", "Estimate the time and memory of a script, and whether anything can break");
  describe_script(*check, request);
}

void describe_new(CLI::App& app, Request& request) {
  CLI::App* command = app.add_subcommand("new", "Write a script to start from");
  command->add_option("NAME", request.new_name, "Name of the script")->required();
}

// Options of what runs a script to its end.
void describe_running(CLI::App& command, RunRequest& request) {
  command.add_flag("--json", request.json, "Print one JSON object with the results on stdout");
  command.add_flag("-q,--quiet", request.quiet, "Print only errors");
  command
      .add_option(
          "--checkpoint", request.checkpoint_every,
          "Wall time between checkpoints, as in 10min or 0.5s, from which the same command or "
          "hackle resume goes on; 0s for none (10min)")
      ->type_name("TIME")
      ->transform(CLI::AsNumberWithUnit(
          std::map<std::string, double>{{"s", 1.0}, {"min", 60.0}, {"h", 3600.0}},
          CLI::AsNumberWithUnit::UNIT_REQUIRED))
      ->check(CLI::Range(0.0, 1e9));
  command
      .add_option("--rank-timeout", request.patience,
                  "Under mpirun: seconds that a rank waits for another before it ends all (120); 0 "
                  "waits for ever")
      ->type_name("S")
      ->check(CLI::Range(0.0, 1e9));
}

void describe_resume(CLI::App& app, Request& request) {
  CLI::App* resume = app.add_subcommand(
      "resume", "Go on with a script that was interrupted, failed or was killed");
  resume
      ->add_option("FILE", request.run.resumed,
                   "Its checkpoint, .ckpt, or the folder of its output")
      ->required();
  describe_running(*resume, request.run);
  describe_execution(*resume, request.run.execution);
  describe_limits(*resume, request.run.limits);
  resume->footer(
      "The script is run again up to where it stopped, without computing, and every value that it\n"
      "reads is the one that it read. It must lie where it lay, or nowhere: then its text is used\n"
      "as it was.");
}

void describe_run(CLI::App& app, Request& request) {
  CLI::App* run = app.add_subcommand("run", "Run a script");
  describe_script(*run, request);
  describe_running(*run, request.run);
  run->add_flag("--fresh", request.run.fresh,
                "Begin anew; without it a run that was stopped goes on where it was");
  run->add_flag("--force", request.run.force,
                "Overwrite the files of an earlier run with other options; without it they go to "
                "a folder of their own, out/NAME-2, or -o is refused");
  run->add_flag("--bare", request.run.bare,
                "Print nothing of the script's own, and make no movies, pictures and records");
  run->add_option("--picture", request.run.picture,
                  "Also make a picture, .png, .pdf or .svg, of the damage at the end of the last "
                  "simulation")
      ->type_name("FILE");
  run->add_option("--sample", request.run.sample_at,
                  "With --json: also tell the paths of the cracks, and displacements at places of "
                  "the plate at this time, which runs with other numerics can be compared by")
      ->type_name("S")
      ->needs("--json")
      ->check(CLI::Range(0.0, 1e12));
  run->add_flag("-i,--interactive", request.run.interactive,
                "Go on at the prompt after the script, with its variables and simulations")
      ->excludes("--json");
  run->footer("Arguments after -- are passed to the script, in `arg` and `...`.");
}

void describe_render(CLI::App& app, Request& request) {
  CLI::App* render =
      app.add_subcommand("render", "Make pictures and movies of recorded runs, without computing");
  render
      ->add_option("FILES", request.render.words,
                   "Run files, then the output (.png or a movie), then options key=value")
      ->required();
  render
      ->add_option("-j,--threads", request.render.execution.threads,
                   "Number of threads (one per core)")
      ->type_name("N")
      ->check(CLI::Range(1, max_threads));
  render->add_flag("-q,--quiet", request.render.quiet, "Print only errors");
  render->footer(
      "RUN.h5 alone tells what is recorded. Options are those of r:frame and r:movie for one run,\n"
      "of contact_sheet and side_by_side for several or for times=10us,20us:\n"
      "hackle render run.h5 stress.png field=stress_1 time=20us range=0:12MPa");
}

void describe_chart(CLI::App& app, Request& request) {
  CLI::App* chart = app.add_subcommand(
      "chart", "Draw a chart of the numbers of recorded runs and of tables, without computing");
  chart
      ->add_option(
          "FILES", request.chart.words,
          "Run files and tables (.csv), what to draw, the picture (.png, .pdf, .svg), then "
          "options key=value")
      ->required();
  chart->add_flag("-q,--quiet", request.chart.quiet, "Print only errors");
  chart->footer(
      "RUN.h5 alone tells what can be drawn: a kind of chart, or columns of one unit. Options are\n"
      "those of chart in a script. The numbers go beside the picture, as CSV:\n"
      "hackle chart run.h5 speed\n"
      "hackle chart a.h5 b.csv tip.x tip.pdf paper=85mm\n"
      "hackle chart run.csv grip.fy x=grip.uy load.png");
}

void describe_replay(CLI::App& app, Request& request) {
  CLI::App* replay = app.add_subcommand(
      "replay", "Compute a recorded run again and name the first record that differs");
  replay->add_option("FILE", request.replay.run, "Run file, .h5")->required();
  describe_execution(*replay, request.replay.execution);
  replay->add_flag("--json", request.replay.json, "Print one JSON object on stdout");
  replay->add_flag("-q,--quiet", request.replay.quiet, "Print only differences and errors");
  replay->footer(
      "Every record must have the same bits, on any machine and any number of threads: exit code\n"
      "0 if all agree, 1 if one differs, 4 if the file does not say enough to compute one.");
}

void describe_bench(CLI::App& app, Request& request) {
  CLI::App* bench = app.add_subcommand("bench", "Measure how fast this machine solves a plate");
  bench->add_option("--peer", request.bench.peer, "Peer to compare with: lammps or none")
      ->type_name("NAME")
      ->check(CLI::IsMember({"auto", "lammps", "none"}));
  bench
      ->add_option("--rounds", request.bench.rounds,
                   "Number of repetitions of each measurement (5)")
      ->type_name("N")
      ->check(CLI::Range(1, 1000));
  bench->add_option("--nodes", request.bench.nodes, "Number of nodes of the plate (64000)")
      ->type_name("N")
      ->check(CLI::Range(1000, 100000000));
  bench->add_flag("--ranks", request.bench.ranks,
                  "Under mpirun -n N: measure a step on N ranks, compare it with the model, and "
                  "tell what it expects of a cluster");
  describe_execution(*bench, request.bench.execution);
  bench->add_flag("--json", request.bench.json, "Print one JSON object on stdout");
  bench->add_flag("-q,--quiet", request.bench.quiet, "Print only errors");
}

void describe_validate(CLI::App& app, Request& request) {
  CLI::App* command = app.add_subcommand(
      "validate", "Compare what ready-made scenes give with closed forms and published values");
  command->add_option("NAMES", request.validate.names,
                      "Scripts by name or its beginning, or files that expect something (all)");
  command->add_flag("--quick", request.validate.quick, "Only what takes about a minute in total");
  command
      ->add_option("-o,--output", request.validate.folder,
                   "Folder for validate.html and what the scripts write (out/validate)")
      ->type_name("DIR");
  command
      ->add_option("--update", request.validate.tables,
                   "Markdown file whose table between <!-- hackle validate: table --> (or summary) "
                   "and <!-- end --> is written anew; repeatable")
      ->type_name("FILE")
      ->take_all()
      ->allow_extra_args(false);
  describe_execution(*command, request.validate.execution);
  command->add_flag("--json", request.validate.json, "Print one JSON object on stdout");
  command->add_flag("-q,--quiet", request.validate.quiet, "Print only the counts and errors");
  command->footer("Exit code 0: no check fails; 1: one does. What fails stays in the table.");
}

void describe_info(CLI::App& app, Request& request) {
  CLI::App* info =
      app.add_subcommand("info", "Show what a file is, or version, libraries and machine");
  info->add_option("FILE", request.info.file,
                   "A run file, a checkpoint or a movie that Hackle made, also one that is being "
                   "written or was cut off");
  info->add_flag("--json", request.info.json, "Print one JSON object");
}

void describe_diff(CLI::App& app, Request& request) {
  CLI::App* diff = app.add_subcommand(
      "diff",
      "Compare two runs: their inputs, and where, when and by how much their fields differ");
  diff->add_option("A", request.diff.one, "A run file or a checkpoint")->required();
  diff->add_option("B", request.diff.other, "Another one")->required();
  diff->add_flag("--json", request.diff.json, "Print one JSON object");
  diff->add_flag("-q,--quiet", request.diff.quiet, "Print only errors");
  diff->footer("Exit code 0: they are equal; 1: they differ.");
}

void describe_times(CLI::App& command, ExportWishes& wishes) {
  const CLI::AsNumberWithUnit seconds(
      std::map<std::string, double>{{"s", 1.0}, {"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}});
  CLI::Option* times =
      command
          .add_option(
              "--time,--times", wishes.times,
              "Times of the states, as in 10us,20us: the nearest records (the last; all for "
              "--vtkhdf)")
          ->type_name("TIME,...")
          ->delimiter(',')
          ->transform(seconds);
  command
      .add_option("--every", wishes.every,
                  "Time between states, as in 1us; for --lammps between samples of the damage")
      ->type_name("TIME")
      ->transform(seconds)
      ->excludes(times);
  command
      .add_option("--field,--fields", wishes.fields,
                  "Fields by their names, as in damage,stress_1 (damage, displacement, velocity)")
      ->type_name("NAME,...")
      ->delimiter(',');
}

void describe_export(CLI::App& app, Request& request) {
  CLI::App* command =
      app.add_subcommand("export", "Write the states of a run, or its scene, for other programs");
  command->add_option("RUN", request.exported.run, "A run file or a checkpoint")->required();
  const auto add = [&](const char* name, ExportKind kind, const char* sentence) {
    command->add_flag_callback(
        name, [&request, kind] { request.exported.kinds.push_back(kind); }, sentence);
  };
  add("--csv", ExportKind::csv, "A table: a row per node and time");
  add("--vtk", ExportKind::vtk, "Legacy VTK: a file per time, points with their fields");
  add("--vtkhdf", ExportKind::vtkhdf,
      "VTKHDF: one file with all times, for ParaView 5.12 and VTK 9.3");
  add("--lammps", ExportKind::lammps,
      "The scene as an input deck of LAMMPS (pair_style peri/pmb) with its data file");
  command
      ->add_option("-o,--output", request.exported.output,
                   "File to write (the name of the run, here)")
      ->type_name("FILE");
  describe_times(*command, request.exported.wishes);
  command->add_flag("-q,--quiet", request.exported.quiet, "Print only errors");
}

void describe_docs(CLI::App& app, Request& request) {
  CLI::App* docs = app.add_subcommand("docs", "Write the reference to stdout");
  docs->require_option(0, 1);
  docs->add_flag("--markdown", request.docs.markdown,
                 "The whole reference in Markdown (the default)");
  docs->add_flag("--man", request.docs.man, "The manual page");
  docs->add_option("--completion", request.docs.completion,
                   "Completions for a shell: bash, zsh or fish")
      ->type_name("SHELL")
      ->check(CLI::IsMember(std::vector<std::string>(shell_names.begin(), shell_names.end())));
}

void describe(CLI::App& app, Request& request) {
  app.name("hackle");
  app.set_version_flag("--version", version_text);
  app.require_subcommand(0, 1);
  describe_limits(app, request.run.limits);
  describe_run(app, request);
  describe_resume(app, request);
  describe_check(app, request);
  describe_render(app, request);
  describe_chart(app, request);
  describe_diff(app, request);
  describe_export(app, request);
  describe_replay(app, request);
  describe_new(app, request);
  describe_bench(app, request);
  describe_validate(app, request);
  describe_study(app, request.study);
  describe_info(app, request);
  describe_docs(app, request);
  app.footer("hackle FILE.lua is short for hackle run FILE.lua; hackle alone opens the prompt.");
}

// Reports errors of CLI11, in our own words where they are clearer.
int refuse(const CLI::App& app, const CLI::ParseError& error, const std::string& unknown) {
  const bool known = app.get_subcommands().empty() && !unknown.empty() && unknown[0] != '-';
  std::string what = error.what();
  if (known) what = fmt::format("there is no command or script '{}'", unknown);
  if (known) what += did_you_mean(unknown, commands);
  const std::string command = app.got_subcommand("run") ? "hackle run -h" : "hackle -h";
  tell(Error(ErrorKind::usage, what, command + " lists what there is"));
  return static_cast<int>(ErrorKind::usage);
}

int execute(const CLI::App& app, Request& request) {
  if ((app.got_subcommand("run") || app.got_subcommand("check")) && request.run.script.empty() &&
      request.run.text.empty()) {
    tell(Error(ErrorKind::usage, "FILE is required", "name a script, - for stdin, or -e TEXT"));
    return static_cast<int>(ErrorKind::usage);
  }
  for (const std::string& setting : request.settings) {
    const std::size_t equals = setting.find('=');
    request.run.overrides[setting.substr(0, equals)] = setting.substr(equals + 1);
  }
  if (app.got_subcommand("run") || app.got_subcommand("resume")) return command_run(request.run);
  if (app.got_subcommand("check")) return command_check(request.run);
  if (app.got_subcommand("render")) return command_render(request.render);
  if (app.got_subcommand("chart")) return command_chart(request.chart);
  if (app.got_subcommand("diff")) return command_diff(request.diff);
  if (app.got_subcommand("export")) return command_export(request.exported);
  if (app.got_subcommand("replay")) return command_replay(request.replay);
  if (app.got_subcommand("new")) return command_new(request.new_name);
  if (app.got_subcommand("bench")) return command_bench(request.bench);
  if (app.got_subcommand("validate")) return command_validate(request.validate);
  if (app.got_subcommand("study")) return request.study(request.run.arguments);
  if (app.got_subcommand("info")) return command_info(request.info);
  if (app.got_subcommand("docs")) return command_docs(request.docs, command_table(app));
  return command_prompt(request.run.limits);
}

// Output that could not be written makes a success a failure. If the reader has closed the pipe, as
// head does, no error is printed.
int with_output_checked(int code) {
  const auto reason = lost_output();
  if (!reason) return code;
  const bool unread = output_is_unread();
  if (!unread) tell(Error(ErrorKind::files, "output was lost: " + *reason));
  const bool stopped = unread && code == static_cast<int>(ErrorKind::interrupted);
  return code == 0 || stopped ? static_cast<int>(ErrorKind::files) : code;
}

// `--help` with a script: also lists the script's own options.
int tell_options(const RunRequest& request) {
  return exit_code_of([&] {
    print_out("\n{}", options_text(request));
    return 0;
  });
}

}  // namespace

std::vector<std::string> with_command(std::vector<std::string> words) {
  if (words.empty() || is_command(words.front())) return words;
  const auto is_script = [](const std::string& word) {
    std::error_code ignored;
    return word == "-" || word == "-e" || word.ends_with(".lua") ||
           std::filesystem::is_regular_file(word, ignored);
  };
  if (std::ranges::any_of(words, is_script)) words.insert(words.begin(), "run");
  return words;
}

namespace {

int carry_out(std::vector<std::string> words) {
  Request request;
  request.run.arguments = cut_script_arguments(words);
  words = with_command(std::move(words));
  CLI::App app("Breaks thin brittle plates with peridynamics and films it.");
  describe(app, request);
  const std::string first = words.empty() ? "" : words.front();
  try {
    check_study_kind(app, words);
    std::vector<std::string> reversed(words.rbegin(), words.rend());
    app.parse(reversed);
  } catch (const CLI::Success& help) {
    const int code = app.exit(help);
    return request.run.script.empty() ? code : tell_options(request.run);
  } catch (const CLI::ParseError& error) {
    return refuse(app, error, first);
  } catch (const Error& error) {
    tell(error);
    return static_cast<int>(error.kind());
  }
  return execute(app, request);
}

}  // namespace

int run_program(std::vector<std::string> words) {
  return with_output_checked(carry_out(std::move(words)));
}

}  // namespace hackle
