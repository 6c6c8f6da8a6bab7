// SPDX-License-Identifier: MIT
#include "store/checkpoint.hpp"

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cmath>
#include <concepts>
#include <cstdio>
#include <cstring>
#include <memory>
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
#include "base/hash.hpp"
#include "base/interrupt.hpp"
#include "base/machine.hpp"
#include "base/version.hpp"
#include "lattice/check_numerics.hpp"
#include "store/inputs.hpp"
#include "store/lattice_hash.hpp"

namespace hackle {
namespace fs = std::filesystem;
namespace {

static_assert(std::endian::native == std::endian::little);

using HeadJson = nlohmann::json;
constexpr std::string_view first_line = "Hackle checkpoint 1\n";
constexpr std::size_t digits_of_hash = 16;
constexpr std::uint64_t max_head = std::uint64_t{256} << 20U;
constexpr std::size_t piece = std::size_t{1} << 20U;  // read and written at once

[[noreturn]] void refuse(const fs::path& path, std::string_view what, std::string remedy = {}) {
  throw Error(ErrorKind::files, fmt::format("checkpoint '{}': {}", path.string(), what),
              std::move(remedy));
}

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using OpenFile = std::unique_ptr<std::FILE, CloseFile>;

OpenFile open(const fs::path& path, const char* mode) {
  OpenFile file(std::fopen(path.c_str(), mode));
  if (!file) refuse(path, std::strerror(errno));
  return file;
}

// Writes bytes and adds them to the hash of the file.
class Writer {
 public:
  explicit Writer(fs::path path) : path_(std::move(path)), file_(open(path_, "wbx")) {}

  template <class T>
  void write(std::span<const T> values) {
    hash_.add(values);
    put(values.data(), values.size_bytes());
  }
  void write(std::string_view text) { write(std::span(text.data(), text.size())); }

  // Adds the hash, and returns when the disk has everything.
  void finish() {
    const std::string hash = hash_.hex();
    put(hash.data(), hash.size());
    if (std::fflush(file_.get()) != 0 || fsync(fileno(file_.get())) != 0)
      refuse(path_, std::strerror(errno));
    file_.reset();
  }

 private:
  void put(const void* bytes, std::size_t count) {
    if (count == 0) return;  // of an array without memory
    if (std::fwrite(bytes, 1, count, file_.get()) != count) refuse(path_, std::strerror(errno));
  }

  fs::path path_;
  OpenFile file_;
  Hash hash_;
};

// Reads a file whose hash is known to be right, front to end.
class Reader {
 public:
  explicit Reader(const fs::path& path)
      : path_(path), file_(open(path, "rb")), left_(fs::file_size(path)) {}

  std::string text(std::uint64_t size) {
    std::string text(checked(size), '\0');
    get(text.data(), text.size());
    return text;
  }
  template <class T>
  void read(std::span<T> values) {
    get(values.data(), values.size_bytes());
  }
  // Returns the count if the file still has so many things of that size.
  std::uint64_t checked(std::uint64_t count, std::size_t size = 1) const {
    if (count > left_ / size) refuse("it is cut off");
    return count;
  }
  [[noreturn]] void refuse(std::string_view what) const { hackle::refuse(path_, what); }

 private:
  void get(void* bytes, std::size_t count) {
    left_ -= checked(count);
    if (count == 0) return;
    if (std::fread(bytes, 1, count, file_.get()) != count) refuse("it is cut off");
  }

