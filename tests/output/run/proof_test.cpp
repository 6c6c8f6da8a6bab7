// SPDX-License-Identifier: MIT
// Runs are computed again from their files, as they are and with something changed in them.
#include "output/run/proof.hpp"

#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <hdf5.h>

#include "base/error.hpp"
#include "output/files/record_options.hpp"
#include "output/run/run.hpp"
#include "support/folder.hpp"
#include "support/scenes.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;
using ProvenRun = hackle::Run;

// A crack that grows, and a disc that flies.
Plate proven_plate() {
  Plate plate = test::bare_plate(40, 20);
  plate.cracks.push_back({{0.0, 0.005}, {0.008, 0.005}, Born::broken});
  plate.loads.tractions.push_back({Edge::top, {1e6, 30e6}});
  plate.loads.tractions.push_back({Edge::bottom, {0.0, -30e6}});
  plate.loads.impactors.push_back({{-4e-3, 0.005}, 3.6e-3, {80.0, 0.0}, 0.5});
  return plate;
}

// Pulls half as much.
Loads halved(Loads loads) {
  for (Traction& traction : loads.tractions)
    traction.stress = Vec2(0.5 * traction.stress.constant());
  return loads;
}

class ProofOf : public testing::Test {
 protected:
  // Records a run with everything that `act` does with it.
  void record(const std::function<void(ProvenRun&)>& act, RecordOptions options = {1e-6},
              Plate plate = proven_plate(), Numerics numerics = test::numerics()) {
    ProvenRun run(std::move(plate), numerics, {1}, Talk::quiet, {"a.lua", ""});
    run.record(file_, options);
    act(run);
    run.close();
    hash_ = run.simulation().state().hash();
  }
  void record_plainly() {
    record([](ProvenRun& run) { run.run(6e-6); });
  }
  Proof proof(const Execution& execution = {2}) const {
    return prove(file_, execution, Talk::quiet);
  }
  void expect_agreement() const {
    const Proof found = proof();
    EXPECT_EQ(found.compared, found.records);
    EXPECT_EQ(found.stopped, "");
    EXPECT_TRUE(found.has_hashes);
    EXPECT_FALSE(found.difference) << found.difference->quantity << found.difference->record;
  }

  // Changes the values of a dataset in the file.
  template <class Number>
  void change(const char* name, hid_t type, const std::function<void(std::vector<Number>&)>& how) {
    const hid_t file = H5Fopen(file_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    const hid_t dataset = H5Dopen2(file, name, H5P_DEFAULT), space = H5Dget_space(dataset);
    std::vector<Number> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    how(values);
    H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Sclose(space);
    H5Dclose(dataset);
    H5Fclose(file);
  }

  const test::Folder folder_;
  const std::filesystem::path file_ = folder_.path / "a.h5";
  std::string hash_;
};

TEST_F(ProofOf, APlainRunHoldsWithAnyThreadsAndInstructions) {
  record_plainly();
  for (const InstructionSet set : {InstructionSet::baseline, best_instruction_set()})
    for (const int threads : {1, 3}) {
      const Proof found = proof({threads, set});
      EXPECT_EQ(found.records, 7U);
      EXPECT_EQ(found.compared, 7U);
      EXPECT_FALSE(found.difference);
    }
}

TEST_F(ProofOf, ABitOfABondThatWasChangedIsNamed) {
  record_plainly();
  const int words = Family(4.0, Quadrature::full).words();
  const std::size_t node = 7 * 40 + 30;
  change<std::uint32_t>("records/0/00004/broken", H5T_NATIVE_UINT32,
                        [&](auto& bits) { bits[node * static_cast<std::size_t>(words)] ^= 1U; });
  const Proof found = proof();
  ASSERT_TRUE(found.difference);
  EXPECT_EQ(found.compared, 5U);
  EXPECT_EQ(found.difference->record, 4U);
  EXPECT_EQ(found.difference->quantity, "broken");
  EXPECT_EQ(*found.difference->node, Vec2(30, 7));
  EXPECT_NEAR(found.difference->place.x(), 30.5 * 0.5e-3, 1e-12);
  EXPECT_THAT(found.difference->detail, HasSubstr("bond to the node"));
  EXPECT_EQ(found.difference->recorded, "broken");
  EXPECT_EQ(found.difference->computed, "intact");
  EXPECT_TRUE(found.exact_hash);
}

TEST_F(ProofOf, AChangedVelocityIsNamedWithItsComponent) {
  record_plainly();
  change<float>("records/0/00002/velocity", H5T_NATIVE_FLOAT, [](auto& values) {
    float& value = values[3 * 123 + 1];
    value = std::nextafter(value, 1e9F);
  });
  const Proof found = proof();
  ASSERT_TRUE(found.difference);
  EXPECT_EQ(found.difference->record, 2U);
  EXPECT_EQ(found.difference->quantity, "velocity");
  EXPECT_EQ(found.difference->detail, "along y");
  EXPECT_EQ(*found.difference->node, Vec2(3, 3));
}

hid_t hash_type() {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, 16);
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  return type;
}

