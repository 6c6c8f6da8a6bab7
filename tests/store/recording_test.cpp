// SPDX-License-Identifier: MIT
#include "store/recording.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>

#include <gmock/gmock.h>
#include <hdf5.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "measure/scalar.hpp"
#include "store/lattice_hash.hpp"
#include "store/run_file.hpp"
#include "support/composite.hpp"
#include "support/folder.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// A scene with everything that pictures can show.
struct Scene {
  const char* name;
  Plate plate;
  Numerics numerics;
};

Scene cracked() {
  return {"cracked", test::edge_crack(24e6), test::numerics(1e-3, 4e-3)};
}

Scene mixed() {
  Plate plate = test::composite(60, 40, {.mixed = true, .heated = true, .alpha = 0.2});
  plate.loads.tractions.push_back({Edge::top, {1e6, 20e6}});
  plate.cracks.push_back({{{0.0, 0.005}, {0.004, 0.006}, {0.006, 0.005}}, Born::absent});
  return {"mixed", plate, test::numerics(0.5e-3, 1.5e-3)};
}

Scene hit() {
  Plate plate = test::bare_plate(40, 20);
  plate.loads.impactors.push_back({{-4e-3, 0.005}, 4e-3, {80.0, -10.0}, 0.5});
  plate.loads.rollers.push_back({{0.01, 0.013}, 3e-3, {Guide::velocity, {1.0, -2.0}}});
  plate.loads.platens.push_back({{0.01, -2e-3}, {0.02, 0.0}, {Guide::force, {0.0, 1e5}}});
  plate.no_fail.push_back(rectangle({0.0, 0.0}, {0.002, 0.01}));
  return {"hit", plate, test::numerics()};
}

Scene scattered() {
  Plate plate = test::bare_plate(40, 30);
  plate.plane = Plane::strain;
  plate.scatter = Scatter{Scatter::Kind::weibull, 12.0, 1e-3, 7};
  plate.loads.tractions.push_back({Edge::top, {0.0, 60e6}});
  plate.cutouts.push_back({Capsule{{{0.005, 0.005}, {0.008, 0.007}}, 0.001}, ""});
  plate.cutouts.push_back(
      {Bitmap{{0.01, 0.01}, {0.014, 0.013}, 4, 3, {0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1, 0}}, ""});
  Numerics numerics = test::numerics(0.5e-3, 3e-3);
  numerics.quadrature = Quadrature::area;
  numerics.surface = Surface::energy;
  numerics.micromodulus = Micromodulus::conical;
  numerics.precision = Precision::f32;
  return {"scattered", plate, numerics};
}

// Returns the values of all picture fields.
std::vector<std::vector<float>> fields_of(const View& view) {
  std::vector<std::vector<float>> list;
  for (const Scalar& scalar : scalars())
    list.push_back(scalar.name == fringes_name ? std::vector<float>() : scalar.values(view));
  return list;
}

// Displacements are stored with a relative error of 2^-24, which enters the stretch of a bond of
// one spacing twice; so are thermal strains. A stretch error causes a stress error of at most E/(1
// - nu) < 2 E times as much.
double stretch_error(const Simulation& simulation) {
  double max = 0.0, heat = 0.0;
  for (const float u : displacement(simulation).values)
    max = std::max(max, std::abs(static_cast<double>(u)));
  for (const double strain : simulation.thermal_strain()) heat = std::max(heat, std::abs(strain));
  return std::ldexp(2.0 * max / simulation.lattice().grid.dx + 2.0 * heat, -24);
}

double stiffest(const Simulation& simulation) {
  double max = 0.0;
  for (const MaterialOnLattice& known : simulation.lattice().materials)
    max = std::max(max, known.material.E);
  return max;
}

// Returns the tolerance of a field beyond the rounding of its own values.
double tolerance_of(std::string_view field, const Simulation& simulation) {
  const double strain = stretch_error(simulation);
  if (field.starts_with("stress") || field == "von_mises" || field == "shear")
    return 4.0 * stiffest(simulation) * strain;
  if (field == "stretch") return 2.0 * strain / (0.1 * simulation.lattice().min_stretch());
  return 0.0;
}

// Error of a density E s^2/2 that is at most `peak`: E s ds.
double energy_error(double peak, const Simulation& simulation) {
  const double E = stiffest(simulation);
  double min = E;
  for (const MaterialOnLattice& known : simulation.lattice().materials)
    min = std::min(min, known.material.E);
  return 4.0 * E * std::sqrt(2.0 * peak / min) * stretch_error(simulation);
}

