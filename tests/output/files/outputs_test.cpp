// SPDX-License-Identifier: MIT
#include "output/files/outputs.hpp"

#include <functional>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "solver/simulation.hpp"
#include "support/folder.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

// An output that cannot complete its file.
class Hopeless : public Output {
 public:
  Hopeless(std::string name, const View& view)
      : Output(Schedule("hopeless", 1.0, view)), name_(std::move(name)) {}
  void look(const Simulation&) override {}
  Expected expected(double, std::int64_t max_looks) const override {
    return {name_, max_looks, 6e8};
  }
  void close() override { throw Error(ErrorKind::files, name_ + " is lost", "pray"); }
  std::vector<std::filesystem::path> files() const override { return {}; }
  void add_seconds(StageSeconds& wall) const override { wall.encode += 1.0; }

 private:
  std::string name_;
};

// A plate of which a view can be taken.
const Simulation& plate() {
  static const Simulation simulation(test::bare_plate(20, 20), test::numerics());
  return simulation;
}

std::string failure_of(const std::function<void()>& work) {
  try {
    work();
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

Outputs two(const test::Folder& folder) {
  Outputs outputs(1e9);
  outputs.add("movie", folder.path / "a", FileKind::movie,
              std::make_unique<Hopeless>("a", plate()));
  outputs.add("record", folder.path / "b", FileKind::run_file,
              std::make_unique<Hopeless>("b", plate()));
  return outputs;
}

TEST(Outputs, ClosingTellsOfEveryFileThatIsLost) {
  const test::Folder folder;
  Outputs outputs = two(folder);
  const std::string message = failure_of([&] { outputs.close(); });
  EXPECT_THAT(message, HasSubstr("a is lost"));
  EXPECT_THAT(message, HasSubstr("b is lost"));
  EXPECT_TRUE(outputs.closed());
}

TEST(Outputs, TogetherTheyMayNotTakeMoreThanTheLimit) {
  const test::Folder folder;
  Outputs outputs = two(folder);
  const Simulation simulation(test::bare_plate(20, 20), test::numerics());
  const auto check = [&] { outputs.check_room(simulation, 1e-6, 3); };
  EXPECT_THAT(failure_of(check), HasSubstr("'a' 600 MB in 3 pieces, 'b' 600 MB in 3 pieces"));
  outputs.limit(2e9);
  EXPECT_EQ(failure_of(check), "");
}

TEST(Outputs, OneFileIsWrittenByOneOfThem) {
  const test::Folder folder;
  Outputs outputs = two(folder);
  const auto add = [&] {
    outputs.add("movie", folder.path / "a", FileKind::movie,
                std::make_unique<Hopeless>("a", plate()));
  };
  EXPECT_THAT(failure_of(add), HasSubstr("already written by movie"));
}

TEST(Outputs, GoOnFromTheirOwnMarksOnly) {
  const test::Folder folder;
  Outputs outputs = two(folder);
  std::vector<OutputMark> marks = outputs.marks();
  ASSERT_EQ(marks.size(), 2U);
  EXPECT_EQ(marks[1].file, "b");
  const auto go_on = [&] { outputs.continue_from(marks); };
  // Neither can, and both say so.
  EXPECT_THAT(failure_of(go_on), HasSubstr("'a' cannot be continued"));
  EXPECT_THAT(failure_of(go_on), HasSubstr("'b' cannot be continued"));
  marks[0].file = folder.path / "elsewhere" / "a";
  EXPECT_THAT(failure_of(go_on), HasSubstr("/a' cannot be continued"));
  std::swap(marks[0], marks[1]);
  EXPECT_THAT(failure_of(go_on), HasSubstr("not those of the run"));
  marks.pop_back();
  EXPECT_THAT(failure_of(go_on), HasSubstr("not those of the run"));
}

TEST(Outputs, AddUpTheirTime) {
  const test::Folder folder;
  const Outputs outputs = two(folder);
  Summary summary;
  outputs.add_to(summary);
  EXPECT_EQ(summary.wall.encode, 2.0);
}

}  // namespace
}  // namespace hackle
