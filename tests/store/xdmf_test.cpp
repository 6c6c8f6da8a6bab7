// SPDX-License-Identifier: MIT
#include "store/xdmf.hpp"

#include <gmock/gmock.h>

namespace hackle {
namespace {

const Grid grid{4, 3, 0.5e-3, {1e-3, 0.75e-3}};

TEST(Xdmf, PlacesTheNodesAndNamesTheDatasets) {
  const std::string text = xdmf(grid, "/some/where/run.h5", {0.0, 1e-6});
  EXPECT_THAT(text, testing::HasSubstr("TopologyType=\"3DCoRectMesh\" Dimensions=\"1 3 4\""));
  EXPECT_THAT(text, testing::HasSubstr(">0 0.00025 0.00025<"));
  EXPECT_THAT(text, testing::HasSubstr("<Time Value=\"1e-06\"/>"));
  EXPECT_THAT(text, testing::HasSubstr(">run.h5:/records/0/00001/displacement<"));
  EXPECT_THAT(text, testing::Not(testing::HasSubstr("/some/where")));
}

TEST(RecordGroup, HoldsAThousandRecordsEach) {
  EXPECT_EQ(record_group(0), "records/0/00000");
  EXPECT_EQ(record_group(999), "records/0/00999");
  EXPECT_EQ(record_group(1000), "records/1/01000");
  EXPECT_EQ(record_group(123456), "records/123/123456");
}

TEST(Xdmf, HasOneGridARecord) {
  const std::string text = xdmf(grid, "run.h5", {0.0, 1e-6, 2e-6});
  std::size_t grids = 0;
  for (std::size_t at = text.find("GridType=\"Uniform\""); at != std::string::npos;
       at = text.find("GridType=\"Uniform\"", at + 1))
    ++grids;
  EXPECT_EQ(grids, 3U);
}

TEST(Xdmf, EscapesTheNameOfTheFile) {
  EXPECT_THAT(xdmf(grid, "a&b<c>.h5", {0.0}), testing::HasSubstr("a&amp;b&lt;c&gt;.h5:/records"));
}

// ParaView orders z, y, x.
TEST(Xdmf, SaysPlacesAndSizesInTheOrderOfParaView) {
  const Grid apart{4, 3, 0.25, {2.0, 1.0}};  // m; the first node at 1.625 and 0.75
  const std::string text = xdmf(apart, "run.h5", {0.0, 1e-6}, true);
  EXPECT_THAT(text, testing::HasSubstr(">0 0.75 1.625<"));
  EXPECT_THAT(text, testing::HasSubstr(">0.25 0.25 0.25<"));
  for (const char* part :
       {"Name=\"damage\" AttributeType=\"Scalar\"", "Dimensions=\"1 3 4\" NumberType=\"Float\"",
        "Name=\"displacement\" AttributeType=\"Vector\"",
        "Dimensions=\"1 3 4 3\" NumberType=\"Float\"", "Name=\"velocity\" AttributeType=\"Vector\"",
        ">run.h5:/records/0/00000/velocity<", "Name=\"material\" AttributeType=\"Scalar\"",
        "Dimensions=\"1 3 4\" NumberType=\"UChar\"", ">run.h5:/material<"})
    EXPECT_THAT(text, testing::HasSubstr(part));
  EXPECT_THAT(xdmf(apart, "run.h5", {0.0}), testing::Not(testing::HasSubstr("material")));
}

}  // namespace
}  // namespace hackle
