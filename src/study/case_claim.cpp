// SPDX-License-Identifier: MIT
#include "study/case_claim.hpp"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <system_error>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "base/interrupt.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// Without locks two processes would run a case into one folder.
void check_claim(const FileLock& lock, const fs::path& file, bool must_lock) {
  const int reason = errno;
  if (!lock.is_open())
    throw Error(ErrorKind::files,
                fmt::format("cannot create '{}': {}", file.string(), std::strerror(reason)),
                "choose another folder with -o");
  if (must_lock && !lock.is_held() && !lock.is_foreign())
    throw Error(ErrorKind::files,
                fmt::format("cannot lock '{}': {}", file.string(), std::strerror(reason)),
                "choose a folder on a file system with locks, with -o");
}

// Others read it only to tell whom they wait for.
void sign(const FileLock& lock, const Provenance& holder) {
  const std::string text = to_json(holder).dump(-1, ' ', false, Json::error_handler_t::replace);
  const bool emptied = ftruncate(lock.descriptor(), 0) == 0;
  [[maybe_unused]] const auto written =
      emptied ? pwrite(lock.descriptor(), text.data(), text.size(), 0) : 0;
}

}  // namespace

std::optional<CaseClaim> CaseClaim::of(const fs::path& file, const Provenance& holder,
                                       bool must_lock) {
  auto lock = std::make_unique<FileLock>(file, true);
  check_claim(*lock, file, must_lock);
  if (lock->is_foreign()) return std::nullopt;
  CaseClaim claim(file, std::move(lock));
  sign(*claim.lock_, holder);
  return claim;
}

CaseClaim CaseClaim::in_turn(const fs::path& file) {
  constexpr std::chrono::milliseconds between_looks(50);
  make_folder_of(file);
  for (;;) {
    if (auto claim = of(file, provenance_now(""), false)) return *std::move(claim);
    throw_if_interrupted();
    std::this_thread::sleep_for(between_looks);
  }
}

CaseClaim::CaseClaim(fs::path file, std::unique_ptr<FileLock> lock)
    : file_(std::move(file)), lock_(std::move(lock)), left_by_(holder_in(file_)) {
}

CaseClaim::~CaseClaim() {
  std::error_code ignored;
  if (lock_ && lock_->is_at(file_)) fs::remove(file_, ignored);
}

std::optional<Provenance> holder_in(const fs::path& file) {
  try {
    const Json json = Json::parse(read_text(file), nullptr, false);
    if (json.is_object()) return provenance_of(json);
  } catch (const Error&) {
    // It was removed meanwhile.
  }
  return std::nullopt;
}

}  // namespace hackle
