// SPDX-License-Identifier: MIT
#include "study/provenance.hpp"

#include <array>
#include <chrono>
#include <limits>

#include <fmt/format.h>
#include <unistd.h>

namespace hackle {
namespace {

double seconds_since_1970() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

std::string this_machine() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

template <class Value>
Value value_or_none(const nlohmann::ordered_json& json, const char* key) {
  try {
    return json.value(key, Value{});
  } catch (const nlohmann::ordered_json::exception&) {
    return {};
  }
}

}  // namespace

Provenance provenance_now(const std::string& job) {
  return {this_machine(), getpid(), job, seconds_since_1970(), false};
}

std::string process_name(const Provenance& one) {
  return fmt::format("process {} on {}", one.process, one.machine);
}

nlohmann::ordered_json to_json(const Provenance& one) {
  return {{"machine", one.machine},
          {"process", one.process},
          {"job", one.job},
          {"began_s", one.began},
          {"taken_over", one.taken_over}};
}

Provenance provenance_of(const nlohmann::ordered_json& json) {
  return {value_or_none<std::string>(json, "machine"), value_or_none<int>(json, "process"),
          value_or_none<std::string>(json, "job"), value_or_none<double>(json, "began_s"),
          value_or_none<bool>(json, "taken_over")};
}

StudySession::StudySession(const Launcher& launcher)
    : job_(launcher.job),
      start_(seconds_since_1970()),
      patience_(launcher.is_in_array() ? std::numeric_limits<double>::infinity() : 600.0) {
}

bool StudySession::includes(const Provenance& one) const {
  const bool is_of_job = !job_.empty() && one.job == job_;
  return one.began >= start_ - (is_of_job ? patience_ : 0.0);
}

}  // namespace hackle