void expect_same(const std::vector<std::vector<float>>& found,
                 const std::vector<std::vector<float>>& wanted, const Simulation& simulation) {
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const std::string_view name = scalar_names[k];
    ASSERT_EQ(found[k].size(), wanted[k].size());
    const double max = name == "energy_density"
                           ? energy_error(*std::ranges::max_element(wanted[k]), simulation)
                           : tolerance_of(name, simulation);
    for (std::size_t node = 0; node < wanted[k].size(); ++node) {
      const double value = wanted[k][node];
      const double off = max + 2e-7 * std::abs(value);
      ASSERT_NEAR(found[k][node], value, off) << name << " of node " << node;
    }
  }
}

class EveryScene : public testing::TestWithParam<Scene (*)()> {};

TEST_P(EveryScene, ComesBackAsItWas) {
  const Scene scene = GetParam()();
  const test::Folder folder;
  Simulation simulation(scene.plate, scene.numerics, {1});
  std::vector<std::vector<std::vector<float>>> wanted;
  std::vector<double> times;
  std::vector<Circle> discs;
  {
    RunFile file(folder.path / "a.h5", simulation, {"a.lua", "-- the script"});
    for (int k = 0; k < 4; ++k) {
      file.add(simulation);
      wanted.push_back(fields_of(simulation));
      times.push_back(simulation.time());
      if (k < 3) simulation.run(6e-6);
    }
    discs = round_bodies(simulation);
    file.finish();
  }
  Recording recording(folder.path / "a.h5");
  EXPECT_EQ(recording.times(), times);
  EXPECT_EQ(recording.origin().script_name, "a.lua");
  EXPECT_EQ(recording.origin().script_text, "-- the script");
  for (const std::size_t k : {3U, 0U, 2U, 1U, 3U}) {  // in any order
    recording.go_to(k);
    EXPECT_EQ(recording.shown(), k);
    EXPECT_EQ(recording.view().time(), times[k]);
    expect_same(fields_of(recording.view()), wanted[k], simulation);
  }
  EXPECT_EQ(recording.view().state().bonds, simulation.state().bonds);
  const std::vector<Circle> found = round_bodies(recording.view());
  ASSERT_EQ(found.size(), discs.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_LT((found[k].centre - discs[k].centre).norm(), 1e-15);
    EXPECT_EQ(found[k].radius, discs[k].radius);
  }
  const std::vector<Box> shown = platens(recording.view()), last = platens(simulation);
  ASSERT_EQ(shown.size(), last.size());
  for (std::size_t k = 0; k < shown.size(); ++k) {
    EXPECT_LT((shown[k].min - last[k].min).norm(), 1e-15);
    EXPECT_LT((shown[k].max - last[k].max).norm(), 1e-15);
  }
  EXPECT_GT(*std::ranges::max_element(wanted[3][1]), 0.0F) << "nothing moves";
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryScene, testing::Values(cracked, mixed, hit, scattered),
                         [](const auto& given) { return given.param().name; });

// Four records of a small plate, 1 us apart.
fs::path small_file(const fs::path& folder) {
  Simulation simulation(test::edge_crack(24e6), test::numerics(2e-3, 6e-3), {1});
  RunFile file(folder / "small.h5", simulation, {"a.lua", ""});
  for (int k = 0; k < 4; ++k) {
    file.add(simulation);
    simulation.run(1e-6);
  }
  file.finish();
  return folder / "small.h5";
}

TEST(Recording, FindsTheRecordNearestInTime) {
  const test::Folder folder;
  const Recording recording(small_file(folder.path));
  const std::vector<double>& times = recording.times();
  ASSERT_EQ(times.size(), 4U);
  EXPECT_EQ(recording.nearest(-1.0), 0U);
  EXPECT_EQ(recording.nearest(1.0), 3U);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(recording.nearest(times[k]), k);
  EXPECT_EQ(recording.nearest(0.6 * times[1] + 0.4 * times[2]), 1U);
  EXPECT_EQ(recording.nearest(0.4 * times[1] + 0.6 * times[2]), 2U);
}

