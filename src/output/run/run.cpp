// SPDX-License-Identifier: MIT
// Longer than other units: one short function for each of Run, which hands the work to its parts.
#include "output/run/run.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/stopwatch.hpp"
#include "base/units.hpp"
#include "measure/crack_graph.hpp"
#include "output/files/movie_output.hpp"
#include "output/files/outputs.hpp"
#include "output/files/picture_files.hpp"
#include "output/files/record_output.hpp"
#include "output/files/series_output.hpp"
#include "output/picture/chart_data.hpp"
#include "output/picture/painting.hpp"
#include "output/report/account.hpp"
#include "output/report/notes.hpp"
#include "output/report/report.hpp"
#include "output/run/rehearsal.hpp"
#include "output/run/run_loop.hpp"
#include "output/run/same_inputs.hpp"
#include "store/checkpoint.hpp"
#include "store/inputs.hpp"
#include "store/journal.hpp"
#include "store/series_file.hpp"

namespace hackle {
namespace fs = std::filesystem;
namespace {

bool same_lattice(const Lattice& one, const Lattice& other) {
  return one.grid.layout() == other.grid.layout() && one.grid.dx == other.grid.dx &&
         one.bonds == other.bonds && one.initial_neighbours == other.initial_neighbours &&
         one.material == other.material && one.strength == other.strength;
}

// Tables that cannot be read back are left out: they say so themselves when they are completed.
std::vector<SeriesTable> tables_of(const std::vector<SeriesOutput*>& series) {
  std::vector<SeriesTable> tables;
  for (SeriesOutput* one : series) try {
      if (auto table = one->table()) tables.push_back(std::move(*table));
    } catch (const Error&) {
      continue;
    }
  return tables;
}

}  // namespace

namespace {

// Notes what comes to lie on a crack before the other observers look.
class GrowthFollower : public Observer {
 public:
  explicit GrowthFollower(CrackGrowth& growth) : growth_(growth) {}
  bool due(const Simulation& simulation) override {
    growth_.follow(simulation);
    return false;
  }
  void observe(const Simulation&) override {}

 private:
  CrackGrowth& growth_;
};

}  // namespace

struct Run::Parts {
  Parts(Plate plate, const Numerics& numerics, Execution execution, Talk talk_, Origin origin_)
      : talk(talk_),
        origin(std::move(origin_)),
        simulation(std::move(plate), numerics, execution),
        setup_seconds(life.seconds()) {}
  Parts(Simulation simulation_, Talk talk_, Origin origin_)
      : talk(talk_),
        origin(std::move(origin_)),
        simulation(std::move(simulation_)),
        setup_seconds(life.seconds()) {}
  explicit Parts(const Parts& other)
      : talk(other.talk),
        origin(other.origin),
        simulation(other.simulation),
        growth(other.growth),
        prospect(other.prospect) {
    outputs.limit(other.outputs.limit());
    outputs.share(other.outputs.names());
  }

  double unused = 0.0;
  Stopwatch life{unused};
  Talk talk;
  Origin origin;
  Simulation simulation;
  double setup_seconds = 0.0;
  Outputs outputs{default_output_limit};
  std::vector<SeriesOutput*> series;  // among the outputs
  PictureFiles pictures;              // of frame()
  std::vector<fs::path> saved;
  std::vector<std::shared_ptr<Journal>> journals;  // of its records
  RunLoop loop;
  Notes notes{talk};
  CrackGrowth growth;
  std::optional<ErrorBudget> budget;
  std::shared_ptr<FieldSampler> sampler;  // none, unless it is asked for
  Prospect prospect;
  bool rehearsing = false;
  bool pretends = false;        // to be where it is not: nothing can be said of it
  bool course_goes_on = false;  // slow loading that a checkpoint was kept in

  // Tells the journals what has been done.
  template <class Tell>
  void note(const Tell& tell) const {
    if (outputs.closed() || rehearsing) return;
    for (const auto& journal : journals) tell(*journal);
  }

