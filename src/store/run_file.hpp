// SPDX-License-Identifier: MIT
// The record of a run in HDF5, self-describing, with an XDMF sidecar for ParaView and VTK.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "base/origin.hpp"
#include "solver/simulation.hpp"
#include "store/series_file.hpp"

namespace hackle {

// RUN.h5 holds, with T records, N nodes (row by row from the lower left) and W words of bonds:
//   /nodes                          N x 3  f64  m    positions of the nodes
//   /material                       N      u8        where they differ
//   /time                           T      f64  s
//   /step                           T      i64
//   /records/0/00000/damage         N      f32       a group per thousand records, one per record
//   /records/0/00000/displacement   N x 3  f32  m
//   /records/0/00000/velocity       N x 3  f32  m/s
//   /records/0/00000/broken         N x W  u32       bits of the broken bonds that a node keeps
//   /records/0/00000/thermal_strain N      f32       where something is heated
//   /records/0/00000/discs          K x 5  f64       of K impactors, if there are any
//   /records/0/00000/rollers        K x 5  f64       likewise
//   /records/0/00000/platens        K x 6  f64       likewise
//   /series/NAME/HEADING            rows   f64       tables of s:log, at the end of the run
//   /script, /inputs                text             the script; plate and numerics in JSON
// Every dataset has `long_name` and, if it holds numbers, `units`. The root has format_version,
// software, version, git_hash, compiler, created (UTC), script_name, lattice_hash (see
// lattice_hash.hpp), records_committed and complete. records_committed is written after the data of
// a record, and readers trust only that many records (of /time and /step too); complete is 1 once
// the file is finished. Committed records are whole at any moment, whether the run is killed or the
// file is read while it is written; the sidecar may lack the last tenth. Recording reads the file
// back, and rescue_run() keeps the remains of a killed run.
inline constexpr int run_file_format = 2;

// Estimates the bytes of a run file with its sidecar. The size after compression was measured on
// plates with branching cracks: 6 to 8 of the 32 bytes per node remain.
double run_file_bytes(std::size_t nodes, std::int64_t records);

// "a/run.h5" -> "a/run.xdmf"
std::filesystem::path sidecar_of(std::filesystem::path run_file);

class RunFile {
 public:
  // Creates the file, replacing an old one; its sidecar RUN.xdmf is written with the first record.
  // Throws Error (files).
  RunFile(const std::filesystem::path& path, const Simulation& simulation, const Origin& origin);
  ~RunFile();

  // Appends the present state. Throws Error (files), e.g. on a full disk: committed records stay
  // valid. Throws Error (run_failed) if a value is not a finite float.
  void add(const Simulation& simulation);
  // Adds the tables of the run; call it at most once, before finish(). See write_series().
  void add(std::span<const SeriesTable> tables);
  // Closes the file and completes the sidecar. Call it only once.
  void finish();

  std::filesystem::path path() const;
  std::filesystem::path sidecar() const;

  static std::string library_version();  // "HDF5 1.10.8"

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hackle