TEST_F(ProofOf, AnotherHashIsToldFromAnotherField) {
  record_plainly();
  const hid_t type = hash_type();
  change<std::array<char, 16>>(
      "state_hash", type, [](auto& hashes) { hashes[3][0] = hashes[3][0] == '0' ? '1' : '0'; });
  H5Tclose(type);
  const Proof found = proof();
  ASSERT_TRUE(found.difference);
  EXPECT_EQ(found.difference->record, 3U);
  EXPECT_EQ(found.difference->quantity, "state_hash");
  EXPECT_FALSE(found.difference->node);
  EXPECT_FALSE(found.exact_hash);
}

TEST_F(ProofOf, TheLastRecordHasTheHashOfTheRun) {
  record_plainly();
  const hid_t type = hash_type();
  std::string last;
  change<std::array<char, 16>>("state_hash", type,
                               [&](auto& hashes) { last.assign(hashes.at(6).data(), 16); });
  H5Tclose(type);
  EXPECT_EQ(last, hash_);
}

TEST_F(ProofOf, ExchangedLoadsAreDoneAgain) {
  record([](ProvenRun& run) {
    run.run(2.3e-6);
    run.set_loads(halved(run.simulation().plate().loads));
    run.step(3);
    run.set_loads(halved(run.simulation().plate().loads));
    run.run(3e-6);
  });
  expect_agreement();
}

// Halves the loads after some steps.
class Meddler : public Observer {
 public:
  Meddler(ProvenRun& run, std::int64_t step) : run_(run), step_(step) {}
  bool due(const Simulation& simulation) override { return simulation.state().step == step_; }
  void observe(const Simulation& simulation) override {
    run_.set_loads(halved(simulation.plate().loads));
  }

 private:
  ProvenRun& run_;
  std::int64_t step_;
};

TEST_F(ProofOf, LoadsExchangedBetweenTwoStepsAreDoneAgain) {
  record([](ProvenRun& run) {
    run.watch(std::make_shared<Meddler>(run, 11));
    run.run(6e-6);
  });
  expect_agreement();
}

// Is in balance, under a load that grows.
Plate balanced_plate() {
  Plate plate = proven_plate();
  plate.loads.impactors.clear();
  plate.loads.tractions[0].stress = Vec2(0.0, 8e6);
  plate.loads.tractions[1].stress = Vec2(0.0, -8e6);
  for (Traction& traction : plate.loads.tractions)
    traction.amplitude = Amplitude({{0.0, 0.1}, {20e-6, 1.0}});
  return plate;
}

TEST_F(ProofOf, EquilibriaAndSlowLoadingAreDoneAgain) {
  record(
      [](ProvenRun& run) {
        run.run(1e-6);
        run.relax(1e-8);
        run.run(1.5e-6);
        run.load_slowly(3e-6, 3, 1e-6);
        run.run(1e-6);
      },
      {1e-6}, balanced_plate());
  expect_agreement();
}

// Stops slow loading at its second look, with other loads.
class Breaker : public Observer {
 public:
  explicit Breaker(ProvenRun& run) : run_(run) {}
  bool due(const Simulation&) override { return ++looks_ == 3; }
  void observe(const Simulation& simulation) override {
    run_.set_loads(halved(simulation.plate().loads));
    run_.stop();
  }

 private:
  ProvenRun& run_;
  int looks_ = 0;
};

