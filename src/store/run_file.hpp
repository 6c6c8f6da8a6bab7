// SPDX-License-Identifier: MIT
// The record of a run in HDF5, self-describing, with an XDMF sidecar for ParaView and VTK.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "base/origin.hpp"
#include "solver/simulation.hpp"
#include "store/record_contents.hpp"
#include "store/series_file.hpp"

namespace hackle {

// RUN.h5 holds, with T records, N nodes (row by row from the lower left) and W words of bonds:
//   /nodes                          N x 3  f64  m    positions of the nodes
//   /material                       N      u8        where they differ
//   /time                           T      f64  s
//   /step                           T      i64
//   /state_hash                     T      text      State::hash(), sixteen hexadecimal digits
//   /records/0/00000/damage         N      f32       a group per thousand records, one per record
//   /records/0/00000/displacement   N x 3  f32  m
//   /records/0/00000/velocity       N x 3  f32  m/s
//   /records/0/00000/broken         N x W  u32       bits of the broken bonds that a node keeps
//   /records/0/00000/thermal_strain N      f32       where something is heated
//   /records/0/00000/discs          K x 5  f64       of K impactors, if there are any
//   /records/0/00000/rollers        K x 5  f64       likewise
//   /records/0/00000/platens        K x 6  f64       likewise
//   /series/NAME/HEADING            rows   f64       tables of s:log, at the end of the run
//   /records/0/00000/journal        text             what was done since the last record, in JSON
//   /script, /inputs, /contents     text             the script; plate and numerics; what is
//                                                    recorded (record_contents.hpp), in JSON
// /contents tells other fields, as N f32 each, and other nodes: then N are those of the record. The
// first record, and every one that is exact, also holds the state to the last bit, of all nodes and
// in the precision of the run (exact_state.hpp): ux, uy, vx, vy, threshold, broken and the text
// state. A record shows the plate at its time, which may be up to a step before the state of its
// step; /state_hash and the exact state are those after the step, which a replay can compare.
// Every dataset has `long_name` and, if it holds numbers, `units`. The root has format_version,
// software, version, git_hash, compiler, created (UTC), script_name, lattice_hash (see
// lattice_hash.hpp), records_committed and complete. records_committed is written after the data of
// a record, and readers trust only that many records (of /time, /step and /state_hash too);
// complete is 1 once the file is finished. Committed records are whole at any moment, whether the
// run is killed or the file is read while it is written; the sidecar may lack the last tenth.
// Recording reads the file back, and rescue_run() keeps the remains of a killed run. Format 2 had
// neither hashes, nor journals, nor contents, nor exact states.
inline constexpr int run_file_format = 3, oldest_run_file_format = 2;
inline constexpr std::size_t hash_digits = 16;

// Estimates the bytes of a run file with its sidecar. The size after compression was measured on
// plates with branching cracks: 6 to 8 of the 32 bytes per node remain of the standard fields. Of
// exact states, whose last digits are noise, most remains.
double run_file_bytes(const RecordContents& contents, const Grid& grid, std::int64_t records);

// "a/run.h5" -> "a/run.xdmf"
std::filesystem::path sidecar_of(std::filesystem::path run_file);

class RunFile {
 public:
  // Creates the file, replacing an old one; its sidecar RUN.xdmf is written with the first record.
  // Without `contents` it holds the standard ones. Throws Error (files).
  RunFile(const std::filesystem::path& path, const Simulation& simulation, const Origin& origin,
          std::optional<RecordContents> contents = {});
  // Goes on behind the first `records` records of a file that another program has left, whether it
  // was killed or has completed the file; later records are gone. Throws Error (files), with a
  // remedy, if it has fewer.
  RunFile(const std::filesystem::path& path, const Grid& grid, const RecordContents& contents,
          std::int64_t records);
  ~RunFile();

  // Appends the present state, and what was done since the last record (Journal::take()). Throws
  // Error (files), e.g. on a full disk: committed records stay valid. Throws Error (run_failed) if
  // a value is not a finite float.
  void add(const Simulation& simulation, const std::string& journal = {});
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
