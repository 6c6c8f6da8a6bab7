// SPDX-License-Identifier: MIT
#include "app/file_facts.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/partial_file.hpp"
#include "base/text.hpp"
#include "base/units.hpp"
#include "console/replay/continuation.hpp"
#include "lattice/needs.hpp"
#include "movie/movie_kind.hpp"
#include "movie/read_film.hpp"
#include "scene/wording.hpp"
#include "store/checkpoint.hpp"
#include "store/noun_writer.hpp"
#include "store/run_facts.hpp"
#include "store/stored_kind.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

void begin(FileFacts& facts, const fs::path& path, const char* kind) {
  facts.json = {{"schema", 1},
                {"file", path.string()},
                {"kind", kind},
                {"bytes", static_cast<std::uint64_t>(fs::file_size(path))}};
}

void add_head(FileFacts& facts, const fs::path& path, const std::string& maker) {
  facts.lines.emplace_back(facts.json["kind"],
                           fmt::format("{}, {}, {}", path.filename().string(),
                                       quantity(facts.json["bytes"].get<double>(), "B"), maker));
}

void add_script(FileFacts& facts, const std::string& name) {
  facts.json["script"] = name;
  facts.lines.emplace_back("script", name.empty() ? "typed at the prompt" : name);
}

// A line for every entry of every list of a noun, and for every noun that it may have.
template <Described Noun>
void add_entries(FileFacts& facts, const Noun& noun) {
  const auto add = [&](std::string_view name, const auto& entry) {
    using Entry = std::remove_cvref_t<decltype(entry)>;
    if constexpr (Described<Entry>) name = description_of<Entry>.counted;
    facts.lines.emplace_back(name == "no_fail" ? "no-fail zone" : name, Wording()(entry));
  };
  for_each_member<Noun>([&](const auto& member) {
    const auto& value = noun.*member.pointer;
    using Value = std::remove_cvref_t<decltype(value)>;
    if constexpr (is_list<Value>)
      for (const auto& entry : value) add(member.name, entry);
    else if constexpr (is_optional<Value>)
      value ? add(member.name, *value) : void();
    else if constexpr (std::is_same_v<Value, Loads>)
      add_entries(facts, value);
  });
}

void add_inputs(FileFacts& facts, const Inputs& inputs, int columns, int rows) {
  facts.json["columns"] = columns;
  facts.json["rows"] = rows;
  facts.json["scene"] = NounWriter::json_of(inputs.plate);
  facts.json["numerics"] = NounWriter::json_of(inputs.numerics);
  facts.lines.emplace_back("scene", describe(inputs.plate));
  add_entries(facts, inputs.plate);
  const Loads& loads = inputs.plate.loads;
  if (loads.damping > 0.0)
    facts.lines.emplace_back("damping", fmt::format("{} 1/s", quantity(loads.damping, "")));
  if (loads.stiffness_damping > 0.0)
    facts.lines.emplace_back("stiffness damping", quantity(loads.stiffness_damping, "s"));
  facts.lines.emplace_back(
      "numerics", fmt::format("{} x {} nodes, {}", columns, rows, Wording()(inputs.numerics)));
}

void add_fields(FileFacts& facts, const std::vector<StoredField>& fields) {
  std::string text;
  facts.json["fields"] = Json::object();
  for (const auto& [name, bytes] : fields) {
    facts.json["fields"][name] = bytes;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name,
                        quantity(static_cast<double>(bytes), "B"));
  }
  facts.lines.emplace_back("stored", text);
}

bool is_being_written(const fs::path& path) {
  try {
    refuse_if_written(path);
    return false;
  } catch (const Error&) {
    return true;
  }
}

// Checkpoints that runs keep by themselves, beside one that did not end.
void offer_checkpoints(FileFacts& facts, const fs::path& run) {
  std::error_code failure;
  const fs::path folder = run.has_parent_path() ? run.parent_path() : fs::path(".");
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failure))
    if (entry.path().extension() == ".ckpt" &&
        entry.path().stem().extension().string().starts_with(".auto"))
      names.push_back((run.parent_path() / entry.path().filename()).string());
  std::ranges::sort(names);
  for (const std::string& name : names)
    facts.next.push_back(fmt::format("hackle resume {}", shell_word(name)));
}

