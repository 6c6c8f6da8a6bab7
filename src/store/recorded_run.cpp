// SPDX-License-Identifier: MIT
#include "store/recorded_run.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.hpp"
#include "base/machine.hpp"
#include "base/units.hpp"
#include "lattice/check_numerics.hpp"
#include "store/exact_state.hpp"
#include "store/lattice_hash.hpp"
#include "store/run_facts.hpp"
#include "store/run_file.hpp"
#include "store/xdmf.hpp"

namespace hackle {
namespace {

void check_format(const Hdf5Reader& file) {
  if (!file.has_attribute("software") || file.attribute("software") != "Hackle" ||
      !file.has_attribute("format_version"))
    file.refuse("it is no run file of Hackle", "s:record{} writes run files");
  const std::int64_t format = file.integer("format_version");
  if (format < oldest_run_file_format)
    file.refuse(fmt::format("it was written in format {}, which lacks the bonds", format),
                "run its script again to record it anew");
  if (format > run_file_format)
    file.refuse(fmt::format("it was written in format {}, newer than {}", format, run_file_format),
                "take the version of Hackle that wrote it");
}

Hdf5Reader opened(const std::filesystem::path& path) {
  Hdf5Reader file(path);
  check_format(file);
  return file;
}

hsize_t committed(const Hdf5Reader& file) {
  const std::int64_t count = file.integer("records_committed");
  if (count < 0 || count > max_records)
    file.refuse(fmt::format("it says that it holds {} records", count));
  if (count == 0) file.refuse("it holds no record", "its run ended before the first one");
  return static_cast<hsize_t>(count);
}

[[noreturn]] void refuse_functions_of(const std::vector<std::string>& functions) {
  throw Error(ErrorKind::refused,
              fmt::format("its loads are functions of a script, which a run file does not hold: {}",
                          fmt::join(functions, ", ")),
              "give their amplitudes as tables, {{t, factor}, ...}");
}

}  // namespace

RecordedRun::RecordedRun(const std::filesystem::path& path)
    : path_(path),
      count_(committed(opened(path))),
      file_(opened(path)),
      inputs_text_(file_.text("inputs")),
      inputs_(read_inputs(inputs_text_)) {
  read_times();
}

void RecordedRun::read_times() {
  times_ = file_.first_doubles("time", count_);
  steps_ = file_.first_integers("step", count_);
  for (std::size_t k = 0; k < count_; ++k)
    if (!(std::isfinite(times_[k]) && steps_[k] >= 0 &&
          static_cast<double>(steps_[k]) <= max_steps && (k == 0 || times_[k] >= times_[k - 1])))
      file_.refuse(fmt::format("time or step of record {} is damaged", k));
  if (file_.holds("state_hash")) hashes_ = file_.first_texts("state_hash", count_, hash_digits);
  if (hashes_.find_first_not_of("0123456789abcdef") != std::string::npos)
    file_.refuse("its state_hash is missing or damaged");
}

std::vector<Deed> RecordedRun::deeds_before(std::size_t record) const {
  const std::string name = record_group(record) + "/journal";
  if (!file_.holds(name)) return {};
  const std::string text = file_.text(name);
  try {
    return deeds_in(text);
  } catch (const std::exception&) {  // its message may quote the file
    file_.refuse(fmt::format("its {} is damaged", name));
  }
}

std::size_t RecordedRun::nearest(double time) const {
  const auto after = std::ranges::lower_bound(times_, time);
  if (after == times_.begin()) return 0;
  const bool later = after != times_.end() && *after - time < time - *(after - 1);
  return static_cast<std::size_t>(after - times_.begin()) - (later ? 0 : 1);
}

bool RecordedRun::is_exact(std::size_t record) const {
  return holds_exact_state(file_, record_group(record));
}

// The plate with the loads that are in force at a record.
Plate RecordedRun::plate_at(std::size_t record) const {
  Plate plate = inputs_.plate;
  std::vector<std::string> functions = functions_in(inputs_text_);
  for (std::size_t k = 1; k <= record; ++k)
    for (Deed& deed : deeds_before(k))
      if (auto* changed = std::get_if<ChangedLoads>(&deed.what)) {
        plate.loads = std::move(changed->loads);
        functions = std::move(changed->functions);
      }
  if (!functions.empty()) refuse_functions_of(functions);
  return plate;
}

void RecordedRun::check_scene(const Plate& plate) const {
  Problems problems;
  check(plate, problems);
  check(plate, inputs_.numerics, available_memory(), problems);
  if (!problems.empty()) file_.refuse("its scene is impossible");
  const Grid grid = make_grid(plate, inputs_.numerics.spacing);
  file_.check_shape("nodes", {contents_of(file_, grid).nodes.nodes(), 3});
}

// What the scene refuses is a fault of the file.
template <class Make>
Simulation RecordedRun::made(const Make& make) const {
  try {
    return make();
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::interrupted || error.kind() == ErrorKind::files) throw;
    file_.refuse("its run cannot be begun again");
  }
}

Simulation RecordedRun::checked(Simulation simulation) const {
  if (file_.attribute("lattice_hash") != lattice_hash(simulation.lattice()))
    file_.refuse("its lattice cannot be built again",
                 "run its script again with this version, or take the version that recorded it");
  return simulation;
}

Simulation RecordedRun::simulation_at(std::size_t record, const Execution& execution) const {
  if (!is_exact(record))
    throw Error(ErrorKind::refused,
                fmt::format("'{}': its record at {} does not hold the exact state", path_.string(),
                            quantity(times_.at(record), "s")),
                "s:record { ..., exact = true } records it; the first record always holds it");
  Plate plate = plate_at(record);
  check_scene(plate);
  return checked(made([&] {
    Plate bare = plate;
    bare.loads = {};
    bare.initial_conditions.clear();
    const Lattice lattice(bare, inputs_.numerics);
    Snapshot snapshot = read_exact_state(file_, record_group(record), lattice);
    if (snapshot.state.step != steps_.at(record))
      file_.refuse(fmt::format("the exact state of record {} is damaged", record));
    return Simulation::resumed(std::move(plate), inputs_.numerics, std::move(snapshot), execution);
  }));
}

Simulation RecordedRun::simulation_at_start(const Execution& execution) const {
  const std::vector<std::string> functions = functions_in(inputs_text_);
  if (!functions.empty()) refuse_functions_of(functions);
  check_scene(inputs_.plate);
  return checked(made([&] { return Simulation(inputs_.plate, inputs_.numerics, execution); }));
}

}  // namespace hackle
