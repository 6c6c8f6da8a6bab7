// SPDX-License-Identifier: MIT
// Run files are read back with the plain HDF5 library.
#include "store/run_file.hpp"

#include <array>
#include <cmath>
#include <csignal>
#include <regex>
#include <vector>

#include <gmock/gmock.h>
#include <hdf5.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "measure/field.hpp"
#include "store/xdmf.hpp"
#include "support/folder.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using test::fresh_folder;

Simulation moving_plate() {
  Plate plate = test::bare_plate(30, 20);
  plate.cracks.push_back({{0.0, 0.005}, {0.005, 0.005}, Born::broken});
  plate.tractions.push_back({Edge::top, {1e6, 5e6}});
  return Simulation(plate, test::numerics(), {1});
}

// Reads a run file.
class Reader {
 public:
  explicit Reader(const fs::path& path)
      : file_(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT)) {}
  ~Reader() {
    if (file_ >= 0) H5Fclose(file_);
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  bool opens() const { return file_ >= 0; }

  std::vector<hsize_t> shape(const std::string& name) const {
    const hid_t dataset = H5Dopen2(file_, name.c_str(), H5P_DEFAULT);
    const hid_t space = H5Dget_space(dataset);
    std::vector<hsize_t> extents(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
    H5Sget_simple_extent_dims(space, extents.data(), nullptr);
    H5Sclose(space);
    H5Dclose(dataset);
    return extents;
  }

  std::vector<double> numbers(const std::string& name) const {
    std::size_t count = 1;
    for (const hsize_t extent : shape(name)) count *= extent;
    std::vector<double> values(count);
    const hid_t dataset = H5Dopen2(file_, name.c_str(), H5P_DEFAULT);
    H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Dclose(dataset);
    return values;
  }

  std::string text(const std::string& name) const {
    const hid_t dataset = H5Dopen2(file_, name.c_str(), H5P_DEFAULT);
    const hid_t type = H5Dget_type(dataset);
    std::string value(H5Tget_size(type), '\0');
    H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, value.data());
    H5Tclose(type);
    H5Dclose(dataset);
    return value;
  }

  std::string attribute(const std::string& object, const std::string& name) const {
    const hid_t attribute =
        H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
    const hid_t type = H5Aget_type(attribute);
    std::string value(H5Tget_size(type), '\0');
    H5Aread(attribute, type, value.data());
    H5Tclose(type);
    H5Aclose(attribute);
    return value;
  }

  long long committed() const {
    const hid_t attribute = H5Aopen(file_, "records_committed", H5P_DEFAULT);
    long long value = -1;
    H5Aread(attribute, H5T_NATIVE_LLONG, &value);
    H5Aclose(attribute);
    return value;
  }

 private:
  hid_t file_;
};

TEST(RunFile, HoldsWhatWasSimulated) {
  const fs::path path = fresh_folder() / "a.h5";
  Simulation simulation = moving_plate();
  RunFile file(path, simulation, {"a.lua", "-- the script"});
  file.add(simulation);
  simulation.run(3e-6);
  file.add(simulation);
  file.finish();

  const Reader reader(path);
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

TEST(RunFile, DescribesItself) {
  const fs::path path = fresh_folder() / "a.h5";
  Simulation simulation = moving_plate();
  const std::string script = "-- " + std::string(200000, 'x');  // longer than an attribute may be
  RunFile file(path, simulation, {"a.lua", script});
  file.add(simulation);
  file.finish();
  const Reader reader(path);
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
  const Reader reader(path);
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

  const Reader reader(path);
  ASSERT_TRUE(reader.opens());
  ASSERT_GE(reader.committed(), 8);
  for (long long record = 0; record < reader.committed(); ++record) {
    const std::string velocity = record_group(static_cast<std::size_t>(record)) + "/velocity";
    for (const double value : reader.numbers(velocity)) ASSERT_TRUE(std::isfinite(value));
  }
  EXPECT_THAT(read_text(fs::path(path).replace_extension(".xdmf")), testing::EndsWith("</Xdmf>\n"));
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
