// SPDX-License-Identifier: MIT
#include "console/replay/continuation.hpp"

#include <algorithm>
#include <tuple>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "store/checkpoint.hpp"

namespace hackle {
namespace fs = std::filesystem;
namespace {

using Cbor = nlohmann::json;
constexpr int continuation_format = 1;
constexpr const char* automatic = ".auto";
constexpr const char* ending = ".ckpt";

Cbor to_cbor(const std::string& bytes) {
  return Cbor::binary({bytes.begin(), bytes.end()});
}

std::string bytes_of(const Cbor& cbor) {
  const auto& bytes = cbor.get_binary();
  return {bytes.begin(), bytes.end()};
}

Cbor to_cbor(const OutputMark& mark) {
  return {
      to_cbor(mark.file.string()), mark.pieces, mark.start, mark.next, mark.complete, mark.memory,
      to_cbor(mark.note)};
}

OutputMark mark_of(const Cbor& cbor) {
  return {.file = bytes_of(cbor.at(0)),
          .pieces = cbor.at(1),
          .start = cbor.at(2),
          .next = cbor.at(3),
          .complete = cbor.at(4),
          .note = bytes_of(cbor.at(6)),
          .memory = cbor.at(5)};
}

// Arrays of [number, value]: keys of CBOR would be text.
Cbor to_cbor(const std::map<int, std::vector<OutputMark>>& outputs) {
  Cbor list = Cbor::array();
  for (const auto& [run, marks] : outputs) {
    Cbor all = Cbor::array();
    for (const OutputMark& mark : marks) all.push_back(to_cbor(mark));
    list.push_back({run, all});
  }
  return list;
}

Cbor to_cbor(const std::map<int, std::string>& summaries) {
  Cbor list = Cbor::array();
  for (const auto& [run, text] : summaries) list.push_back({run, to_cbor(text)});
  return list;
}

Cbor to_cbor(const std::vector<Continuation::Other>& others) {
  Cbor list = Cbor::array();
  for (const auto& [run, file, hash] : others) list.push_back({run, to_cbor(file), hash});
  return list;
}

Cbor to_cbor(const RunInputs& inputs) {
  Cbor overrides = Cbor::array(), arguments = Cbor::array();
  for (const auto& [key, value] : inputs.overrides)
    overrides.push_back({to_cbor(key), to_cbor(value)});
  for (const std::string& argument : inputs.arguments) arguments.push_back(to_cbor(argument));
  return {to_cbor(inputs.script), overrides, arguments};
}

RunInputs inputs_of(const Cbor& cbor) {
  RunInputs inputs{bytes_of(cbor.at(0)), {}, {}};
  for (const Cbor& pair : cbor.at(1)) inputs.overrides[bytes_of(pair.at(0))] = bytes_of(pair.at(1));
  for (const Cbor& argument : cbor.at(2)) inputs.arguments.push_back(bytes_of(argument));
  return inputs;
}

Continuation from_cbor(const Cbor& cbor) {
  if (cbor.at("format") != continuation_format) throw std::invalid_argument("format");
  Continuation all;
  all.inputs = inputs_of(cbor.at("inputs"));
  all.origin = {bytes_of(cbor.at("script_name")), bytes_of(cbor.at("script"))};
  all.journal = bytes_of(cbor.at("journal"));
  all.obstacle = bytes_of(cbor.at("obstacle"));
  all.run = cbor.at("run");
  for (const Cbor& other : cbor.at("others"))
    all.others.push_back({other.at(0), bytes_of(other.at(1)), other.at(2)});
  for (const Cbor& outputs : cbor.at("outputs"))
    for (const Cbor& mark : outputs.at(1)) all.outputs[outputs.at(0)].push_back(mark_of(mark));
  for (const Cbor& summary : cbor.at("summaries"))
    all.summaries[summary.at(0)] = bytes_of(summary.at(1));
  return all;
}

// Returns whether the file is an automatic checkpoint, of that script or of any.
bool is_automatic(const fs::path& file, const std::string& script) {
  const std::string name = file.filename().string();
  const std::size_t mark = name.rfind(automatic);
  if (mark == std::string::npos || !name.ends_with(ending)) return false;
  return script.empty() || name.substr(0, mark) == script;
}

}  // namespace

std::string bytes_of(const Continuation& all) {
  const std::vector<std::uint8_t> bytes =
      Cbor::to_cbor({{"format", continuation_format},
                     {"inputs", to_cbor(all.inputs)},
                     {"script_name", to_cbor(all.origin.script_name)},
                     {"script", to_cbor(all.origin.script_text)},
                     {"journal", to_cbor(all.journal)},
                     {"obstacle", to_cbor(all.obstacle)},
                     {"run", all.run},
                     {"others", to_cbor(all.others)},
                     {"outputs", to_cbor(all.outputs)},
                     {"summaries", to_cbor(all.summaries)}});
  return {bytes.begin(), bytes.end()};
}

Continuation continuation_of(const std::string& bytes, const fs::path& who) {
  try {
    return from_cbor(Cbor::from_cbor(bytes));
  } catch (const std::exception&) {  // its message may quote the file
    throw Error(ErrorKind::files,
                fmt::format("'{}' does not say how its script goes on", who.string()),
                "load in a script or at the prompt goes on from its state");
  }
}

fs::path automatic_checkpoint(const std::string& script, int number) {
  return number == 1 ? fmt::format("{}{}{}", script, automatic, ending)
                     : fmt::format("{}{}-{}{}", script, automatic, number, ending);
}

std::vector<fs::path> automatic_checkpoints(const fs::path& folder, const std::string& script) {
  std::vector<fs::path> files;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (is_automatic(entry.path(), script)) files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

namespace {

// How far a script can be continued; of the same place the last one, which has more of its run.
auto place_of(const Found& found) {
  std::error_code ignored;
  return std::tuple(found.continuation.obstacle.empty(), found.continuation.journal.size(),
                    fs::last_write_time(found.checkpoint, ignored));
}

}  // namespace

std::optional<Found> find_continuation(const fs::path& folder, const std::string& script,
                                       std::vector<std::string>& problems) {
  std::optional<Found> furthest;
  for (const fs::path& file : automatic_checkpoints(folder, script)) {
    try {
      const std::string bytes = read_continuation(file);
      if (bytes.empty()) continue;  // it has only the state of another simulation
      Continuation found = continuation_of(bytes, file);
      Found one{file, std::move(found)};
      if (!furthest || place_of(*furthest) < place_of(one)) furthest = std::move(one);
    } catch (const Error& error) {
      if (error.kind() == ErrorKind::interrupted) throw;
      problems.emplace_back(error.what());
    }
  }
  return furthest;
}

}  // namespace hackle
