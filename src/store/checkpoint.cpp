// SPDX-License-Identifier: MIT
#include "store/checkpoint.hpp"

#include <bit>
#include <cmath>
#include <concepts>
#include <span>
#include <stdexcept>
#include <string_view>
#include <type_traits>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "base/machine.hpp"
#include "base/partial_file.hpp"
#include "base/version.hpp"
#include "lattice/check_numerics.hpp"
#include "store/inputs.hpp"
#include "store/lattice_hash.hpp"
#include "store/sealed_file.hpp"

namespace hackle {
namespace fs = std::filesystem;
namespace {

static_assert(std::endian::native == std::endian::little);

using HeadJson = nlohmann::json;
constexpr std::string_view first_line = "Hackle checkpoint 1\n";
constexpr std::uint64_t max_head = std::uint64_t{256} << 20U;

// The small members of a state to and from JSON.
HeadJson json_of(const Vec2& vector) {
  return {vector.x(), vector.y()};
}
HeadJson json_of(const Clock& clock) {
  return {clock.moment, clock.since};
}
HeadJson json_of(double number) {
  return number;
}
HeadJson json_of(std::int64_t number) {
  return number;
}
HeadJson json_of(const std::vector<Disc>& discs) {
  HeadJson list = HeadJson::array();
  for (const Disc& disc : discs) list.push_back({json_of(disc.centre), json_of(disc.velocity)});
  return list;
}

double number(const HeadJson& json) {
  const double value = json.get<double>();
  if (!std::isfinite(value)) throw std::invalid_argument("not finite");
  return value;
}
void set(double& to, const HeadJson& json) {
  to = number(json);
}
void set(std::int64_t& to, const HeadJson& json) {
  to = json.get<std::int64_t>();
  if (to < 0 || static_cast<double>(to) > max_steps) throw std::invalid_argument("a step");
}
void set(Vec2& to, const HeadJson& json) {
  to = {number(json.at(0)), number(json.at(1))};
}
void set(Clock& to, const HeadJson& json) {
  to.moment = number(json.at(0));
  set(to.since, json.at(1));
}
void set(std::vector<Disc>& to, const HeadJson& json) {
  for (const HeadJson& disc : json) {
    to.emplace_back();
    set(to.back().centre, disc.at(0));
    set(to.back().velocity, disc.at(1));
  }
}

HeadJson json_of(const std::vector<LoadedNode>& nodes) {
  HeadJson list = HeadJson::array();
  for (const LoadedNode& node : nodes)
    list.push_back({node.i, node.j, json_of(node.acceleration), node.inertia});
  return list;
}

std::vector<LoadedNode> loaded_nodes(const HeadJson& json) {
  std::vector<LoadedNode> nodes;
  for (const HeadJson& entry : json) {
    LoadedNode& node = nodes.emplace_back();
    node.i = entry.at(0).get<int>();
    node.j = entry.at(1).get<int>();
    set(node.acceleration, entry.at(2));
    node.inertia = number(entry.at(3));
  }
  return nodes;
}

HeadJson head_of(const Simulation& simulation, const Snapshot& snapshot, const Origin& origin) {
  HeadJson state, sizes;
  for_each_member(snapshot.state, [&](const char* name, const auto& member, bool) {
    using Member = std::remove_cvref_t<decltype(member)>;
    if constexpr (std::same_as<Member, BondBits>)
      sizes[name] = member.words().size();
    else if constexpr (requires { json_of(member); })
      state[name] = json_of(member);
    else
      sizes[name] = member.size();
  });
  return {{"software", "Hackle"},
          {"version", std::string(version())},
          {"git_hash", std::string(git_hash())},
          {"script_name", origin.script_name},
          {"script", origin.script_text},
          {"inputs", inputs_of(simulation)},
          {"lattice_hash", lattice_hash(simulation.lattice())},
          {"precision", std::string(name_of(snapshot.state.precision()))},
          {"state", state},
          {"sizes", sizes},
          {"aim", {snapshot.aim.end_time, snapshot.aim.last_step}},
          {"borne", json_of(snapshot.borne)},
          {"widened_at", snapshot.widened_at ? HeadJson(*snapshot.widened_at) : HeadJson()},
          {"max_energy", snapshot.max_energy},
          {"solve_seconds", snapshot.solve_seconds}};
}

void write_state(const State& state, SealedWriter& writer) {
  for_each_member(state, [&](const char*, const auto& member, bool) {
    using Member = std::remove_cvref_t<decltype(member)>;
    if constexpr (std::same_as<Member, BondBits>)
      writer.write(std::span(member.words()));
    else if constexpr (!requires { json_of(member); })
      writer.write(std::span(member.data(), member.size()));
  });
}

void sync_folder_of(const fs::path& path) {
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return;
  fsync(descriptor);
  ::close(descriptor);
}

// Says how to go on with the previous checkpoint, if it is whole.
std::string remedy_by_previous(const fs::path& path) {
  const fs::path previous = previous_checkpoint(path);
  std::error_code ignored;
  if (!fs::exists(previous, ignored)) return {};
  try {
    check_seal(previous, first_line, Patience::until_interrupted);
  } catch (const Error&) {
    return {};
  }
  return fmt::format("the one before it is whole: '{}'", previous.string());
}

}  // namespace

fs::path previous_checkpoint(const fs::path& path) {
  fs::path name = path.stem();
  name += "_prev";
  name += path.extension();
  return path.parent_path() / name;
}

CheckpointImage image_of(const Simulation& simulation, const Origin& origin) {
  Snapshot snapshot = simulation.snapshot();
  // The name of a material may contain invalid UTF-8.
  std::string head = head_of(simulation, snapshot, origin)
                         .dump(-1, ' ', false, HeadJson::error_handler_t::replace);
  return {std::move(head), std::move(snapshot.state)};
}

void write_checkpoint(const fs::path& path, const CheckpointImage& image) {
  make_folder_of(path);
  const PartialFile partial(path);
  SealedWriter writer(partial_name(path));
  writer.write(fmt::format("{}{}\n", first_line, image.head.size()));
  writer.write(image.head);
  write_state(image.state, writer);
  writer.seal();
  check_seal(partial_name(path), first_line, Patience::endless);
  std::error_code failure;
  if (fs::exists(path, failure)) fs::rename(path, previous_checkpoint(path), failure);
  if (failure) refuse_sealed(previous_checkpoint(path), failure.message());
  publish(path);
  sync_folder_of(path);
}

namespace {

// The head begins after a line with its size.
std::uint64_t size_of_head(SealedReader& reader) {
  constexpr int max_digits = 12;
  reader.text(first_line.size());
  std::uint64_t size = 0;
  for (int k = 0; k <= max_digits; ++k) {
    const char digit = reader.text(1).front();
    if (digit == '\n') return size;
    if (digit < '0' || digit > '9') break;
    size = 10 * size + static_cast<std::uint64_t>(digit - '0');
  }
  reader.refuse("its head has no size");
}

template <class T>
Values<T> array_of(const HeadJson& size, SealedReader& reader) {
  Values<T> values(reader.checked(size.get<std::uint64_t>(), sizeof(T)));
  reader.read(std::span<T>(values));
  return values;
}

State read_state(const HeadJson& head, const NodeLayout& layout, SealedReader& reader) {
  const HeadJson &small = head.at("state"), &sizes = head.at("sizes");
  State state;
  state.layout = layout;
  if (head.at("precision") == name_of(Precision::f32)) state.motion = Motion<float>();
  for_each_member(state, [&](const char* name, auto& member, bool) {
    using Member = std::remove_cvref_t<decltype(member)>;
    if constexpr (std::same_as<Member, BondBits>) {
      const auto words = array_of<std::uint32_t>(sizes.at(name), reader);
      member = BondBits(layout, {words.begin(), words.end()});
    } else if constexpr (requires { set(member, small); }) {
      set(member, small.at(name));
    } else {
      member = array_of<typename Member::value_type>(sizes.at(name), reader);
    }
  });
  return state;
}

void check_parts(const Checkpoint& checkpoint, const Grid& grid, const SealedReader& reader) {
  for (const LoadedNode& node : checkpoint.snapshot.borne)
    if (!grid.contains(node.i, node.j)) reader.refuse("it names nodes that its plate has not");
  const State& state = checkpoint.snapshot.state;
  const Loads& loads = checkpoint.inputs.plate.loads;
  if (state.discs.size() != loads.impactors.size() ||
      state.rollers.size() != loads.rollers.size() || state.platens.size() != loads.platens.size())
    reader.refuse("its bodies are not those of its plate");
}

Checkpoint read_parts(const fs::path& path) {
  SealedReader reader(path);
  const std::uint64_t size = size_of_head(reader);
  if (size > max_head) reader.refuse("its head is too long");
  const HeadJson head = HeadJson::parse(reader.text(size));
  Checkpoint checkpoint{{head.at("script_name"), head.at("script")},
                        read_inputs(head.at("inputs").get<std::string>()),
                        head.at("lattice_hash"),
                        {}};
  Problems problems;
  check(checkpoint.inputs.plate, problems);
  check(checkpoint.inputs.plate, checkpoint.inputs.numerics, available_memory(), problems);
  if (!problems.empty()) reader.refuse("its scene is impossible");
  const Grid grid = make_grid(checkpoint.inputs.plate, checkpoint.inputs.numerics.spacing);
  Snapshot& snapshot = checkpoint.snapshot;
  snapshot.state = read_state(head, grid.layout(), reader);
  set(snapshot.aim.end_time, head.at("aim").at(0));
  set(snapshot.aim.last_step, head.at("aim").at(1));
  snapshot.borne = loaded_nodes(head.at("borne"));
  if (!head.at("widened_at").is_null()) snapshot.widened_at = number(head.at("widened_at"));
  snapshot.max_energy = number(head.at("max_energy"));
  snapshot.solve_seconds = number(head.at("solve_seconds"));
  check_parts(checkpoint, grid, reader);
  return checkpoint;
}

}  // namespace

Checkpoint read_checkpoint(const fs::path& path) {
  try {
    check_seal(path, first_line, Patience::until_interrupted);
    return read_parts(path);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::files) throw;
    const std::string remedy = remedy_by_previous(path);
    if (remedy.empty()) throw;
    throw Error(ErrorKind::files, error.problems().front().what, remedy);
  } catch (const std::exception&) {  // of JSON: its message may quote the file
    refuse_sealed(path, "its head is damaged", remedy_by_previous(path));
  }
}

// What its plate refuses is a fault of the file.
Simulation resume(Checkpoint checkpoint, const Execution& execution) {
  try {
    Simulation simulation =
        Simulation::resumed(std::move(checkpoint.inputs.plate), checkpoint.inputs.numerics,
                            std::move(checkpoint.snapshot), execution);
    if (lattice_hash(simulation.lattice()) != checkpoint.lattice_hash)
      throw Error(ErrorKind::files, "checkpoint: its lattice cannot be built again",
                  "take the version of Hackle that wrote it");
    return simulation;
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::interrupted || error.kind() == ErrorKind::files) throw;
    throw Error(ErrorKind::files, fmt::format("checkpoint: {}", error.problems().front().what),
                error.problems().front().remedy);
  }
}

}  // namespace hackle
