// SPDX-License-Identifier: MIT
#include "store/stored_run.hpp"

#include <optional>
#include <type_traits>
#include <utility>

#include "base/error.hpp"
#include "solver/default_step.hpp"
#include "solver/divergence.hpp"
#include "store/checkpoint.hpp"
#include "store/hdf5_reader.hpp"
#include "store/lattice_hash.hpp"
#include "store/recording.hpp"
#include "store/run_facts.hpp"

namespace hackle {
namespace {

// Whether a noun has a function of place or time, which in a noun that was read cannot be called.
template <Described Noun>
bool has_function(const Noun& noun) {
  bool found = false;
  for_each_member<Noun>([&](const auto& member) {
    const auto& value = noun.*member.pointer;
    using T = std::remove_cvref_t<decltype(value)>;
    if constexpr (std::is_same_v<T, Amplitude>)
      found = found || value.is_function();
    else if constexpr (requires { value.varies_in_time(); })
      found = found || !value.is_constant();
    else if constexpr (Described<T>)
      found = found || has_function(value);
    else if constexpr (is_list<T>)
      for (const auto& entry : value)
        if constexpr (Described<std::remove_cvref_t<decltype(entry)>>)
          found = found || has_function(entry);
  });
  return found;
}

// The state of a checkpoint without what acts on it.
struct BareState {
  explicit BareState(const Checkpoint& checkpoint)
      : inputs(checkpoint.inputs),
        lattice(inputs.plate, inputs.numerics),
        state(checkpoint.snapshot.state) {
    if (lattice_hash(lattice) != checkpoint.lattice_hash || !fits(state, lattice))
      throw Error(ErrorKind::files, "checkpoint: its lattice cannot be built again",
                  "take the version of Hackle that wrote it");
    check_finite(view());
  }

  View view() const {
    const double dt = inputs.numerics.step.value_or(default_step(inputs.plate, lattice, 1.0));
    return {inputs.plate, inputs.numerics, lattice, dt, state, cold};
  }

  Inputs inputs;
  Lattice lattice;
  State state;
  std::vector<double> cold;
};

}  // namespace

struct StoredRun::Parts {
  explicit Parts(const std::filesystem::path& path_) : path(path_), kind(kind_of_stored(path_)) {
    if (kind == StoredKind::run)
      open_run();
    else if (kind == StoredKind::checkpoint)
      open_checkpoint();
    else
      refuse_kind(path, "neither a run file nor a checkpoint");
  }

  void open_run() {
    recording.emplace(path);
    inputs = read_inputs(Hdf5Reader(path).text("inputs"));
    origin = recording->origin();
    times = recording->times();
    recording->go_to(times.size() - 1);
    last_step = recording->view().state().step;
    recording->go_to(0);
  }

  void open_checkpoint() {
    Checkpoint checkpoint = read_checkpoint(path);
    inputs = checkpoint.inputs;
    origin = checkpoint.origin;
    last_step = checkpoint.snapshot.state.step;
    if (has_function(inputs.plate))
      bare.emplace(checkpoint);
    else
      simulation.emplace(resume(std::move(checkpoint), {}));
    times = {view().time()};
  }

  View view() const {
    if (recording) return recording->view();
    return simulation ? simulation->view() : bare->view();
  }

  std::filesystem::path path;
  StoredKind kind;
  Inputs inputs;
  Origin origin;
  std::vector<double> times;
  std::int64_t last_step = 0;
  std::optional<Recording> recording;  // one of these three
  std::optional<Simulation> simulation;
  std::optional<BareState> bare;
};

StoredRun::StoredRun(const std::filesystem::path& path) : parts_(std::make_unique<Parts>(path)) {
}

StoredRun::~StoredRun() = default;

const std::filesystem::path& StoredRun::path() const {
  return parts_->path;
}

StoredKind StoredRun::kind() const {
  return parts_->kind;
}

const Origin& StoredRun::origin() const {
  return parts_->origin;
}

const Inputs& StoredRun::inputs() const {
  return parts_->inputs;
}

const std::vector<double>& StoredRun::times() const {
  return parts_->times;
}

std::int64_t StoredRun::last_step() const {
  return parts_->last_step;
}

void StoredRun::show(std::size_t k) {
  if (parts_->recording) parts_->recording->go_to(k);
}

View StoredRun::view() const {
  return parts_->view();
}

bool StoredRun::velocity_is_of_its_time() const {
  return !parts_->bare;
}

bool StoredRun::is_exact() const {
  return !parts_->recording;
}

}  // namespace hackle
