// SPDX-License-Identifier: MIT
// Reads run files back with the plain HDF5 library.
#include "store/run_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <regex>
#include <vector>

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "measure/field.hpp"
#include "store/xdmf.hpp"
#include "support/folder.hpp"
#include "support/run_file_reader.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using test::fresh_folder;
using test::RunFileReader;

Simulation moving_plate() {
  Plate plate = test::bare_plate(30, 20);
  plate.cracks.push_back({{0.0, 0.005}, {0.005, 0.005}, Born::broken});
  plate.loads.tractions.push_back({Edge::top, {1e6, 5e6}});
  return Simulation(plate, test::numerics(), {1});
}

TEST(RunFile, HoldsWhatWasSimulated) {
  const fs::path path = fresh_folder() / "a.h5";
  Simulation simulation = moving_plate();
  RunFile file(path, simulation, {"a.lua", "-- the script"});
  file.add(simulation);
  simulation.run(3e-6);
  file.add(simulation);
  file.finish();

  const RunFileReader reader(path);
  ASSERT_TRUE(reader.opens());
  EXPECT_EQ(reader.committed(), 2);
  EXPECT_EQ(reader.numbers("time"), (std::vector<double>{0.0, simulation.time()}));
  EXPECT_EQ(reader.numbers("step")[1], static_cast<double>(simulation.state().step));
  EXPECT_EQ(reader.shape("nodes"), (std::vector<hsize_t>{600, 3}));
  EXPECT_DOUBLE_EQ(reader.numbers("nodes")[3], simulation.lattice().grid.position(1, 0).x());
  const Field u = displacement(simulation), phi = damage(simulation);
  const std::vector<double> stored = reader.numbers("records/0/00001/displacement");
  const std::vector<double> stored_phi = reader.numbers("records/0/00001/damage");
  ASSERT_EQ(stored.size(), 1800U);
  for (std::size_t node = 0; node < 600; ++node) {
    EXPECT_EQ(stored[3 * node], u.values[2 * node]);
    EXPECT_EQ(stored[3 * node + 1], u.values[2 * node + 1]);
    EXPECT_EQ(stored[3 * node + 2], 0.0);
    EXPECT_EQ(stored_phi[node], phi.values[node]);
  }
}

TEST(RunFile, NamesTheMaterialOfEveryNodeWhereTheyDiffer) {
  Plate plate = test::bare_plate(30, 20);
  Material soft = test::duran50();
  soft.E *= 0.5;
  plate.inclusions.push_back({rectangle({1e-3, 1e-3}, {3e-3, 3e-3}), soft});
  plate.cutouts.push_back({rectangle({8e-3, 2e-3}, {10e-3, 4e-3}), ""});
  const fs::path path = fresh_folder() / "a.h5";
  const Simulation simulation(plate, test::numerics(), {1});
  RunFile file(path, simulation, {"a.lua", ""});
  file.add(simulation);
  file.finish();
  const std::vector<double> material = RunFileReader(path).numbers("material");
  ASSERT_EQ(material.size(), 600U);
  for (std::size_t node = 0; node < 600; ++node)
    EXPECT_EQ(material[node], simulation.lattice().material[node]);
  EXPECT_EQ(std::ranges::count(material, 1.0), 16);
  EXPECT_EQ(std::ranges::count(material, 255.0), 16);

  const fs::path plain = fresh_folder() / "b.h5";
  const Simulation same = moving_plate();
  RunFile(plain, same, {"b.lua", ""}).finish();
  EXPECT_TRUE(RunFileReader(plain).numbers("material").empty());
}

TEST(RunFile, DescribesItself) {
  const fs::path path = fresh_folder() / "a.h5";
  Simulation simulation = moving_plate();
  const std::string script = "-- " + std::string(200000, 'x');  // longer than an attribute can be
  RunFile file(path, simulation, {"a.lua", script});
  file.add(simulation);
  file.finish();
  const RunFileReader reader(path);
  EXPECT_EQ(reader.text("script"), script);
  EXPECT_THAT(reader.text("inputs"), testing::HasSubstr("\"E_Pa\": 65000000000.0"));
  EXPECT_EQ(reader.attribute("/", "software"), "Hackle");
  EXPECT_EQ(reader.attribute("/", "script_name"), "a.lua");
  EXPECT_THAT(reader.attribute("/", "created"), testing::MatchesRegex("20..-..-..T..:..:..Z"));
  EXPECT_EQ(reader.attribute("nodes", "units"), "m");
  EXPECT_EQ(reader.attribute("time", "units"), "s");
  EXPECT_EQ(reader.attribute("records/0/00000/velocity", "units"), "m/s");
  EXPECT_FALSE(reader.attribute("records/0/00000/damage", "long_name").empty());
}