  void tell_samples(Summary& summary) const {
    summary.sample = sampler->field();
    summary.plate = sampled_plate(simulation.lattice());
    summary.fragments = measured_fragments(simulation.view());
    summary.elastic = elastic_response(simulation.lattice(), simulation.dt());
  }

  void tell_of_cracks(Summary& summary) const {
    if (!growth.empty()) summary.graph = hackle::crack_graph(growth);
    summary.first_break = growth.first_break();
    if (!rehearsing && !pretends)
      summary.account = account_of(simulation, summary, growth, summary.graph);
  }

  // Outputs, watchers and `others` look on while the simulation goes where it aims.
  void go_on(std::vector<Observer*> others) {
    if (rehearsing) return prospect.arrive(simulation);
    GrowthFollower follower(growth);
    others.push_back(&follower);
    for (Observer* output : outputs.observers()) others.push_back(output);
    loop.go_on(simulation, loop.with_watchers(std::move(others)));
  }
};

namespace {

// Tells each look before the other observers look.
class LookCounter : public Observer {
 public:
  explicit LookCounter(std::function<void()> tell) : tell_(std::move(tell)) {}
  bool due(const Simulation&) override {
    tell_();
    return false;
  }
  void observe(const Simulation&) override {}

 private:
  std::function<void()> tell_;
};

}  // namespace

// Tells the journals that slow loading begins, and, however it ends, that it has ended.
class Run::SlowNote {
 public:
  SlowNote(const Parts& parts, const LoadedSlowly& loading) : parts_(parts) {
    parts_.note([&](Journal& journal) { journal.loads_slowly(parts_.simulation, loading); });
  }
  ~SlowNote() {
    parts_.note([&](Journal& journal) { journal.ended_slowly(parts_.simulation); });
  }
  SlowNote(const SlowNote&) = delete;

