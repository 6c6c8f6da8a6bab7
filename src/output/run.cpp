// SPDX-License-Identifier: MIT
#include "output/run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <deque>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "base/files.hpp"
#include "base/machine.hpp"
#include "base/stopwatch.hpp"
#include "base/streams.hpp"
#include "base/units.hpp"
#include "output/chart_data.hpp"
#include "output/ledger_remark.hpp"
#include "output/load_remarks.hpp"
#include "output/movie_output.hpp"
#include "output/outputs.hpp"
#include "output/painting.hpp"
#include "output/progress_observer.hpp"
#include "output/record_output.hpp"
#include "output/report.hpp"
#include "render/png.hpp"

namespace hackle {
namespace fs = std::filesystem;
namespace {

// Of a script that is only checked; more would take weeks.
constexpr std::int64_t max_rehearsed = 1'000'000'000;

bool same_lattice(const Lattice& one, const Lattice& other) {
  return one.grid.layout() == other.grid.layout() && one.grid.dx == other.grid.dx &&
         one.bonds == other.bonds && one.initial_neighbours == other.initial_neighbours &&
         one.material == other.material && one.strength == other.strength;
}

}  // namespace

struct Run::Parts {
  Parts(Plate plate, const Numerics& numerics, Execution execution, Talk talk_, Origin origin_)
      : talk(talk_),
        origin(std::move(origin_)),
        simulation(std::move(plate), numerics, execution),
        setup_seconds(life.seconds()) {}
  explicit Parts(const Parts& other)
      : talk(other.talk),
        origin(other.origin),
        simulation(other.simulation),
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
  double frame_render_seconds = 0.0;
  double frame_store_seconds = 0.0;
  Outputs outputs{default_output_limit};
  std::vector<fs::path> pictures;  // written by frame()
  std::vector<std::shared_ptr<Observer>> watchers;
  Activity activity = Activity::none;
  bool paused = false;
  std::optional<std::int64_t> interrupted_at;
  std::vector<std::string> notes;
  std::array<double, 3> judged{0.0, 0.0, 0.0};  // step, time and work when the ledger was judged
  bool fresh_loads = true;                      // they have not been looked at
  bool acts_at_once = false;                    // some load was remarked on for that
  bool rehearsing = false;
  Prospect prospect;

  // What is new of these.
  void say(const std::vector<std::string>& remarks) {
    for (const std::string& remark : remarks) {
      if (std::ranges::find(notes, remark) != notes.end()) continue;
      notes.push_back(remark);
      if (talk != Talk::quiet) hackle::say("note: {}\n", remark);
    }
  }

  std::array<double, 3> situation() const {
    const State& state = simulation.state();
    return {static_cast<double>(state.step), simulation.time(), state.external_work};
  }

  // Of loads, before they act until the simulation arrives. Functions of time are asked.
  void look_at_loads() {
    const double end = simulation.end_time();
    try {
      say(load_remarks(simulation, end));
      say_at_once(at_once_remarks(simulation, end, std::exchange(fresh_loads, false)));
    } catch (const Error& error) {
      if (error.kind() == ErrorKind::interrupted) throw;  // else it is good at the steps: enough
    }
  }

  void say_at_once(const std::vector<std::string>& remarks) {
    acts_at_once = acts_at_once || !remarks.empty();
    say(remarks);
  }

  // Time passes, and nothing else does.
  void arrive() {
    State state = simulation.state();
    state.step = simulation.last_step();
    prospect.run(simulation, simulation.time_at(state.step));
    if (prospect.steps() > max_rehearsed)
      throw Error(ErrorKind::refused,
                  fmt::format("check: more than {} steps are asked for and there is no end",
                              grouped(max_rehearsed)),
                  "the script may wait for what only happens when it is run");
    simulation.restore(std::move(state));
  }

  // The same for slow loading, which takes no step.
  void load_slowly(double duration, int increments) {
    State state = simulation.state();
    state.clock = {simulation.time() + duration, state.step};
    prospect.load_slowly(simulation, state.clock.moment, increments);
    simulation.restore(std::move(state));
  }

  // Everyone who looks on, and `others`, while the simulation goes where it aims.
  void go_on(std::vector<Observer*> observers) {
    if (rehearsing) return arrive();
    for (Observer* output : outputs.observers()) observers.push_back(output);
    std::deque<Watched> watched;
    for (const auto& watcher : watchers)
      observers.push_back(&watched.emplace_back(watcher, activity));
    const Mark busy(activity, Activity::stepping);
    try {
      simulation.go_on(observers);
    } catch (const Error& error) {
      if (error.kind() == ErrorKind::interrupted)
        interrupted_at = simulation.state().step;
      else
        simulation.stop();
      throw;
    }
  }

