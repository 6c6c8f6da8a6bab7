// SPDX-License-Identifier: MIT
#include "store/checkpoint.hpp"

#include <bit>
#include <concepts>
#include <span>
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
#include "store/snapshot_head.hpp"

namespace hackle {
namespace fs = std::filesystem;
namespace {

static_assert(std::endian::native == std::endian::little);

using HeadJson = nlohmann::json;
constexpr std::string_view first_line = "Hackle checkpoint 2\n";
constexpr std::uint64_t max_head = std::uint64_t{256} << 20U;

// The head of a checkpoint: that of its snapshot, the sizes of its arrays, and where it comes from.
HeadJson head_of(const Simulation& simulation, const Snapshot& snapshot, const Origin& origin) {
  HeadJson head = hackle::head_of(snapshot), sizes;
  for_each_member(snapshot.state, [&](const char* name, const auto& member, bool) {
    using Member = std::remove_cvref_t<decltype(member)>;
    if constexpr (std::same_as<Member, BondBits>)
      sizes[name] = member.words().size();
    else if constexpr (!is_in_head<Member>)
      sizes[name] = member.size();
  });
  head.update({{"software", "Hackle"},
               {"version", std::string(version())},
               {"git_hash", std::string(git_hash())},
               {"script_name", origin.script_name},
               {"script", origin.script_text},
               {"inputs", inputs_of(simulation)},
               {"lattice_hash", lattice_hash(simulation.lattice())},
               {"sizes", sizes}});
  return head;
}

void write_state(const State& state, SealedWriter& writer) {
  for_each_member(state, [&](const char*, const auto& member, bool) {
    using Member = std::remove_cvref_t<decltype(member)>;
    if constexpr (std::same_as<Member, BondBits>)
      writer.write(std::span(member.words()));
    else if constexpr (!is_in_head<Member>)
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

CheckpointImage image_of(const Simulation& simulation, const Origin& origin,
                         std::string continuation) {
  Snapshot snapshot = simulation.snapshot();
  HeadJson head = head_of(simulation, snapshot, origin);
  head["continuation"] = continuation.size();
  // The name of a material may contain invalid UTF-8.
  return {head.dump(-1, ' ', false, HeadJson::error_handler_t::replace), std::move(continuation),
          std::move(snapshot.state)};
}

void write_checkpoint(const fs::path& path, const CheckpointImage& image) {
  make_folder_of(path);
  const PartialFile partial(path);
  SealedWriter writer(partial_name(path));
  writer.write(fmt::format("{}{}\n", first_line, image.head.size()));
  writer.write(image.head);
  writer.write(image.continuation);
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

// Reads the arrays of a state whose head has been read.
void read_arrays(const HeadJson& sizes, State& state, SealedReader& reader) {
  for_each_member(state, [&](const char* name, auto& member, bool) {
    using Member = std::remove_cvref_t<decltype(member)>;
    if constexpr (std::same_as<Member, BondBits>) {
      const auto words = array_of<std::uint32_t>(sizes.at(name), reader);
      member = BondBits(state.layout, {words.begin(), words.end()});
    } else if constexpr (!is_in_head<Member>) {
      member = array_of<typename Member::value_type>(sizes.at(name), reader);
    }
  });
}

void check_parts(const Checkpoint& checkpoint, const Grid& grid, const SealedReader& reader) {
  if (!names_only_its_own(checkpoint.snapshot, grid))
    reader.refuse("it names nodes or bonds that its plate has not");
  const State& state = checkpoint.snapshot.state;
  const Loads& loads = checkpoint.inputs.plate.loads;
  if (state.discs.size() != loads.impactors.size() ||
      state.rollers.size() != loads.rollers.size() || state.platens.size() != loads.platens.size())
    reader.refuse("its bodies are not those of its plate");
}

HeadJson read_head_of_file(SealedReader& reader) {
  const std::uint64_t size = size_of_head(reader);
  if (size > max_head) reader.refuse("its head is too long");
  return HeadJson::parse(reader.text(size));
}

// It follows the head.
std::string continuation_behind(const HeadJson& head, SealedReader& reader) {
  return reader.text(reader.checked(head.at("continuation").get<std::uint64_t>()));
}

Checkpoint read_parts(const fs::path& path) {
  SealedReader reader(path);
  const HeadJson head = read_head_of_file(reader);
  const std::string inputs = head.at("inputs");
  Checkpoint checkpoint{{head.at("script_name"), head.at("script")},
                        read_inputs(inputs),
                        inputs,
                        head.at("lattice_hash"),
                        continuation_behind(head, reader),
                        {}};
  Problems problems;
  check(checkpoint.inputs.plate, problems);
  check(checkpoint.inputs.plate, checkpoint.inputs.numerics, available_memory(), problems);
  if (!problems.empty()) reader.refuse("its scene is impossible");
  const Grid grid = make_grid(checkpoint.inputs.plate, checkpoint.inputs.numerics.spacing);
  Snapshot& snapshot = checkpoint.snapshot;
  snapshot.state.layout = grid.layout();
  read_head(head, snapshot);
  read_arrays(head.at("sizes"), snapshot.state, reader);
  check_parts(checkpoint, grid, reader);
  return checkpoint;
}

// Reads a file whose seal is whole by `read`.
template <class Read>
auto sealed(const fs::path& path, const Read& read) {
  try {
    check_seal(path, first_line, Patience::until_interrupted);
    return read(path);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::files) throw;
    const std::string remedy = remedy_by_previous(path);
    if (remedy.empty()) throw;
    throw Error(ErrorKind::files, error.problems().front().what, remedy);
  } catch (const std::exception&) {  // of JSON: its message may quote the file
    refuse_sealed(path, "its head is damaged", remedy_by_previous(path));
  }
}

}  // namespace

Checkpoint read_checkpoint(const fs::path& path) {
  return sealed(path, read_parts);
}

std::string read_continuation(const fs::path& path) {
  return sealed(path, [](const fs::path& file) {
    SealedReader reader(file);
    return continuation_behind(read_head_of_file(reader), reader);
  });
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