TEST(RunFile, ItsSidecarNamesDatasetsThatExistWithTheirShapes) {
  const fs::path path = fresh_folder() / "a.h5";
  Simulation simulation = moving_plate();
  RunFile file(path, simulation, {});
  for (int k = 0; k < 30; ++k) {
    file.add(simulation);
    simulation.step();
  }
  file.finish();
  EXPECT_EQ(file.sidecar(), fs::path(path).replace_extension(".xdmf"));
  const std::string text = read_text(file.sidecar());
  const RunFileReader reader(path);
  const std::regex time(R"re(<Time Value="([^"]*)"/>)re");
  std::vector<double> times;
  for (std::sregex_iterator it(text.begin(), text.end(), time), end; it != end; ++it)
    times.push_back(std::stod((*it)[1]));
  EXPECT_EQ(times, reader.numbers("time"));
  const std::regex item(R"re(Dimensions="1 20 30( 3)?"[^>]*>a\.h5:(/records/[^<]*)<)re");
  int items = 0;
  for (std::sregex_iterator it(text.begin(), text.end(), item), end; it != end; ++it, ++items) {
    const bool vector = (*it)[1].matched;
    EXPECT_EQ(reader.shape((*it)[2]),
              vector ? (std::vector<hsize_t>{600, 3}) : (std::vector<hsize_t>{600}));
  }
  EXPECT_EQ(items, 90);
}

TEST(RunFile, AKilledRunLeavesAFileThatOpens) {
  const fs::path path = fresh_folder() / "a.h5";
  std::array<int, 2> pipe_ends{};
  ASSERT_EQ(pipe(pipe_ends.data()), 0);
  const pid_t child = fork();
  if (child == 0) {
    Simulation simulation = moving_plate();
    RunFile file(path, simulation, {});
    for (char count = 0;; ++count) {
      file.add(simulation);
      simulation.step();
      if (write(pipe_ends[1], &count, 1) != 1) _exit(1);
    }
  }
  for (char count = 0; count < 7;) ASSERT_EQ(read(pipe_ends[0], &count, 1), 1);
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  close(pipe_ends[0]);
  close(pipe_ends[1]);

  const RunFileReader reader(path);
  ASSERT_TRUE(reader.opens());
  ASSERT_GE(reader.committed(), 8);
  for (long long record = 0; record < reader.committed(); ++record) {
    const std::string velocity = record_group(static_cast<std::size_t>(record)) + "/velocity";
    for (const double value : reader.numbers(velocity)) ASSERT_TRUE(std::isfinite(value));
  }
  EXPECT_THAT(read_text(fs::path(path).replace_extension(".xdmf")), testing::EndsWith("</Xdmf>\n"));
}

TEST(RunFile, NothingButFiniteNumbersReachesIt) {
  const fs::path path = fresh_folder() / "a.h5";
  Simulation simulation = moving_plate();
  RunFile file(path, simulation, {});
  file.add(simulation);
  State state = simulation.state();
  state.set_v(7, 0, {0, 1e300});  // finite, but not as a float
  simulation.restore(state);
  try {
    file.add(simulation);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::run_failed);
    EXPECT_THAT(error.what(), testing::HasSubstr("the velocity is not a finite number"));
  }
  file.finish();
  EXPECT_EQ(RunFileReader(path).committed(), 1);
}

// HDF5 does not free the memory of a file that it could not close.
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libhdf5";
}

// Limits the size of files while it lives, like a disk that fills up.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) : former_handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &former_);
    const rlimit small{bytes, former_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk() {
    setrlimit(RLIMIT_FSIZE, &former_);
    std::signal(SIGXFSZ, former_handler_);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

 private:
  rlimit former_{};
  void (*former_handler_)(int);
};

TEST(RunFile, AFullDiskIsOneErrorAndKeepsWhatWasCommitted) {
  const fs::path path = fresh_folder() / "a.h5";
  Simulation simulation = moving_plate();
  long long added = 0;
  try {
    const SmallDisk disk(300000);  // room for some twenty records
    RunFile file(path, simulation, {});
    for (; added < 1000; ++added) {
      file.add(simulation);
      simulation.step();
    }
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::files);
    EXPECT_EQ(error.what(), "cannot write '" + path.string() + "': File too large");
  }
  const RunFileReader reader(path);
  ASSERT_TRUE(reader.opens());
  EXPECT_GT(added, 0);
  EXPECT_EQ(reader.committed(), added);
  for (long long record = 0; record < added; ++record)
    EXPECT_EQ(reader.numbers(record_group(static_cast<std::size_t>(record)) + "/velocity").size(),
              1800U);
}

TEST(RunFile, TheSidecarOfAnOlderRunDoesNotOutliveIt) {
  const fs::path path = fresh_folder() / "a.h5";
  const fs::path sidecar = fs::path(path).replace_extension(".xdmf");
  write_text(sidecar, "old");
  const RunFile file(path, moving_plate(), {});
  EXPECT_FALSE(fs::exists(sidecar));
}

TEST(RunFile, RefusesTheNameOfTheSidecar) {
  try {
    const RunFile file(fresh_folder() / "a.xdmf", moving_plate(), {});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::files);
    EXPECT_THAT(error.what(), testing::HasSubstr("end its name in .h5"));
  }
}

TEST(RunFile, AFolderThatIsNotThereIsAnErrorWithItsCause) {
  Simulation simulation = moving_plate();
  try {
    const RunFile file(fresh_folder() / "no" / "a.h5", simulation, {});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::files);
    EXPECT_THAT(error.what(), testing::HasSubstr("cannot create"));
    EXPECT_THAT(error.what(), testing::HasSubstr("No such file or directory"));
  }
}

}  // namespace
}  // namespace hackle
