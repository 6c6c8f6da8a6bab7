// SPDX-License-Identifier: MIT
#include "fuzz/file_runner.hpp"

#include <fstream>
#include <iterator>
#include <random>
#include <span>

#include "base/error.hpp"
#include "base/hash.hpp"
#include "console/replay/continuation.hpp"
#include "store/checkpoint.hpp"
#include "store/recording.hpp"
#include "store/run_file.hpp"
#include "support/scenes.hpp"

namespace hackle::test {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t seal = 16;  // digits

Simulation hit_plate() {
  Plate plate = edge_crack(24e6);
  plate.material.alphaT = 4e-6;
  plate.loads.impactors.push_back({{0.08, 0.045}, 5e-3, {0.0, -200.0}, 0.5});
  plate.loads.thermal_loads.push_back({strip(plate, Edge::left, 20e-3), ScalarField(-50.0), {}});
  Simulation simulation(std::move(plate), numerics(4e-3, 12e-3), {1});
  simulation.run(20e-6);
  return simulation;
}

std::string bytes_in(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void put(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

std::string sealed(std::string bytes) {
  if (bytes.size() < seal) return bytes;
  bytes.resize(bytes.size() - seal);
  Hash hash;
  hash.add(std::span<const char>(bytes));
  return bytes + hash.hex();
}

void read_checkpoint_file(const fs::path& file) {
  Checkpoint checkpoint = read_checkpoint(file);
  if (!checkpoint.continuation.empty()) continuation_of(checkpoint.continuation, file);
  Simulation simulation = resume(std::move(checkpoint), {1});
  simulation.step();
}

void read_run_file(const fs::path& file) {
  Recording recording(file);
  for (std::size_t k = 0; k < std::min<std::size_t>(recording.times().size(), 4); ++k) {
    recording.go_to(k);
    (void)recording.view().displacement(0, 0);
  }
}

}  // namespace

std::string whole_file(StoredFile kind, const fs::path& folder) {
  Simulation simulation = hit_plate();
  const Origin origin{"a.lua", "s:run(1*us)"};
  const fs::path file = folder / (kind == StoredFile::checkpoint ? "whole.ckpt" : "whole.h5");
  if (kind == StoredFile::checkpoint) {
    Continuation continuation;
    continuation.inputs = {"a", {{"key", "value"}}, {"argument"}};
    continuation.origin = origin;
    continuation.journal = "journal";
    continuation.outputs[1] = {{"a.mp4", 3, 0.0, 4, false}};
    write_checkpoint(file, image_of(simulation, origin, bytes_of(continuation)));
  } else {
    RunFile run_file(file, simulation, origin);
    run_file.add(simulation);
    simulation.run(2e-6);
    run_file.add(simulation);
    run_file.finish();
  }
  return bytes_in(file);
}

std::string damaged_file(std::string bytes, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto place = [&](std::size_t size) { return size == 0 ? 0 : random() % size; };
  for (std::uint64_t changes = 1 + random() % 4; changes > 0; --changes) {
    // Heads and texts are where structure is.
    const std::size_t at =
        random() % 2 == 0 ? place(bytes.size()) : place(std::min<std::size_t>(bytes.size(), 8192));
    const std::size_t count = 1 + place(8);
    switch (random() % 6) {
      case 0:
        bytes[at] = static_cast<char>(random());
        break;
      case 1:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
        break;
      case 2:
        bytes.insert(at, count, static_cast<char>(random()));
        break;
      case 3:
        bytes.erase(at, count);
        break;
      case 4:
        bytes.insert(at, bytes.substr(place(bytes.size()), count));
        break;
      default:
        bytes.replace(at, std::min(count, bytes.size() - at), count, "019-e.\xff\n"[random() % 8]);
    }
    if (bytes.empty()) bytes = "x";
  }
  return bytes;
}

bool read_damaged(StoredFile kind, std::string bytes, const fs::path& folder) {
  const bool is_checkpoint = kind == StoredFile::checkpoint;
  const fs::path file = folder / (is_checkpoint ? "damaged.ckpt" : "damaged.h5");
  put(file, is_checkpoint ? sealed(std::move(bytes)) : bytes);
  try {
    if (is_checkpoint)
      read_checkpoint_file(file);
    else
      read_run_file(file);
    return true;
  } catch (const Error&) {
    return false;
  }
}

}  // namespace hackle::test