  const fs::path& path_;
  OpenFile file_;
  std::uint64_t left_;
};

// Throws unless the file is whole: as long as when it was written, and of the same bytes.
enum class Patience { until_interrupted, endless };
void check_whole(const fs::path& path, Patience patience) {
  const OpenFile file = open(path, "rb");
  std::error_code ignored;
  std::uint64_t left = fs::file_size(path, ignored);
  if (ignored || left < first_line.size() + digits_of_hash) refuse(path, "it is no checkpoint");
  left -= digits_of_hash;
  Hash hash;
  std::vector<char> bytes(piece);
  bool first = true;
  while (left > 0) {
    if (patience == Patience::until_interrupted) throw_if_interrupted();
    const std::size_t count = std::min<std::uint64_t>(left, piece);
    if (std::fread(bytes.data(), 1, count, file.get()) != count) refuse(path, "it is cut off");
    if (std::exchange(first, false) &&
        !std::string_view(bytes.data(), count).starts_with(first_line))
      refuse(path, "it is no checkpoint of this version of Hackle");
    hash.add(std::span<const char>(bytes.data(), count));
    left -= count;
  }
  std::string said(digits_of_hash, '\0');
  if (std::fread(said.data(), 1, said.size(), file.get()) != said.size() || said != hash.hex())
    refuse(path, "it is damaged: its bytes are not those that were written");
}

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

void write_state(const State& state, Writer& writer) {
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

void take_name(const fs::path& from, const fs::path& to) {
  std::error_code failure;
  fs::rename(from, to, failure);
  if (failure) refuse(to, failure.message());
}

// Says how to go on with the previous checkpoint, if it is whole.
std::string remedy_by_previous(const fs::path& path) {
  const fs::path previous = previous_checkpoint(path);
  std::error_code ignored;
  if (!fs::exists(previous, ignored)) return {};
  try {
    check_whole(previous, Patience::until_interrupted);
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
  const fs::path partial = partial_name(path);
  std::error_code ignored;
  fs::remove(partial, ignored);
  try {
    Writer writer(partial);
    writer.write(fmt::format("{}{}\n", first_line, image.head.size()));
    writer.write(image.head);
    write_state(image.state, writer);
    writer.finish();
    check_whole(partial, Patience::endless);
  } catch (...) {
    fs::remove(partial, ignored);
    throw;
  }
  if (fs::exists(path, ignored)) take_name(path, previous_checkpoint(path));
  take_name(partial, path);
  sync_folder_of(path);
}

namespace {

// The head begins after a line with its size.
std::uint64_t size_of_head(Reader& reader) {
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
Values<T> array_of(const HeadJson& size, Reader& reader) {
  Values<T> values(reader.checked(size.get<std::uint64_t>(), sizeof(T)));
  reader.read(std::span<T>(values));
  return values;
}

State read_state(const HeadJson& head, const NodeLayout& layout, Reader& reader) {
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

void check_parts(const Checkpoint& checkpoint, const Grid& grid, const Reader& reader) {
  for (const LoadedNode& node : checkpoint.snapshot.borne)
    if (!grid.contains(node.i, node.j)) reader.refuse("it names nodes that its plate has not");
  const State& state = checkpoint.snapshot.state;
  const Loads& loads = checkpoint.inputs.plate.loads;
  if (state.discs.size() != loads.impactors.size() ||
      state.rollers.size() != loads.rollers.size() || state.platens.size() != loads.platens.size())
    reader.refuse("its bodies are not those of its plate");
}

Checkpoint read_parts(const fs::path& path) {
  Reader reader(path);
  const std::uint64_t size = size_of_head(reader);
  if (size > max_head) reader.refuse("its head is too long");
  const HeadJson head = HeadJson::parse(reader.text(size));
  Checkpoint checkpoint{{head.at("script_name"), head.at("script")},
                        read_inputs(head.at("inputs").get<std::string>()),
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
    check_whole(path, Patience::until_interrupted);
    return read_parts(path);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::files) throw;
    const std::string remedy = remedy_by_previous(path);
    if (remedy.empty()) throw;
    throw Error(ErrorKind::files, error.problems().front().what, remedy);
  } catch (const std::exception&) {  // of JSON: its message may quote the file
    refuse(path, "its head is damaged", remedy_by_previous(path));
  }
}

// What its plate refuses is a fault of the file.
Simulation resume(Checkpoint checkpoint, const Execution& execution) {
  try {
    return Simulation::resumed(std::move(checkpoint.inputs.plate), checkpoint.inputs.numerics,
                               std::move(checkpoint.snapshot), execution);
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::interrupted || error.kind() == ErrorKind::files) throw;
    throw Error(ErrorKind::files, fmt::format("checkpoint: {}", error.problems().front().what),
                error.problems().front().remedy);
  }
}

}  // namespace hackle
