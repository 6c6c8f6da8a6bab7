// SPDX-License-Identifier: MIT
#include "output/run/proof.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.hpp"
#include "base/units.hpp"
#include "output/run/progress_observer.hpp"
#include "store/exact_state.hpp"
#include "store/record_arrays.hpp"
#include "store/recorded_run.hpp"
#include "store/xdmf.hpp"

namespace hackle {
namespace {

// The values of a dataset in the file, in the order of those computed.
std::vector<double> recorded_values(const Hdf5Reader& file, const std::string& place,
                                    const RecordArray& array) {
  if (std::holds_alternative<std::vector<std::uint32_t>>(array.values)) {
    const std::vector<std::uint32_t> words = file.words(place, array.shape);
    return {words.begin(), words.end()};
  }
  return file.doubles(place, array.shape, array.given);
}

bool same_bits(double one, double other) {
  return std::bit_cast<std::uint64_t>(one) == std::bit_cast<std::uint64_t>(other);
}

// Compares the records of a file with a simulation that has come to them.
class Comparison {
 public:
  Comparison(const RecordedRun& run, const RecordContents& contents)
      : run_(run), contents_(contents) {}

  // Returns the first difference in the fields, bodies and state of a record, or in its hash.
  std::optional<Discrepancy> look(std::size_t record, const Simulation& simulation) {
    std::optional<Discrepancy> found;
    const std::string group = record_group(record);
    for_each_dataset(simulation, contents_, run_.is_exact(record), [&](const RecordArray& array) {
      if (!found) found = in_array(record, group, array, simulation);
    });
    const std::string hash = simulation.state().hash();
    same_hash_ = !run_.has_hashes() || run_.hash_of(record) == hash;
    if (!found && !same_hash_) {
      found = begun(record);
      found->quantity = "state_hash";
      found->recorded = run_.hash_of(record);
      found->computed = hash;
    }
    return found;
  }
  // Of the record looked at last.
  bool same_hash() const { return same_hash_; }

 private:
  Discrepancy begun(std::size_t record) const {
    Discrepancy difference;
    difference.record = record;
    difference.time = run_.times()[record];
    difference.step = run_.steps()[record];
    return difference;
  }

  std::optional<Discrepancy> in_array(std::size_t record, const std::string& group,
                                      const RecordArray& array,
                                      const Simulation& simulation) const {
    const std::vector<double> recorded =
        recorded_values(run_.file(), group + "/" + array.name, array);
    for (std::size_t at = 0; at < recorded.size(); ++at)
      if (!same_bits(recorded[at], array.value(at))) {
        Discrepancy difference = begun(record);
        difference.quantity = array.name;
        difference.recorded = fmt::format("{}", recorded[at]);
        difference.computed = fmt::format("{}", array.value(at));
        place(difference, array, at, recorded[at], simulation.lattice());
        return difference;
      }
    return std::nullopt;
  }

  // Says to what a value of an array belongs.
  void place(Discrepancy& difference, const RecordArray& array, std::size_t at, double recorded,
             const Lattice& lattice) const {
    const std::size_t row = at / array.given, column = at % array.given;
    if (is_of_bodies(array.name)) {
      difference.detail = fmt::format("number {}, value {}", row + 1, column + 1);
      return;
    }
    const bool whole = array.shape[0] == lattice.grid.nodes();
    const NodeWindow nodes =
        whole ? NodeWindow{0, 0, lattice.grid.nx, lattice.grid.ny, 1} : contents_.nodes;
    const auto columns = static_cast<std::size_t>(nodes.nx);
    const int i = nodes.i + nodes.stride * static_cast<int>(row % columns);
    const int j = nodes.j + nodes.stride * static_cast<int>(row / columns);
    difference.node = Vec2(i, j);
    difference.place = lattice.grid.position(i, j);
    if (array.name == "broken")
      tell_bond(difference, lattice.family, column, recorded, array.value(at));
    else if (array.given > 1)
      difference.detail = column == 0 ? "along x" : "along y";
  }

  static bool is_of_bodies(std::string_view name) {
    return name == "discs" || name == "rollers" || name == "platens";
  }

