// SPDX-License-Identifier: MIT
// States of stored runs in the files of other programs.
#include <sstream>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "measure/field_by_name.hpp"
#include "output/export/csv_file.hpp"
#include "output/export/vtk_file.hpp"
#include "output/export/vtkhdf_file.hpp"
#include "store/run_file.hpp"
#include "support/folder.hpp"
#include "support/run_file_reader.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

std::vector<std::string> lines_of(const fs::path& path) {
  std::vector<std::string> lines;
  std::istringstream text(read_text(path));
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

// A plate with a hole, with records at 0, 1, 2 and 3 us.
class Exports : public testing::Test {
 protected:
  Exports() {
    Plate plate = test::edge_crack(12e6);
    plate.cutouts.push_back({Ellipse{{0.08, 0.03}, {5e-3, 5e-3}}, ""});
    Simulation simulation(plate, test::numerics(2e-3, 6e-3), {1});
    RunFile file(path_, simulation, {"a.lua", ""});
    file.add(simulation);
    for (int k = 1; k <= 3; ++k) {
      simulation.run(1e-6);
      file.add(simulation);
    }
    file.finish();
    for (int j = 0; j < 20; ++j)
      for (int i = 0; i < 50; ++i) nodes_ += simulation.lattice().is_void(i, j) ? 0 : 1;
  }

  const test::Folder folder_;
  const fs::path path_ = folder_.path / "a.h5";
  std::size_t nodes_ = 0;
};

TEST_F(Exports, TakeTheLastStateUnlessTimesAreNamed) {
  const StoredRun run(path_);
  EXPECT_THAT(chosen(run, {}).states, ElementsAre(3));
  EXPECT_THAT(chosen(run, {.all_times = true}).states, ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(chosen(run, {.times = {2.1e-6, 0.0, 1.9e-6}}).states, ElementsAre(0, 2));
  EXPECT_THAT(chosen(run, {.every = 2e-6}).states, ElementsAre(0, 2));
  EXPECT_THAT(chosen(run, {.every = 1.0}).states, ElementsAre(0));
  EXPECT_THAT(chosen(run, {.every = 1e-30}).states, ElementsAre(0, 1, 2, 3));
  EXPECT_THROW(chosen(run, {.every = 0.0}), Error);
}

TEST_F(Exports, TakeStandardFieldsUnlessSomeAreNamed) {
  const StoredRun run(path_);
  EXPECT_THAT(chosen(run, {}).fields, ElementsAre("damage", "displacement", "velocity"));
  EXPECT_THAT(chosen(run, {.fields = {"stress_1", "damage", "stress_1"}}).fields,
              ElementsAre("stress_1", "damage"));
  try {
    chosen(run, {.fields = {"damge"}});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_THAT(error.what(), HasSubstr("did you mean 'damage'?"));
  }
}

TEST_F(Exports, EveryFieldOfTheCatalogueIsThere) {
  const StoredRun run(path_);
  for (const std::string_view name : field_names()) {
    const Field field = field_by_name(run.view(), name);
    EXPECT_EQ(field.values.size(), 1000U * static_cast<std::size_t>(field.components)) << name;
  }
}

TEST_F(Exports, CsvHasARowPerNodeAndTimeWithUnitsInItsHead) {
  StoredRun run(path_);
  const fs::path path = folder_.path / "a.csv";
  write_csv(run, chosen(run, {.times = {1e-6, 3e-6}}), path);
  const std::vector<std::string> lines = lines_of(path);
  ASSERT_EQ(lines.size(), 1 + 2 * nodes_);
  EXPECT_EQ(lines[0],
            "time (s),x (m),y (m),damage,displacement_x (m),displacement_y (m),velocity_x "
            "(m/s),velocity_y (m/s)");
  // The numbers of the last node are those of the recording.
  run.show(3);
  const Field moved = displacement(run.view());
  const Field damaged = damage(run.view());
  const std::vector<Vec2> velocities = run.view().velocities();
  const std::string row =
      fmt::format("{:.12g},{:.12g},{:.12g},{},{},{},{},{}", run.times()[3],
                  run.view().lattice().grid.position(49, 19).x(),
                  run.view().lattice().grid.position(49, 19).y(), damaged.values[999],
                  moved.values[1998], moved.values[1999], static_cast<float>(velocities[999].x()),
                  static_cast<float>(velocities[999].y()));
  EXPECT_EQ(lines.back(), row);
  EXPECT_THAT(lines[1], StartsWith(fmt::format("{:.12g},", run.times()[1])));
}

TEST_F(Exports, VtkIsOneFilePerTime) {
  StoredRun run(path_);
  const fs::path path = folder_.path / "a.vtk";
  EXPECT_THAT(write_vtk(run, chosen(run, {}), path), ElementsAre(path));
  EXPECT_THAT(write_vtk(run, chosen(run, {.times = {0.0, 3e-6}}), path),
              ElementsAre(folder_.path / "a_0000.vtk", folder_.path / "a_0001.vtk"));
  EXPECT_EQ(read_text(path), read_text(folder_.path / "a_0001.vtk"));
  const std::vector<std::string> lines = lines_of(path);
  EXPECT_THAT(lines, testing::Contains(fmt::format("POINTS {} double", nodes_)));
  EXPECT_THAT(lines, testing::Contains(fmt::format("VERTICES {} {}", nodes_, 2 * nodes_)));
  EXPECT_THAT(lines, testing::Contains(fmt::format("POINT_DATA {}", nodes_)));
  EXPECT_THAT(lines, testing::Contains("SCALARS damage float 1"));
  EXPECT_THAT(lines, testing::Contains("VECTORS velocity float"));
  // 7 lines before the points, 3 heads of fields, one of them with a line of its table.
  EXPECT_EQ(lines.size(), 7 + 1 + nodes_ + 1 + nodes_ + 1 + 4 + 3 * nodes_);
}

// As the specification has it: all offsets of what does not change are 0, those of fields grow.
TEST_F(Exports, VtkHdfSharesItsPointsAmongAllTimes) {
  StoredRun run(path_);
  const fs::path path = folder_.path / "a.vtkhdf";
  write_vtkhdf(run, chosen(run, {.all_times = true}), path);
  const test::RunFileReader file(path);
  ASSERT_TRUE(file.opens());
  EXPECT_EQ(file.attribute("VTKHDF", "Type"), "UnstructuredGrid");
  const auto count = static_cast<double>(nodes_);
  for (const char* name : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"})
    EXPECT_THAT(file.numbers(fmt::format("VTKHDF/{}", name)), ElementsAre(count)) << name;
  EXPECT_THAT(file.shape("VTKHDF/Points"), ElementsAre(nodes_, 3));
  EXPECT_THAT(file.shape("VTKHDF/Offsets"), ElementsAre(nodes_ + 1));
  EXPECT_THAT(file.numbers("VTKHDF/Types"), testing::Each(1.0));
  EXPECT_EQ(file.numbers("VTKHDF/Connectivity").back(), count - 1.0);
  EXPECT_EQ(file.numbers("VTKHDF/Steps/Values"), run.times());
  for (const char* name : {"PartOffsets", "PointOffsets", "CellOffsets", "ConnectivityIdOffsets"})
    EXPECT_THAT(file.numbers(fmt::format("VTKHDF/Steps/{}", name)), ElementsAre(0, 0, 0, 0))
        << name;
  EXPECT_THAT(file.shape("VTKHDF/Steps/CellOffsets"), ElementsAre(4, 1));
  EXPECT_THAT(file.numbers("VTKHDF/Steps/NumberOfParts"), ElementsAre(1, 1, 1, 1));
  EXPECT_THAT(file.numbers("VTKHDF/Steps/PointDataOffsets/velocity"),
              ElementsAre(0.0, count, 2 * count, 3 * count));
  ASSERT_THAT(file.shape("VTKHDF/PointData/displacement"), ElementsAre(4 * nodes_, 3));
  run.show(2);
  const Vec2 moved = run.view().displacement(49, 19);
  const std::vector<double> values = file.numbers("VTKHDF/PointData/displacement");
  EXPECT_EQ(values[3 * (3 * nodes_ - 1) + 1], static_cast<double>(static_cast<float>(moved.y())));
}

TEST_F(Exports, VtkHdfOfOneTimeHasNoSteps) {
  StoredRun run(path_);
  const fs::path path = folder_.path / "a.vtkhdf";
  write_vtkhdf(run, chosen(run, {.fields = {"stress_1"}}), path);
  const test::RunFileReader file(path);
  EXPECT_FALSE(file.holds("VTKHDF/Steps"));
  EXPECT_THAT(file.shape("VTKHDF/PointData/stress_1"), ElementsAre(nodes_));
}

TEST_F(Exports, AFolderThatIsNotThereIsAnErrorOfFiles) {
  StoredRun run(path_);
  for (const auto& write : {write_csv, write_vtkhdf}) {
    try {
      write(run, chosen(run, {}), folder_.path / "none" / "a.csv", [](double) {});
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::files);
    }
  }
}

}  // namespace
}  // namespace hackle
