// SPDX-License-Identifier: MIT
#include "render/diagram/diagram_file.hpp"

#include <limits>
#include <string>

#include <gmock/gmock.h>

#include "base/files.hpp"
#include "render/png_reader.hpp"
#include "support/folder.hpp"

namespace hackle {
namespace {

const double nothing = std::numeric_limits<double>::quiet_NaN();

Diagram two_energies() {
  return {"",
          {"time", "s"},
          {"energy", "J/m"},
          {{"strain", {{0, 1}, {1e-6, 2.5}}}, {"kinetic", {{0, nothing}, {1e-6, 4}}}},
          {}};
}

TEST(DiagramFile, CurvesThatShareTheirXShareItsColumn) {
  EXPECT_EQ(csv_of(two_energies()), "time_s,strain_J_per_m,kinetic_J_per_m\n0,1,\n1e-06,2.5,4\n");
}

TEST(DiagramFile, OthersHaveTheirOwn) {
  Diagram diagram = two_energies();
  diagram.curves[1].points = {{5e-7, 3}};
  EXPECT_EQ(csv_of(diagram),
            "time_s,strain_J_per_m,time_s_2,kinetic_J_per_m\n0,1,5e-07,3\n1e-06,2.5,,\n");
}

TEST(DiagramFile, HeadingsAreIdentifiersThatDiffer) {
  Diagram diagram = two_energies();
  diagram.curves[0].name = "1 m/s, grip";
  diagram.curves[1].name = "1 m/s  grip";
  EXPECT_EQ(csv_of(diagram).substr(0, csv_of(diagram).find('\n')),
            "time_s,_1_m_s_grip_J_per_m,_1_m_s_grip_J_per_m_2");
  diagram.curves.resize(1);
  diagram.curves[0].name.clear();
  EXPECT_EQ(csv_of(diagram).substr(0, csv_of(diagram).find('\n')), "time_s,energy_J_per_m");
}

TEST(DiagramFile, EndingsDecide) {
  const test::Folder folder;
  const DiagramStyle style{{640, 400, 12.0}};
  for (const char* name : {"a.png", "a.pdf", "a.svg"})
    write_diagram(two_energies(), style, folder.path / name);
  const PictureSize size = size_of_png(folder.path / "a.png");
  EXPECT_EQ(size.width, 640);
  EXPECT_EQ(size.height, 400);
  EXPECT_EQ(read_text(folder.path / "a.pdf").substr(0, 5), "%PDF-");
  EXPECT_THAT(read_text(folder.path / "a.svg"), testing::HasSubstr("<svg"));
}

TEST(DiagramFile, TheSameDiagramIsTheSameFile) {
  const test::Folder folder;
  for (const char* name : {"a.pdf", "b.pdf"}) write_diagram(two_energies(), {}, folder.path / name);
  EXPECT_EQ(read_text(folder.path / "a.pdf"), read_text(folder.path / "b.pdf"));
}

}  // namespace
}  // namespace hackle