  // Names the first bond of a word of bits that is not as recorded.
  static void tell_bond(Discrepancy& difference, const Family& family, std::size_t word,
                        double recorded, double computed) {
    const auto bits = static_cast<std::uint32_t>(recorded) ^ static_cast<std::uint32_t>(computed);
    const int bit = 32 * static_cast<int>(word) + std::countr_zero(bits);
    difference.detail = "a bond that the plate has not";
    family.for_each_bond([&](int column, int row, const Vec2&, double, int its_bit) {
      if (its_bit == bit)
        difference.detail = fmt::format("bond to the node {} columns and {} rows on", column, row);
    });
    const std::uint32_t mask = std::uint32_t{1} << static_cast<unsigned>(bit % 32);
    const auto told = [mask](double word_of_bits) {
      return (static_cast<std::uint32_t>(word_of_bits) & mask) != 0 ? "broken" : "intact";
    };
    difference.recorded = told(recorded);
    difference.computed = told(computed);
  }

  const RecordedRun& run_;
  const RecordContents& contents_;
  bool same_hash_ = true;
};

// A deed, or the record that is taken after those before it.
struct Item {
  std::int64_t step = 0;
  int look = -1;  // see Deed
  std::optional<std::size_t> record;
  Deed deed{};
};

std::vector<Item> items_of(const RecordedRun& run) {
  std::vector<Item> items;
  for (std::size_t record = 0; record < run.times().size(); ++record) {
    Item taken{run.steps()[record], -1, record};
    for (Deed& deed : run.deeds_before(record)) {
      if (std::holds_alternative<Recorded>(deed.what))
        taken.look = deed.look;
      else
        items.push_back({deed.step, deed.look, std::nullopt, std::move(deed)});
    }
    items.push_back(std::move(taken));
  }
  return items;
}

// Does a recorded run again. It looks on itself, at the steps and looks where something was done.
class Retracing : public Observer {
 public:
  Retracing(const RecordedRun& run, Simulation& simulation, Comparison& comparison, Proof& proof,
            Talk talk)
      : run_(run),
        simulation_(simulation),
        comparison_(comparison),
        proof_(proof),
        items_(items_of(run)),
        progress_(talk, simulation.time(), std::max(run.times().back(), simulation.time())) {}

  void go() {
    while (next_ < items_.size() && !ended()) {
      const Item& item = items_[next_];
      if (item.step < simulation_.state().step || item.look >= 0)
        return stop_at("what its journal says is not in order");
      if (item.record)
        go_to(item.step);
      else
        do_next();
    }
  }

  // A record is compared as it is seen, at its time.
  bool due(const Simulation& simulation) override {
    if (is_slow_) {
      ++look_;
      return true;
    }
    return wants_record() && simulation.state().step == items_[next_].step;
  }
  double moment(const Simulation& simulation) override {
    return wants_record() ? run_.times()[*items_[next_].record] : simulation.time();
  }
  void observe(const Simulation& simulation) override {
    if (!is_slow_) return compare(simulation);
    while (next_ < items_.size() && is_slow_ && !ended() && happens_now()) {
      if (items_[next_].record)
        compare(simulation);
      else
        do_in_between();
    }
    if (ended() || next_ == items_.size()) end_slow();
  }

 private:
  bool ended() const { return proof_.difference || !proof_.stopped.empty(); }
  bool wants_record() const { return next_ < items_.size() && items_[next_].record; }
  void stop_at(const std::string& why) { proof_.stopped = why; }

  void compare(const Simulation& simulation) {
    proof_.difference = comparison_.look(*items_[next_].record, simulation);
    proof_.exact_hash = comparison_.same_hash();
    ++proof_.compared;
    ++next_;
    if (proof_.difference) simulation_.break_off();
  }

  // To a step, at which the next record is compared if it was taken there.
  void go_to(std::int64_t step) {
    const std::size_t before = next_;
    simulation_.stop();
    simulation_.aim(std::max(simulation_.time_at(step) - simulation_.end_time(), 0.0));
    const std::array<Observer*, 2> observers{&progress_, this};
    simulation_.go_on(observers);
    if (simulation_.state().step != step || (wants_record() && next_ == before))
      stop_at("its step cannot be reached");
  }

  void do_next() {
    const Deed& deed = items_[next_].deed;
    if (simulation_.state().step < deed.step) {
      go_between(deed.step);
      if (ended()) return;
    }
    ++next_;
    std::visit([this](const auto& what) { carry_out(what); }, deed.what);
  }

