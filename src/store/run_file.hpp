// SPDX-License-Identifier: MIT
// The record of a run in HDF5, self-describing, with an XDMF sidecar that ParaView and VTK open.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "solver/simulation.hpp"

namespace hackle {

// Where a run comes from.
struct Origin {
  std::string script_name;
  std::string script_text;
};

// RUN.h5 holds, with T records, N nodes (row by row from the lower left) and W words of bonds:
//   /nodes                          N x 3  f64  m    places of the nodes
//   /material                       N      u8        where they differ
//   /time                           T      f64  s
//   /step                           T      i64
//   /records/0/00000/damage         N      f32       a group for each thousand, in it one a record
//   /records/0/00000/displacement   N x 3  f32  m
//   /records/0/00000/velocity       N x 3  f32  m/s
//   /records/0/00000/broken         N x W  u32       bits of the broken bonds that a node keeps
//   /records/0/00000/thermal_strain N      f32       where something is heated
//   /records/0/00000/discs          K x 5  f64       of K impactors, if there are any
//   /script, /inputs                text             the script; plate and numerics in JSON
// Every dataset has `long_name` and, if it holds numbers, `units`; the root has format_version,
// software, version, git_hash, compiler, created (UTC), script_name, lattice_hash (see
// lattice_hash.hpp) and records_committed, which is written after the data of a record: readers
// trust only so many (of /time and /step too), and complete, which is 1 once it is finished. A run
// that is killed at whatever moment leaves a file in which they are whole, and whoever reads the
// file while it is written finds it so; its sidecar may lack the last tenth. Recording reads it
// back, and rescue_run() keeps what a killed run has left.
inline constexpr int run_file_format = 2;

// About how many bytes a run file with so many nodes and records takes, and its sidecar. What is
// left of 32 bytes a node after compression was measured on plates that branch: 6 to 8.
double run_file_bytes(std::size_t nodes, std::int64_t records);

// "a/run.h5" -> "a/run.xdmf"
std::filesystem::path sidecar_of(std::filesystem::path run_file);

class RunFile {
 public:
  // Creates the file, replacing an old one; its sidecar RUN.xdmf comes beside it with the first
  // record. Throws Error (files).
  RunFile(const std::filesystem::path& path, const Simulation& simulation, const Origin& origin);
  ~RunFile();

  // Appends the state as it is now. Throws Error (files), e.g. when the disk is full: what was
  // committed before stays. Throws Error (run_failed) when a value is not a finite float.
  void add(const Simulation& simulation);
  // Closes the file and completes the sidecar. Once only.
  void finish();

  std::filesystem::path path() const;
  std::filesystem::path sidecar() const;

  static std::string library_version();  // "HDF5 1.10.8"

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hackle