std::string maker(const std::string& version, const std::string& git_hash) {
  return fmt::format("made by Hackle {}{}", version,
                     git_hash.empty() ? "" : fmt::format(" (git {})", git_hash));
}

void add_records(FileFacts& facts, const RunFacts& run, const fs::path& path) {
  const bool is_written = !run.is_complete && is_being_written(path);
  const char* state = run.is_complete ? "complete" : is_written ? "being written" : "cut off";
  facts.json.update({{"complete", run.is_complete},
                     {"being_written", is_written},
                     {"records", run.records},
                     {"steps", run.last_step}});
  facts.json["times_s"] = run.times;
  std::string text =
      fmt::format("{}: {} record{}", state, grouped(run.records), run.records == 1 ? "" : "s");
  if (!run.times.empty())
    text += fmt::format(" from {} to {}, {} steps", quantity(run.times.front(), "s"),
                        quantity(run.times.back(), "s"), grouped(run.last_step));
  facts.lines.emplace_back("progress", text);
}

// The same as make_grid(), but for any numbers that a file may have.
int cells_along(double length, double spacing) {
  const double cells = std::round(length / spacing);
  return cells >= 1.0 && cells <= max_columns ? static_cast<int>(cells) : 0;
}

void offer_views_of(FileFacts& facts, const fs::path& path) {
  const std::string run = shell_word(path.string()), stem = path.stem().string();
  facts.next.push_back(
      fmt::format("hackle render {} {} field=stress_1", run, shell_word(stem + ".png")));
  facts.next.push_back(fmt::format("hackle render {} {}", run, shell_word(stem + ".mp4")));
}

FileFacts facts_of_run_file(const fs::path& path) {
  const RunFacts run = facts_of_run(path);
  FileFacts facts;
  begin(facts, path, "run file");
  facts.json.update({{"format", run.format},
                     {"version", run.version},
                     {"git", run.git_hash},
                     {"created", run.created}});
  add_head(facts, path, fmt::format("{}, {}", maker(run.version, run.git_hash), run.created));
  add_script(facts, run.origin.script_name);
  const Inputs inputs = read_inputs(run.inputs);
  add_inputs(facts, inputs, cells_along(inputs.plate.width, inputs.numerics.spacing),
             cells_along(inputs.plate.height, inputs.numerics.spacing));
  add_records(facts, run, path);
  add_fields(facts, run.fields);
  if (run.records > 0) offer_views_of(facts, path);
  if (facts.json["complete"] == false && facts.json["being_written"] == false)
    offer_checkpoints(facts, path);
  return facts;
}

template <class T>
constexpr bool is_values = false;
template <class T>
constexpr bool is_values<Values<T>> = true;

// A forged head may tell of arrays of other sizes than its plate has nodes.
void check_arrays(const State& state, const fs::path& path) {
  const std::size_t size = state.layout.size();
  bool fitting = true;
  for_each_member(state, [&](std::string_view name, const auto& member, bool) {
    if constexpr (requires { member.words(); })
      fitting = fitting && member.words().size() % size == 0;
    else if constexpr (is_values<std::remove_cvref_t<decltype(member)>>)
      fitting = fitting && (member.size() == size || (name == "threshold" && member.empty()));
  });
  if (!fitting)
    throw Error(ErrorKind::files,
                fmt::format("file '{}': its arrays are not those of its plate", path.string()));
}

// The arrays of a state; what is small lies in the head.
std::vector<StoredField> fields_of(const State& state, std::uint64_t bytes) {
  std::vector<StoredField> fields;
  for_each_member(state, [&](const char* name, const auto& member, bool) {
    if constexpr (requires { member.words(); })
      fields.push_back({name, member.words().size() * sizeof(member.words().front())});
    else if constexpr (is_values<std::remove_cvref_t<decltype(member)>>)
      if (member.size() > 0) fields.push_back({name, member.size() * sizeof(member[0])});
  });
  for (const StoredField& field : fields) bytes -= std::min(bytes, field.bytes);
  fields.push_back({"head", bytes});
  return fields;
}