TEST(Recording, StaysWholeWhileItsFileIsWrittenAnew) {
  const test::Folder folder;
  Recording recording(small_file(folder.path));
  const std::vector<float> before = displacement(recording.view()).values;
  Simulation other(test::bare_plate(20, 10), test::numerics(), {1});
  RunFile file(folder.path / "small.h5", other, {});
  file.add(other);
  file.finish();
  recording.go_to(3);
  recording.go_to(0);
  EXPECT_EQ(displacement(recording.view()).values, before);
  EXPECT_EQ(Recording(folder.path / "small.h5").times().size(), 1U);
}

// Returns the error of opening the file and showing every record, "" if there is none.
std::string complaint(const fs::path& path) {
  try {
    Recording recording(path);
    for (std::size_t k = 0; k < recording.times().size(); ++k) recording.go_to(k);
    return "";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::files);
    return error.what();
  }
}

TEST(Recording, RefusesWhatIsNoRunFile) {
  const test::Folder folder;
  EXPECT_THAT(complaint(folder.path / "none.h5"), HasSubstr("there is no such file"));
  EXPECT_THAT(complaint(folder.path), HasSubstr("it is a folder"));
  for (const std::size_t size : {0U, 10U, 5000U}) {
    std::mt19937 random(7);
    std::string bytes(size, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random());
    write_text(folder.path / "noise.h5", bytes);
    EXPECT_THAT(complaint(folder.path / "noise.h5"), HasSubstr("cannot read")) << size;
  }
  const fs::path other = folder.path / "other.h5";
  H5Fclose(H5Fcreate(other.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  EXPECT_THAT(complaint(other), HasSubstr("it is no run file of Hackle"));
}

TEST(Recording, RefusesAFileThatWasCutOff) {
  const test::Folder folder;
  const std::string whole = read_text(small_file(folder.path));
  const fs::path cut = folder.path / "cut.h5";
  for (int part = 1; part < 16; ++part) {
    write_text(cut, whole.substr(0, whole.size() * static_cast<std::size_t>(part) / 16));
    EXPECT_THAT(complaint(cut), HasSubstr("cannot read '" + cut.string() + "': ")) << part;
  }
}

// Returns the position of the first chunk of a dataset in the file.
std::streamoff place_of(const fs::path& path, const char* name) {
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t dataset = H5Dopen2(file, name, H5P_DEFAULT);
  const hid_t space = H5Dget_space(dataset);
  haddr_t place = 0;
  H5Dget_chunk_info(dataset, space, 0, nullptr, nullptr, &place, nullptr);
  H5Sclose(space);
  H5Dclose(dataset);
  H5Fclose(file);
  return static_cast<std::streamoff>(place);
}

TEST(Recording, NoticesAByteThatHasChanged) {
  const test::Folder folder;
  const fs::path path = small_file(folder.path);
  const std::string whole = read_text(path);
  for (const char* field : {"displacement", "velocity", "broken"}) {
    const std::string name = std::string("records/0/00002/") + field;
    std::string changed = whole;
    char& byte = changed.at(static_cast<std::size_t>(place_of(path, name.c_str())) + 12);
    byte = static_cast<char>(byte ^ 4);
    write_text(folder.path / "changed.h5", changed);
    EXPECT_THAT(complaint(folder.path / "changed.h5"), HasSubstr("its " + name + " is damaged"));
  }
}

// Modifies a copy of the small file.
class Damaged {
 public:
  explicit Damaged(const fs::path& folder) : path_(small_file(folder)) {}

  template <class Change>
  std::string by(const Change& change) const {
    const fs::path copy = fs::path(path_).replace_filename("damaged.h5");
    fs::copy_file(path_, copy, fs::copy_options::overwrite_existing);
    const hid_t file = H5Fopen(copy.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    change(file);
    H5Fclose(file);
    return complaint(copy);
  }

 private:
  fs::path path_;
};

void set_number(hid_t file, const char* attribute, long long value) {
  const hid_t found = H5Aopen(file, attribute, H5P_DEFAULT);
  H5Awrite(found, H5T_NATIVE_LLONG, &value);
  H5Aclose(found);
}

// Replaces a dataset by numbers of another shape.
void put_instead(hid_t file, const char* name, std::vector<hsize_t> shape, hid_t type) {
  H5Ldelete(file, name, H5P_DEFAULT);
  const hid_t space = H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr);
  H5Dclose(H5Dcreate2(file, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  H5Sclose(space);
}

TEST(Recording, SaysWhatIsMissingOrDamaged) {
  const test::Folder folder;
  const Damaged damaged(folder.path);
  EXPECT_EQ(damaged.by([](hid_t) {}), "");
  EXPECT_THAT(
      damaged.by([](hid_t file) { set_number(file, "format_version", 1); }),
      HasSubstr("format 1, which lacks the bonds (run its script again to record it anew)"));
  EXPECT_THAT(damaged.by([](hid_t file) { set_number(file, "format_version", 99); }),
              HasSubstr("format 99, newer than"));
  EXPECT_THAT(damaged.by([](hid_t file) { set_number(file, "records_committed", 0); }),
              HasSubstr("it holds no record"));
  EXPECT_THAT(damaged.by([](hid_t file) { set_number(file, "records_committed", 9); }),
              HasSubstr("its time is 4, expected 9"));
  EXPECT_THAT(damaged.by([](hid_t file) { set_number(file, "records_committed", -9); }),
              HasSubstr("it says that it holds -9 records"));
  for (const char* name : {"inputs", "time", "step", "records/0/00002/displacement",
                           "records/0/00002/velocity", "records/0/00003/broken"}) {
    EXPECT_THAT(damaged.by([&](hid_t file) { H5Ldelete(file, name, H5P_DEFAULT); }),
                HasSubstr(std::string("its ") + name + " is missing"));
    EXPECT_THAT(damaged.by([&](hid_t file) {
      put_instead(file, name, {7, 5}, H5T_NATIVE_INT);
    }),
                HasSubstr(std::string("its ") + name));
  }
  EXPECT_THAT(damaged.by([](hid_t file) {
    put_instead(file, "records/0/00001/discs", {2, 4}, H5T_NATIVE_DOUBLE);
  }),
              HasSubstr("discs is 2 x 4, expected 0 x 5"));
}

// Replaces a part of the inputs, and pads them with spaces.
void change_inputs(hid_t file, const std::string& from, const std::string& to) {
  const hid_t dataset = H5Dopen2(file, "inputs", H5P_DEFAULT);
  const hid_t type = H5Dget_type(dataset);
  std::string text(H5Tget_size(type), '\0');
  H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data());
  const std::size_t size = text.size(), at = text.find(from);
  ASSERT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  text.resize(size, ' ');
  H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str());
  H5Tclose(type);
  H5Dclose(dataset);
}

TEST(Recording, RefusesInputsThatMakeNoSenseOrAnotherLattice) {
  const test::Folder folder;
  const Damaged damaged(folder.path);
  const auto with = [&](const char* from, const char* to) {
    return damaged.by([&](hid_t file) { change_inputs(file, from, to); });
  };
  EXPECT_THAT(with("\"width_m\": 0.1", "\"width_m\": -.1"), HasSubstr("inputs"));
  EXPECT_THAT(with("\"width_m\": 0.1", "\"width_m\": \"\" "), HasSubstr("inputs"));
  EXPECT_THAT(with("\"width_m\": 0.1", "\"width_m\":1e30"), HasSubstr("cannot read"));
  EXPECT_THAT(with("\"spacing_m\": 0.002", "\"spacing_m\": 2e-99"), HasSubstr("cannot read"));
  EXPECT_THAT(with("\"plane\": \"stress\"", "\"plane\": \"stres\""),
              HasSubstr("plane is none of stress, strain"));
  EXPECT_THAT(with("\"width_m\": 0.1", "\"width_m\": 0.2"),
              HasSubstr("its nodes is 1000 x 3, expected 2000 x 3"));
  EXPECT_THAT(with("\"micromodulus\": \"constant\"", "\"micromodulus\": \"conical\""),
              HasSubstr("its lattice cannot be built again"));
}

TEST(LatticeHash, TellsLatticesApart) {
  const auto hash_of = [](const Plate& plate) {
    return lattice_hash(Lattice(plate, test::numerics()));
  };
  const Plate bare = test::bare_plate(30, 20);
  Plate cut = bare, soft = bare, rough = bare;
  cut.cracks.push_back({{0.0, 0.005}, {0.005, 0.005}, Born::broken});
  soft.material.E *= 0.5;
  rough.scatter = Scatter{Scatter::Kind::weibull, 12.0, 1e-3, 7};
  EXPECT_EQ(hash_of(bare), hash_of(test::bare_plate(30, 20)));
  for (const Plate& other : {cut, soft, rough}) EXPECT_NE(hash_of(bare), hash_of(other));
}

}  // namespace
}  // namespace hackle
