// SPDX-License-Identifier: MIT
// The right to run one case, among processes that share a study's folder.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "base/file_lock.hpp"
#include "study/provenance.hpp"

namespace hackle {

// Holds a lock on a file, in which it says who has it. The system releases the lock when the
// process and the program that inherits descriptor() have ended, however they end; the file is
// removed with the object. A file that is there although nobody holds it was left by a process that
// died.
class CaseClaim {
 public:
  // Returns the claim, or nothing if another process has it. Throws Error (files) if the file
  // cannot be made or, with `must_lock`, its file system has no locks; without it a process there
  // is taken to be alone.
  static std::optional<CaseClaim> of(const std::filesystem::path& file, const Provenance& holder,
                                     bool must_lock);
  // Waits for the others: for what each process does in turn. Throws Error (interrupted) besides.
  static CaseClaim in_turn(const std::filesystem::path& file);
  ~CaseClaim();
  CaseClaim(CaseClaim&&) noexcept = default;
  CaseClaim& operator=(CaseClaim&&) = delete;

  // Returns who left the file, if somebody did.
  const std::optional<Provenance>& left_by() const { return left_by_; }
  int descriptor() const { return lock_->descriptor(); }

 private:
  CaseClaim(std::filesystem::path file, std::unique_ptr<FileLock> lock);

  std::filesystem::path file_;
  std::unique_ptr<FileLock> lock_;
  std::optional<Provenance> left_by_;
};

// Returns who says in the file that he has it, if it can be read.
std::optional<Provenance> holder_in(const std::filesystem::path& file);

}  // namespace hackle