FileFacts facts_of_checkpoint(const fs::path& path) {
  const Checkpoint checkpoint = read_checkpoint(path);
  const State& state = checkpoint.snapshot.state;
  check_arrays(state, path);
  const double dt = checkpoint.inputs.numerics.step.value_or(0.0);
  const double of_step = state.clock.time(state.step, 0.0, dt),
               aim = checkpoint.snapshot.aim.end_time;
  // A run that has ended between two steps is seen at its end.
  const double time = aim > of_step - dt ? std::min(aim, of_step) : of_step;
  const double end = std::max(aim, time);
  FileFacts facts;
  begin(facts, path, "checkpoint");
  facts.json.update({{"steps", state.step},
                     {"time_s", time},
                     {"end_time_s", end},
                     {"precision", name_of(state.precision())},
                     {"solve_seconds", checkpoint.snapshot.solve_seconds},
                     {"hash", state.hash()}});
  add_head(facts, path, "hash " + state.hash());
  add_script(facts, checkpoint.origin.script_name);
  add_inputs(facts, checkpoint.inputs, state.layout.nx, state.layout.ny);
  facts.lines.emplace_back("progress",
                           fmt::format("at {}, step {}{}", quantity(time, "s"), grouped(state.step),
                                       end > time ? ", on its way to " + quantity(end, "s") : ""));
  add_fields(facts, fields_of(state, facts.json["bytes"]));
  if (!checkpoint.continuation.empty() &&
      continuation_of(checkpoint.continuation, path).obstacle.empty())
    facts.next.push_back(fmt::format("hackle resume {}", shell_word(path.string())));
  facts.next.push_back(fmt::format("load \"{}\"   in a script or at the prompt", path.string()));
  return facts;
}

// Takes "Made by Hackle 0.1.0 (hash) from a.lua, XXH3 0123" apart.
void add_comment(FileFacts& facts, const std::string& comment) {
  constexpr std::string_view from = " from ", hash = ", XXH3 ";
  const std::size_t name_at = comment.find(from), hash_at = comment.rfind(hash);
  const bool is_named = name_at != std::string::npos && hash_at != std::string::npos;
  add_script(facts, is_named
                        ? comment.substr(name_at + from.size(), hash_at - name_at - from.size())
                        : "");
  facts.json["script_hash"] = is_named ? comment.substr(hash_at + hash.size()) : "";
}

FileFacts facts_of_movie(const fs::path& path) {
  const FilmFacts film = facts_of_film(path);
  if (!film.comment.starts_with("Made by Hackle "))
    throw Error(
        ErrorKind::files,
        fmt::format("cannot tell of '{}': it does not say that Hackle made it", path.string()),
        "run files, checkpoints and movies of Hackle do");
  FileFacts facts;
  begin(facts, path, "movie");
  facts.json.update({{"title", film.title},
                     {"comment", film.comment},
                     {"width_px", film.width},
                     {"height_px", film.height},
                     {"frames", film.length.frames},
                     {"seconds", film.length.seconds}});
  add_head(facts, path, film.comment.substr(0, film.comment.find(" from ")));
  add_comment(facts, film.comment);
  facts.lines.emplace_back(
      "pictures", fmt::format("{} of {} x {} px, {}", grouped(film.length.frames), film.width,
                              film.height, quantity(film.length.seconds, "s")));
  if (const std::string script = facts.json["script"]; !script.empty())
    facts.next.push_back(fmt::format("hackle run {}", shell_word(script)));
  return facts;
}

bool is_movie(const fs::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return std::ranges::any_of(movie_kinds(),
                             [&](const MovieKind& kind) { return kind.ending == ending; });
}

}  // namespace

FileFacts facts_of_file(const fs::path& path) {
  switch (kind_of_stored(path)) {
    case StoredKind::run:
      return facts_of_run_file(path);
    case StoredKind::checkpoint:
      return facts_of_checkpoint(path);
    default:
      if (is_movie(path)) return facts_of_movie(path);
      refuse_kind(path, "neither a run file, a checkpoint nor a movie");
  }
}

}  // namespace hackle