TEST_F(ProofOf, SlowLoadingThatIsBrokenOffIsBrokenOffAgain) {
  record(
      [](ProvenRun& run) {
        const auto breaker = std::make_shared<Breaker>(run);
        run.watch(breaker);
        run.load_slowly(5e-6, 5, 1e-6);
        EXPECT_LT(run.simulation().time(), 3e-6);
        run.run(1e-6);
      },
      {1e-6}, balanced_plate());
  expect_agreement();
}

TEST_F(ProofOf, ARecordThatBeginsInTheMiddleHolds) {
  ProvenRun run(proven_plate(), test::numerics(), {1}, Talk::quiet, {"a.lua", ""});
  run.run(2.05e-6);
  run.set_loads(halved(run.simulation().plate().loads));
  run.record(file_, {0.4e-6});
  run.run(2e-6);
  run.close();
  expect_agreement();
  EXPECT_EQ(proof().records, 6U);
}

TEST_F(ProofOf, PartsOfAPlateAndOtherFieldsHold) {
  RecordOptions options;
  options.steps = 4;
  options.fields = {"stress_1", "energy_density", "velocity"};
  options.region = rectangle({0.002, 0.002}, {0.012, 0.008});
  options.coarsen = 3;
  record([](ProvenRun& run) { run.run(4e-6); }, options);
  expect_agreement();
  change<float>("records/0/00001/stress_1", H5T_NATIVE_FLOAT,
                [](auto& values) { values.at(8) = std::nextafter(values.at(8), 1e12F); });
  const Proof found = proof();
  ASSERT_TRUE(found.difference);
  // 20 x 12 nodes from (4, 4) on; every third of them, 7 x 4, begins at (4, 5).
  EXPECT_EQ(*found.difference->node, Vec2(7, 8));
}

TEST_F(ProofOf, SinglePrecisionAndExactRecordsHold) {
  Numerics numerics = test::numerics();
  numerics.precision = Precision::f32;
  RecordOptions options{1e-6};
  options.exact = true;
  record([](ProvenRun& run) { run.run(4e-6); }, options, proven_plate(), numerics);
  expect_agreement();
  change<float>("records/0/00003/uy", H5T_NATIVE_FLOAT,
                [](auto& values) { values[77] = std::nextafter(values[77], 1.0F); });
  const Proof found = proof();
  ASSERT_TRUE(found.difference);
  EXPECT_EQ(found.difference->quantity, "uy");
  EXPECT_EQ(found.difference->record, 3U);
}

TEST_F(ProofOf, FunctionsOfAScriptAreRefusedByName) {
  Plate plate = proven_plate();
  plate.loads.tractions[1].amplitude = Amplitude([](double t) { return 1e5 * t; }, "of t");
  record([](ProvenRun& run) { run.run(2e-6); }, {1e-6}, plate);
  try {
    proof();
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_THAT(error.what(), HasSubstr("tractions 2 time"));
  }
}

TEST_F(ProofOf, FunctionsSetLaterStopItAtTheirRecord) {
  record([](ProvenRun& run) {
    run.run(2e-6);
    Loads loads = run.simulation().plate().loads;
    loads.tractions[0].amplitude = Amplitude([](double t) { return 1e5 * t; }, "of t");
    run.set_loads(loads);
    run.run(2e-6);
  });
  const Proof found = proof();
  EXPECT_FALSE(found.difference);
  EXPECT_EQ(found.compared, 3U);
  EXPECT_THAT(found.stopped, HasSubstr("tractions 1 time"));
}

TEST_F(ProofOf, AFileOfFormat2IsComparedByItsFields) {
  record_plainly();
  const hid_t file = H5Fopen(file_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  for (const char* name : {"state_hash", "contents", "records/0/00000/state"})
    H5Ldelete(file, name, H5P_DEFAULT);
  const long long format = 2;
  const hid_t attribute = H5Aopen(file, "format_version", H5P_DEFAULT);
  H5Awrite(attribute, H5T_NATIVE_LLONG, &format);
  H5Aclose(attribute);
  H5Fclose(file);
  const Proof found = proof();
  EXPECT_FALSE(found.has_hashes);
  EXPECT_EQ(found.compared, 7U);
  EXPECT_FALSE(found.difference);
}

}  // namespace
}  // namespace hackle
