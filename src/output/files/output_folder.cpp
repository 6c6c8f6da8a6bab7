// SPDX-License-Identifier: MIT
#include "output/files/output_folder.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/files.hpp"

namespace hackle {
namespace fs = std::filesystem;
namespace {

constexpr const char* mark_ending = ".inputs.json";

constexpr int max_folders = 100000;

std::string text_of(const RunInputs& inputs, bool finished) {
  const nlohmann::ordered_json json{{"script", inputs.script},
                                    {"set", inputs.overrides},
                                    {"arguments", inputs.arguments},
                                    {"finished", finished}};
  return json.dump(2) + "\n";
}

// Returns "load=24MPa, a b", or "no --set".
std::string name_of(const RunInputs& inputs) {
  std::string text;
  for (const auto& [key, value] : inputs.overrides)
    text += fmt::format("{}{}={}", text.empty() ? "" : ", ", key, value);
  for (const std::string& argument : inputs.arguments)
    text += fmt::format("{}{}", text.empty() ? "-- " : " ", argument);
  return text.empty() ? "no --set" : text;
}

}  // namespace

OutputFolder::OutputFolder(fs::path wanted, Choice choice, RunInputs inputs)
    : wanted_(std::move(wanted)), path_(wanted_), choice_(choice), inputs_(std::move(inputs)) {
}

fs::path OutputFolder::mark_file_in(const fs::path& folder) const {
  return folder / (inputs_.script + mark_ending);
}

// out/NAME, out/NAME-2, ...
fs::path OutputFolder::folder(int number) const {
  return number == 1 ? wanted_ : fs::path(fmt::format("{}-{}", wanted_.string(), number));
}

// What is no mark of ours is one of a run with inputs that nobody has.
std::optional<OutputFolder::Mark> OutputFolder::read_mark(const fs::path& file) {
  std::error_code ignored;
  if (fs::symlink_status(file, ignored).type() == fs::file_type::not_found) return {};
  try {
    const auto json = nlohmann::json::parse(read_text(file));
    return Mark{{json.at("script"), json.at("set"), json.at("arguments")}, json.at("finished")};
  } catch (const std::exception&) {
    return Mark{{"?", {}, {}}, false};
  }
}

// Returns false if another program was faster.
bool OutputFolder::leave_mark() {
  make_folder_of(mark_file());
  std::FILE* file = std::fopen(mark_file().c_str(), "wx");
  if (file == nullptr && errno == EEXIST) return false;
  if (file == nullptr)
    throw Error(ErrorKind::files,
                fmt::format("cannot write '{}': {}", mark_file().string(), std::strerror(errno)));
  std::fclose(file);
  write_text(mark_file(), text_of(inputs_, false));
  return true;
}

std::string OutputFolder::remark_on(const Mark& former) const {
  if (former.inputs != inputs_)
    return fmt::format("the files of an earlier run in '{}' ({}) are overwritten", path_.string(),
                       name_of(former.inputs));
  if (!former.finished) return {};
  return fmt::format("'{}' holds the finished run of the same inputs ({}): it is made anew",
                     path_.string(), name_of(inputs_));
}

void OutputFolder::refuse(const Mark& former) const {
  throw Error(ErrorKind::refused,
              fmt::format("'{}' holds the run of '{}' with {}, this one has {}", path_.string(),
                          inputs_.script, name_of(former.inputs), name_of(inputs_)),
              "name another folder by -o, or overwrite it by --force");
}

std::string OutputFolder::take() {
  if (taken_) return {};
  std::string remark = found();
  taken_ = true;
  return remark;
}

// Before the mark of another life is changed.
void OutputFolder::lock() {
  lock_ = std::make_unique<HeldFile>(path_ / ("." + inputs_.script + ".running"), mark_file());
}

std::optional<fs::path> OutputFolder::unfinished() const {
  for (int k = 1; k < max_folders; ++k) {
    const std::optional<Mark> former = read_mark(mark_file_in(folder(k)));
    if (!former || (former->inputs != inputs_ && choice_ != Choice::free)) return std::nullopt;
    if (former->inputs == inputs_)
      return former->finished ? std::nullopt : std::optional(folder(k));
  }
  return std::nullopt;
}

bool OutputFolder::is_finished(const fs::path& folder, const std::string& script) {
  const std::optional<Mark> mark = read_mark(folder / (script + mark_ending));
  return mark && mark->finished;
}

// Finds the folder and leaves the mark there.
std::string OutputFolder::found() {
  for (int k = 1; k < max_folders;) {
    path_ = folder(k);
    const std::optional<Mark> former = read_mark(mark_file());
    if (!former && leave_mark()) {
      lock();
      return path_ == wanted_ ? std::string()
                              : fmt::format(
                                    "'{}' holds a run with other inputs; this one goes to "
                                    "'{}'",
                                    wanted_.string(), path_.string());
    }
    if (!former) continue;  // another program has just left one
    if (former->inputs == inputs_ || choice_ == Choice::force) {
      lock();
      if (former->finished && clear) clear(path_);
      write_text(mark_file(), text_of(inputs_, false));
      return remark_on(*former);
    }
    if (choice_ == Choice::named) refuse(*former);
    ++k;
  }
  throw Error(ErrorKind::files, fmt::format("there are too many folders '{}-2', '{}-3', ...",
                                            wanted_.string(), wanted_.string()));
}

void OutputFolder::finish() const {
  if (taken_) write_text(mark_file(), text_of(inputs_, true));
}

}  // namespace hackle
