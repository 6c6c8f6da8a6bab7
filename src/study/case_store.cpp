// SPDX-License-Identifier: MIT
#include "study/case_store.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "base/hash.hpp"
#include "base/version.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// What tells whether a file has changed.
std::string facts_of(const fs::path& file) {
  std::error_code failed;
  const auto changed = fs::last_write_time(file, failed).time_since_epoch().count();
  return fmt::format("{} {} {}", file.filename().string(), fs::file_size(file, failed), changed);
}

// The files that a script may read: modules and tables in its folder.
std::vector<std::string> files_beside(const fs::path& script) {
  std::vector<std::string> all;
  std::error_code failed;
  const fs::path folder = script.has_parent_path() ? script.parent_path() : fs::path(".");
  for (const auto& entry : fs::directory_iterator(folder, failed)) {
    const fs::path ending = entry.path().extension();
    if (entry.path().filename() == script.filename()) continue;
    if (ending == ".lua" || ending == ".csv" || ending == ".dxf" || ending == ".json")
      all.push_back(facts_of(entry.path()));
  }
  std::ranges::sort(all);
  return all;
}

CaseState state_of(const Json& kept) {
  if (kept.contains("stopped_after_s")) return CaseState::stopped;
  return kept.value("finished", false) ? CaseState::finished : CaseState::failed;
}

Json kept_text(const Outcome& outcome, const Settings& settings, double time_limit) {
  Json kept{{"settings", settings},
            {"finished", outcome.finished()},
            {"exit_code", outcome.exit_code},
            {"reason", outcome.reason},
            {"wall_s", outcome.wall},
            {"cpu_s", outcome.cpu},
            {"bytes", outcome.peak_bytes},
            {"made", to_json(outcome.made)},
            {"told", outcome.told}};
  if (outcome.state == CaseState::stopped) kept["stopped_after_s"] = time_limit;
  return kept;
}

}  // namespace

CaseStore::CaseStore(StudyScript script, fs::path folder)
    : script_(std::move(script)),
      folder_(std::move(folder)),
      text_(read_text(script_.path)),
      beside_(files_beside(script_.path)) {
}

std::string CaseStore::key_of(const Case& one) const {
  const Json inputs{{"program", {version(), git_hash(), facts_of(script_.program)}},
                    {"script", text_},
                    {"beside", beside_},
                    {"settings", joined(script_.settings, one.settings)},
                    {"arguments", script_.arguments},
                    {"sample_at", one.sample_at},
                    {"pictures", one.with_pictures},
                    {"repeat", one.repeat},
                    {"last_picture", one.with_last_picture}};
  Hash hash;
  hash.add(std::span<const char>(inputs.dump(-1, ' ', false, Json::error_handler_t::replace)));
  return hash.hex();
}

fs::path CaseStore::folder_of(const Case& one) const {
  return file_of(one, "");
}

fs::path CaseStore::picture_of(const Case& one) const {
  return folder_of(one) / "last.png";
}

fs::path CaseStore::lock_of(const Case& one) const {
  return file_of(one, ".lock");
}

fs::path CaseStore::file_of(const Case& one, const char* ending) const {
  return folder_ / "cases" / (key_of(one) + ending);
}

std::optional<Outcome> CaseStore::outcome_of(const Case& one, double time_limit) const {
  std::error_code ignored;
  const fs::path file = file_of(one, ".json");
  if (one.with_last_picture && !fs::is_regular_file(picture_of(one), ignored)) return std::nullopt;
  if (!fs::is_regular_file(file, ignored)) return std::nullopt;
  const Json kept = Json::parse(read_text(file), nullptr, false);
  if (!kept.is_object() || !kept.contains("told")) return std::nullopt;
  if (kept.value("stopped_after_s", time_limit) < time_limit) return std::nullopt;
  return Outcome{.setting = one,
                 .state = state_of(kept),
                 .exit_code = kept.value("exit_code", 0),
                 .reason = kept.value("reason", std::string()),
                 .wall = kept.value("wall_s", 0.0),
                 .cpu = kept.value("cpu_s", 0.0),
                 .peak_bytes = kept.value("bytes", std::uint64_t{0}),
                 .told = kept["told"],
                 .made = provenance_of(kept.value("made", Json::object()))};
}

void CaseStore::keep(const Outcome& outcome, double time_limit) const {
  const Settings settings = joined(script_.settings, outcome.setting.settings);
  write_text(file_of(outcome.setting, ".json"),
             kept_text(outcome, settings, time_limit)
                     .dump(-1, ' ', false, Json::error_handler_t::replace) +
                 "\n");
}

}  // namespace hackle