  // To the step of a deed: no record waits there.
  void go_between(std::int64_t step) {
    simulation_.stop();
    simulation_.aim(std::max(simulation_.time_at(step) - simulation_.end_time(), 0.0));
    const std::array<Observer*, 1> observers{&progress_};
    simulation_.go_on(observers);
    if (simulation_.state().step != step) stop_at("the step of a change cannot be reached");
  }

  void carry_out(const ChangedLoads& changed) {
    if (changed.functions.empty()) return simulation_.set_loads(changed.loads);
    stop_at(
        fmt::format("the loads set before it are functions of a script, which a run file does "
                    "not hold: {}",
                    fmt::join(changed.functions, ", ")));
  }
  void carry_out(const CameToRest& rest) { simulation_.relax({rest.tolerance}); }
  void carry_out(const LoadedSlowly& loading) {
    if (ends_unseen()) return;
    simulation_.stop();
    if (!(loading.end > simulation_.end_time()))
      return stop_at("it was loaded slowly for less than a step");
    QuasistaticOptions options;
    options.increments = loading.increments;
    options.tolerance = loading.tolerance;
    options.duration = duration_to(loading.end);
    is_slow_ = true;
    look_ = -1;
    const std::array<Observer*, 1> observers{this};
    simulation_.load_slowly(options, observers);
    is_slow_ = false;
    if (!ended() && next_ < items_.size() && items_[next_].look >= 0)
      stop_at("its slow loading ends earlier than recorded");
    else if (!ended() && next_ < items_.size() && is_end(items_[next_]))
      ++next_;
  }
  void carry_out(const EndedSlowly&) {}
  void carry_out(const Recorded&) {}
  void carry_out(const NotNoted&) {
    stop_at("more was changed before it than a run file notes between two records");
  }

  static bool is_end(const Item& item) {
    return !item.record && std::holds_alternative<EndedSlowly>(item.deed.what);
  }
  bool ends_unseen() const {
    return next_ < items_.size() && is_end(items_[next_]) &&
           std::get<EndedSlowly>(items_[next_].deed.what).looks == 0;
  }

  // The duration after which slow loading that begins now ends at that very time: rounding may
  // take the difference of the two a little off.
  double duration_to(double end) const {
    const double now = simulation_.end_time();
    double duration = end - now;
    const double infinity = std::numeric_limits<double>::infinity();
    while (now + duration < end) duration = std::nextafter(duration, infinity);
    while (now + duration > end) duration = std::nextafter(duration, -infinity);
    return duration;
  }

  // Whether the next item belongs to this look of slow loading.
  bool happens_now() const {
    const Item& item = items_[next_];
    if (is_end(item)) return std::get<EndedSlowly>(item.deed.what).looks <= look_ + 1;
    return item.look == look_;
  }
  void do_in_between() {
    const Deed& deed = items_[next_].deed;
    ++next_;
    if (const auto* changed = std::get_if<ChangedLoads>(&deed.what))
      carry_out(*changed);
    else
      end_slow();  // there it was broken off, or had arrived
  }
  void end_slow() {
    is_slow_ = false;
    simulation_.break_off();
  }

  const RecordedRun& run_;
  Simulation& simulation_;
  Comparison& comparison_;
  Proof& proof_;
  std::vector<Item> items_;
  std::size_t next_ = 0;
  ProgressObserver progress_;
  bool is_slow_ = false;  // in slow loading
  int look_ = -1;         // of it
};

Simulation begun(const RecordedRun& run, const Execution& execution) {
  return run.is_exact(0) ? run.simulation_at(0, execution) : run.simulation_at_start(execution);
}

}  // namespace

Proof prove(const std::filesystem::path& run_file, const Execution& execution, Talk talk) {
  const RecordedRun run(run_file);
  Simulation simulation = begun(run, execution);
  const RecordContents contents = contents_of(run.file(), simulation.lattice().grid);
  Comparison comparison(run, contents);
  Proof proof;
  proof.records = run.times().size();
  proof.has_hashes = run.has_hashes();
  Retracing(run, simulation, comparison, proof, talk).go();
  return proof;
}

}  // namespace hackle