  void refuse_while_running() const {
    if (activity == Activity::stepping)
      throw Error(ErrorKind::refused, "the simulation is running",
                  "functions of time may not run it or change it");
    if (activity == Activity::watched)
      throw Error(ErrorKind::refused, "the simulation is running",
                  "between two steps its loads may be changed, or s:stop() ends the run");
  }
};

Run::Run(Plate plate, Numerics numerics, Execution execution, Talk talk, Origin origin)
    : parts_(
          std::make_unique<Parts>(std::move(plate), numerics, execution, talk, std::move(origin))) {
  parts_->say(remarks(parts_->simulation));
  parts_->say_at_once(shock_remarks(parts_->simulation, {}));
}

Run::~Run() = default;

fs::path Run::movie(const fs::path& path, const MovieOptions& options) {
  check("movie", options.picture, parts_->simulation.lattice().grid);
  refuse_percentile("movie", options.picture);
  check_opaque("movie", options.picture);
  parts_->refuse_while_running();
  auto output = std::make_unique<MovieOutput>(path, options, parts_->simulation, parts_->origin,
                                              parts_->talk, parts_->outputs.names());
  fs::path made = output->path();
  parts_->outputs.add("movie", made, FileKind::movie, std::move(output));
  return made;
}

void Run::record(const fs::path& path, const RecordOptions& options) {
  parts_->refuse_while_running();
  check_ending("record", path, FileKind::run_file);
  auto output = std::make_unique<RecordOutput>(path, options, parts_->simulation, parts_->origin,
                                               parts_->talk, parts_->outputs.names());
  parts_->outputs.add("record", path, FileKind::run_file, std::move(output));
}

void Run::frame(const fs::path& path, const PictureOptions& options) {
  check("frame", options, parts_->simulation.lattice().grid);
  check_alone("frame", options);
  check_ending("frame", path, FileKind::picture);
  check_writable(path);
  parts_->outputs.names()->claim("frame", path, FileKind::picture);
  if (parts_->rehearsing) return;
  Image image;
  {
    const Stopwatch watch(parts_->frame_render_seconds);
    image = paint(parts_->simulation, options);
  }
  const Stopwatch watch(parts_->frame_store_seconds);
  make_folder_of(path);
  write_png(image, path);
  if (std::ranges::find(parts_->pictures, path) == parts_->pictures.end())
    parts_->pictures.push_back(path);
}

void Run::share_names(std::shared_ptr<OutputNames> names) {
  parts_->outputs.share(std::move(names));
}

void Run::limit_output(double bytes) {
  parts_->outputs.limit(bytes);
}

void Run::set_loads(Loads loads) {
  if (parts_->activity != Activity::watched) parts_->refuse_while_running();
  const Mark busy(parts_->activity, Activity::stepping);  // functions of place are asked now
  const std::vector<double> strain = parts_->simulation.thermal_strain();
  if (parts_->rehearsing) parts_->prospect.exchange_loads(parts_->simulation, loads);
  parts_->simulation.set_loads(std::move(loads));
  parts_->say_at_once(shock_remarks(parts_->simulation, strain));
  parts_->fresh_loads = true;
  if (under_way() && !parts_->rehearsing) parts_->look_at_loads();
}

void Run::watch(std::shared_ptr<Observer> watcher) {
  parts_->refuse_while_running();
  parts_->watchers.push_back(std::move(watcher));
}

void Run::stop() {
  if (under_way()) parts_->simulation.stop();
  parts_->simulation.break_off();  // from slow loading
}

Run::Run(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {
}

std::shared_ptr<Run> Run::fork() const {
  std::shared_ptr<Run> run(new Run(std::make_unique<Parts>(*parts_)));
  run->stop();
  run->parts_->judged = run->parts_->situation();  // what was before is judged once
  return run;
}

void Run::rewind(const Run& other) {
  parts_->refuse_while_running();
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
}

void Run::check_open(const char* who) const {
  parts_->refuse_while_running();
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
  try {
    wait();
  } catch (const Error&) {
    parts_->simulation.stop();  // what was not reached is not owed
    throw;
  }
}

void Run::start(double duration) {
  check_open("run");
  parts_->outputs.check_room(parts_->simulation, duration,
                             std::numeric_limits<std::int64_t>::max());
  if (!parts_->rehearsing) parts_->outputs.reserve();
  resume();
  const Mark busy(parts_->activity, Activity::stepping);  // functions of time are asked now
  Simulation& simulation = parts_->simulation;
  simulation.aim(duration);
  parts_->look_at_loads();
}

void Run::go_on(double seconds) {
  if (parts_->paused || !under_way()) return;
  Break end(parts_->simulation);
  end.after_seconds(seconds);
  parts_->go_on({&end});
}

void Run::wait(std::optional<std::int64_t> steps) {
  parts_->refuse_while_running();
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
  parts_->paused = true;
}

void Run::resume() {
  parts_->paused = false;
}

bool Run::paused() const {
  return parts_->paused;
}

void Run::interrupt_at(std::int64_t step) {
  watch(std::make_shared<Interrupt>(step));
}

std::optional<std::int64_t> Run::take_interrupt() {
  return std::exchange(parts_->interrupted_at, std::nullopt);
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
  const Mark busy(parts_->activity, Activity::stepping);
  Progress progress(parts_->talk);
  return parts_->simulation.relax(
      {tolerance, [&](double fraction, int iterations) {
         if (progress.due(fraction))
           progress.show(fraction,
                         fmt::format("coming to rest  iteration {}", grouped(iterations)));
       }});
}

QuasistaticResult Run::load_slowly(double duration, int increments, double tolerance) {
  check_open("quasistatic");
  check_arrived("quasistatic");
  parts_->outputs.check_room(parts_->simulation, duration, increments + 1LL);
  if (parts_->rehearsing) {
    parts_->load_slowly(duration, increments);
    return {};
  }
  parts_->outputs.reserve();
  std::vector<Observer*> observers = parts_->outputs.observers();
  std::deque<Watched> watched;
  for (const auto& watcher : parts_->watchers)
    observers.push_back(&watched.emplace_back(watcher, parts_->activity));
  const Mark busy(parts_->activity, Activity::stepping);
  Progress progress(parts_->talk);
  const auto show = [&](double fraction, int increment, int pass, std::int64_t broken) {
    if (progress.due(fraction))
      progress.show(fraction, fmt::format("increment {} of {}  pass {}  {} bonds broken", increment,
                                          increments, pass, grouped(broken)));
  };
  return parts_->simulation.load_slowly({duration, increments, tolerance, show}, observers);
}

void Run::close() {
  parts_->refuse_while_running();
  stop();
  judge();
  parts_->watchers.clear();  // whose functions may hold on to this run
  parts_->outputs.close();
}

void Run::judge() {
  const Simulation& simulation = parts_->simulation;
  if (parts_->rehearsing) return;
  const std::array<double, 3> now = parts_->situation();
  if (std::exchange(parts_->judged, now) == now) return;
  if (const auto remark = ledger_remark(simulation, energy(simulation), parts_->acts_at_once))
    parts_->say({*remark});
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
  const Simulation& simulation = parts_->simulation;
  Summary summary;
  summary.script = parts_->origin.script_name;
  summary.nodes = static_cast<std::int64_t>(simulation.lattice().grid.nodes());
  summary.bonds = simulation.lattice().initial_bonds();
  summary.steps = simulation.state().step;
  summary.time = simulation.time();
  summary.dt = simulation.dt();
  summary.dt_limit = simulation.lattice().step_limit;
  summary.precision = name_of(simulation.state().precision());
  summary.paths = simulation.path_counts();
  summary.threads = simulation.threads();
  summary.stages = stages(simulation);
  summary.features = kernel_features(simulation);
  summary.energy = energy(simulation);
  summary.damage = count_damage(simulation);
  summary.peak_rss = peak_resident_memory();
  summary.hash = simulation.state().hash();
  summary.files = parts_->pictures;
  summary.notes = parts_->notes;
  summary.wall.setup = parts_->setup_seconds;
  summary.wall.solve = simulation.solve_seconds();
  summary.wall.render = parts_->frame_render_seconds;
  summary.wall.store = parts_->frame_store_seconds;
  parts_->outputs.add_to(summary);
  summary.wall.total = parts_->life.seconds();
  return summary;
}

std::string Run::report() const {
  return hackle::report(parts_->simulation, summary());
}

}  // namespace hackle