 private:
  const Parts& parts_;
};

Run::Run(Plate plate, Numerics numerics, Execution execution, Talk talk, Origin origin)
    : parts_(
          std::make_unique<Parts>(std::move(plate), numerics, execution, talk, std::move(origin))) {
  parts_->notes.begin(parts_->simulation);
}

Run::Run(Simulation simulation, Talk talk, Origin origin)
    : parts_(std::make_unique<Parts>(std::move(simulation), talk, std::move(origin))) {
  if (!parts_->simulation.has_arrived()) parts_->simulation.stop();
  parts_->notes.begin_judging_at(parts_->simulation);
}

Run::~Run() = default;

fs::path Run::movie(const fs::path& path, const MovieOptions& options) {
  check("movie", options.picture, parts_->simulation.lattice().grid);
  refuse_percentile("movie", options.picture);
  check_opaque("movie", options.picture);
  parts_->loop.refuse_while_running();
  auto output = std::make_unique<MovieOutput>(path, options, parts_->simulation, parts_->origin,
                                              parts_->simulation.threads(), parts_->talk,
                                              parts_->outputs.names());
  fs::path made = output->path();
  const std::string remark = output->remark();
  parts_->outputs.add("movie", made, FileKind::movie, std::move(output));
  parts_->notes.add(remark);
  return made;
}

void Run::record(const fs::path& path, const RecordOptions& options) {
  parts_->loop.refuse_while_running();
  check_ending("record", path, FileKind::run_file);
  auto output = std::make_unique<RecordOutput>(path, options, parts_->simulation, parts_->origin,
                                               parts_->talk, parts_->outputs.names());
  const std::string remark = output->remark();
  output->take_tables([parts = parts_.get()] { return tables_of(parts->series); });
  const std::shared_ptr<Journal> journal = output->journal();
  parts_->outputs.add("record", path, FileKind::run_file, std::move(output));
  parts_->journals.push_back(journal);
  parts_->notes.add(remark);
}

void Run::log(const fs::path& path, const SeriesOptions& options, std::vector<Column> columns) {
  parts_->loop.refuse_while_running();
  check_ending("log", path, FileKind::table);
  auto output =
      std::make_unique<SeriesOutput>(path, options, std::move(columns), parts_->simulation);
  SeriesOutput* const series = output.get();
  const std::string remark = output->remark();
  parts_->outputs.add("log", path, FileKind::table, std::move(output));
  parts_->series.push_back(series);
  parts_->notes.add(remark);
}

std::vector<SeriesTable> Run::tables() const {
  return tables_of(parts_->series);
}

void Run::frame(const fs::path& path, const PictureOptions& options) {
  check("frame", options, parts_->simulation.lattice().grid);
  check_alone("frame", options);
  parts_->outputs.names()->claim_checked("frame", path, FileKind::picture);
  if (parts_->rehearsing) return;
  if (options.overlay.graph) parts_->growth.count(parts_->simulation);
  parts_->pictures.write(path, parts_->simulation, options, parts_->growth);
}

void Run::save(const fs::path& path) {
  if (!parts_->loop.is_watched()) parts_->loop.refuse_while_running();
  parts_->outputs.names()->claim_checked("save", path, FileKind::checkpoint);
  if (parts_->rehearsing) return;
  write_checkpoint(path, image_of(parts_->simulation, parts_->origin));
  if (std::ranges::find(parts_->saved, path) == parts_->saved.end()) parts_->saved.push_back(path);
}

void Run::keep_checkpoints(double seconds, std::function<fs::path()> place,
                           std::function<std::string()> continuation) {
  parts_->outputs.keep_continuable();
  const auto settled = [this] { return parts_->outputs.settled(); };
  parts_->loop.keep_checkpoints(seconds, {std::move(place), std::move(continuation), settled},
                                parts_->origin, parts_->talk);
}

void Run::keep_last() {
  parts_->loop.keep_last(parts_->simulation);
}

void Run::finish_checkpoints() const {
  parts_->loop.finish_checkpoints();
}

std::vector<OutputMark> Run::marks() const {
  return parts_->outputs.marks();
}

void Run::settle() {
  parts_->outputs.settled()();
}

std::vector<fs::path> Run::kept_files() const {
  return parts_->outputs.kept_files();
}

void Run::pretend(const TimePoint& point) {
  parts_->simulation.pretend(point);
  parts_->pretends = true;
}

void Run::restore(Checkpoint checkpoint) {
  Simulation& simulation = parts_->simulation;
  check_same_inputs(inputs_of(simulation), checkpoint.inputs_text);
  checkpoint.inputs = {simulation.plate(), simulation.numerics()};  // with functions
  parts_->course_goes_on = checkpoint.snapshot.course.has_value();
  simulation =
      hackle::resume(std::move(checkpoint), {simulation.threads(), simulation.instruction_set()});
  parts_->notes.begin_judging_at(simulation);
  parts_->growth = {};
  parts_->pretends = false;
}

void Run::continue_outputs(const std::vector<OutputMark>& marks) {
  parts_->outputs.continue_from(marks);
}

void Run::go_on_to_aim() {
  try {
    wait();
  } catch (const Error&) {
    parts_->simulation.stop();  // time not reached is not made up for
    throw;
  }
}

void Run::share_names(std::shared_ptr<OutputNames> names) {
  parts_->outputs.share(std::move(names));
}

void Run::limit_output(double bytes) {
  parts_->outputs.limit(bytes);
}

void Run::set_loads(Loads loads) {
  if (!parts_->loop.is_watched()) parts_->loop.refuse_while_running();
  const Mark busy = parts_->loop.mark_busy();  // functions of place are called now
  const std::vector<double> strain = parts_->simulation.thermal_strain();
  if (parts_->rehearsing) parts_->prospect.exchange_loads(parts_->simulation, loads);
  parts_->simulation.set_loads(std::move(loads));
  parts_->note([&](Journal& journal) { journal.changed_loads(parts_->simulation); });
  if (parts_->pretends) return;
  parts_->notes.exchange_loads(parts_->simulation, strain);
  if (under_way() && !parts_->rehearsing) parts_->notes.look_at_loads(parts_->simulation);
}

void Run::watch(std::shared_ptr<Observer> watcher) {
  const std::string remark = watcher->remark();
  parts_->loop.watch(std::move(watcher));
  parts_->notes.add(remark);
}

void Run::set_budget(const ErrorBudget& budget) {
  parts_->budget = budget;
}

void Run::sample_at(double time) {
  parts_->sampler = std::make_shared<FieldSampler>(time);
  watch(parts_->sampler);
}

void Run::stop() {
  if (under_way()) parts_->simulation.stop();
  parts_->simulation.break_off();  // of quasi-static loading
}

Run::Run(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {
}

std::shared_ptr<Run> Run::fork() const {
  std::shared_ptr<Run> run(new Run(std::make_unique<Parts>(*parts_)));
  run->stop();
  run->parts_->notes.begin_judging_at(run->parts_->simulation);
  return run;
}

void Run::rewind(const Run& other) {
  parts_->loop.refuse_while_running();
  check_arrived("rewind");
  if (!same_lattice(parts_->simulation.lattice(), other.simulation().lattice()))
    throw Error(ErrorKind::refused, "rewind: that is a simulation of another plate or lattice",
                "go back to what s:fork() has kept");
  if (!parts_->outputs.empty() && !parts_->outputs.closed())
    throw Error(ErrorKind::refused, "rewind: its movies and records would go back in time",
                "complete them with s:close(), or go on with the other simulation");
  if (&other == this) return;
  parts_->simulation = other.simulation();
  parts_->prospect = other.parts_->prospect;
  parts_->growth = other.parts_->growth;
}

void Run::check_open(const char* who) const {
  parts_->loop.refuse_while_running();
  if (parts_->outputs.closed() && !parts_->outputs.empty())
    throw Error(ErrorKind::refused,
                fmt::format("{}: the simulation is closed and its files are complete", who));
}

void Run::check_arrived(const char* who) const {
  if (under_way())
    throw Error(ErrorKind::refused,
                fmt::format("{}: a run is under way until {}", who,
                            quantity(parts_->simulation.end_time(), "s")),
                "s:wait() lets it arrive, s:stop() ends it");
}

void Run::run(double duration) {
  start(duration);
  go_on_to_aim();
}

void Run::start(double duration) {
  check_open("run");
  parts_->outputs.check_room(parts_->simulation, duration,
                             std::numeric_limits<std::int64_t>::max());
  if (!parts_->rehearsing) parts_->outputs.reserve();
  resume();
  const Mark busy = parts_->loop.mark_busy();  // functions of time are called now
  parts_->simulation.aim(duration);
  parts_->notes.look_at_loads(parts_->simulation);
}

void Run::go_on(double seconds) {
  if (paused() || !under_way()) return;
  Break end(parts_->simulation);
  end.after_seconds(seconds);
  parts_->go_on({&end});
}

void Run::wait(std::optional<std::int64_t> steps) {
  parts_->loop.refuse_while_running();
  resume();
  Simulation& simulation = parts_->simulation;
  ProgressObserver progress(parts_->talk, simulation.time(), simulation.end_time());
  Break end(simulation);
  if (steps) end.after_step(*steps);
  try {
    parts_->go_on({&progress, &end});
  } catch (const Error&) {
    pause();  // after an interrupt
    throw;
  }
}

bool Run::under_way() const {
  return !parts_->simulation.has_arrived();
}

void Run::pause() {
  parts_->loop.pause();
}

void Run::resume() {
  parts_->loop.resume();
}

bool Run::paused() const {
  return parts_->loop.paused();
}

void Run::interrupt_at(std::int64_t step) {
  watch(std::make_shared<Interrupt>(step));
}

std::optional<std::int64_t> Run::take_interrupt() {
  return parts_->loop.take_interrupt();
}

void Run::step(std::int64_t count) {
  check_open("step");
  check_arrived("step");
  const Simulation& simulation = parts_->simulation;
  run(simulation.time_at(simulation.state().step + count) - simulation.end_time());
}

RelaxResult Run::relax(double tolerance) {
  check_open("relax");
  check_arrived("relax");
  if (parts_->rehearsing) {
    parts_->prospect.relax(parts_->simulation);
    return {};
  }
  const Mark busy = parts_->loop.mark_busy();
  Progress progress(parts_->talk);
  const RelaxResult result = parts_->simulation.relax(
      {tolerance, [&](double fraction, int iterations) {
         if (progress.due(fraction))
           progress.show(fraction,
                         fmt::format("coming to rest  iteration {}", grouped(iterations)));
       }});
  parts_->note([&](Journal& journal) { journal.came_to_rest(parts_->simulation, tolerance); });
  return result;
}

QuasistaticResult Run::load_slowly(double duration, int increments, double tolerance) {
  check_open("quasistatic");
  check_arrived("quasistatic");
  parts_->outputs.check_room(parts_->simulation, duration, increments + 1LL);
  if (parts_->rehearsing) {
    parts_->prospect.arrive_slowly(parts_->simulation, duration, increments);
    return {};
  }
  parts_->outputs.reserve();
  LookCounter counter([this] { parts_->note([](Journal& journal) { journal.looked(); }); });
  std::vector<Observer*> observers = parts_->loop.with_watchers(parts_->outputs.observers());
  GrowthFollower follower(parts_->growth);
  observers.insert(observers.begin(), {&counter, &follower});
  const Mark busy = parts_->loop.mark_busy();
  Progress progress(parts_->talk);
  const auto show = [&](double fraction, int increment, int pass, std::int64_t broken) {
    if (progress.due(fraction))
      progress.show(fraction, fmt::format("increment {} of {}  pass {}  {} bonds broken", increment,
                                          increments, pass, grouped(broken)));
  };
  QuasistaticResult result;
  parts_->loop.keeping(parts_->simulation, [&] {
    const bool goes_on = std::exchange(parts_->course_goes_on, false);
    const SlowNote note(*parts_, {parts_->simulation.end_time() + duration, increments, tolerance});
    if (goes_on) parts_->note([&](Journal& journal) { journal.lose_track(parts_->simulation); });
    result =
        parts_->simulation.load_slowly({duration, increments, tolerance, goes_on, show}, observers);
  });
  return result;
}

void Run::close() {
  parts_->loop.refuse_while_running();
  stop();
  judge();
  parts_->loop.forget_watchers();
  finish_checkpoints();
  parts_->outputs.close();
}

void Run::judge() {
  if (!parts_->rehearsing && !parts_->pretends) parts_->notes.judge(parts_->simulation);
}

void Run::rehearse() {
  parts_->rehearsing = true;
  parts_->outputs.names()->rehearses = true;
}

void Run::look() {
  parts_->prospect.look();
}

void Run::doubt(std::string why) {
  if (parts_->rehearsing) parts_->prospect.doubt(std::move(why));
}

Rehearsal Run::rehearsal() const {
  return hackle::rehearse(parts_->simulation, parts_->prospect);
}

const Simulation& Run::simulation() const {
  return parts_->simulation;
}

Summary Run::summary() const {
  Summary summary = summary_of(parts_->simulation);
  summary.script = parts_->origin.script_name;
  summary.notes = parts_->notes.all();
  summary.wall.setup = parts_->setup_seconds;
  parts_->tell_of_cracks(summary);
  summary.budget = parts_->budget;
  if (parts_->sampler) parts_->tell_samples(summary);
  parts_->pictures.add_to(summary);
  parts_->outputs.add_to(summary);
  summary.files.insert(summary.files.end(), parts_->saved.begin(), parts_->saved.end());
  summary.wall.total = parts_->life.seconds();
  return summary;
}

CrackGraph Run::crack_graph() const {
  parts_->growth.count(parts_->simulation);
  return hackle::crack_graph(parts_->growth);
}

std::string Run::report() const {
  return hackle::report(parts_->simulation, summary());
}

}  // namespace hackle
