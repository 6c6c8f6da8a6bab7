// SPDX-License-Identifier: MIT
#include "output/files/output_names.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "base/partial_file.hpp"
#include "base/text.hpp"
#include "movie/kept_frames.hpp"
#include "movie/movie_kind.hpp"
#include "movie/remux.hpp"
#include "store/checkpoint.hpp"
#include "store/run_file.hpp"

namespace hackle {
namespace fs = std::filesystem;
namespace {

struct Endings {
  FileKind kind;
  std::string_view what;  // as in "no name of a picture"
  std::string_view maker;
  std::vector<std::string_view> endings;
};

std::vector<std::string_view> movie_endings() {
  std::vector<std::string_view> endings;
  for (const MovieKind& kind : movie_kinds()) endings.push_back(kind.ending);
  return endings;
}

const std::array<Endings, 6>& all_endings() {
  static const std::array<Endings, 6> all{
      Endings{FileKind::movie, "movie", "movie", movie_endings()},
      Endings{FileKind::run_file, "run file", "record", {".h5", ".hdf5"}},
      Endings{FileKind::checkpoint, "checkpoint", "save", {".ckpt"}},
      Endings{FileKind::picture, "picture", "frame", {".png", ".pdf", ".svg"}},
      Endings{FileKind::script, "script", "script", {".lua"}},
      Endings{FileKind::table, "table", "log", {".csv"}}};
  return all;
}

std::string ending_of(const fs::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending;
}

bool holds(const Endings& known, std::string_view ending) {
  return std::ranges::find(known.endings, ending) != known.endings.end();
}

// Returns the function that makes files of this extension, or "".
std::string maker_of(std::string_view ending) {
  for (const Endings& known : all_endings())
    if (holds(known, ending)) return fmt::format("; {}{{}} makes {}", known.maker, ending);
  return "";
}

// A file may be replaced under its own name, or written through a link.
void add_names(const fs::path& path, std::set<fs::path>& names) {
  names.insert(real_path(path));
  names.insert(real_path(path.parent_path()) / path.filename());
}

// Returns the companions of a movie; a movie with an index first gets that in a separate file.
std::vector<fs::path> movie_companions(const fs::path& path) {
  std::vector<fs::path> list{partial_name(path), kept_frames_name(path)};
  const auto kind = std::ranges::find(movie_kinds(), ending_of(path), &MovieKind::ending);
  if (kind != movie_kinds().end() && *kind->final_options != '\0')
    list.push_back(indexed_name(path));
  return list;
}

// The user's own names come first: a refusal names the first that is taken.
std::vector<fs::path> companions(const fs::path& path, FileKind kind) {
  switch (kind) {
    case FileKind::movie:
      return movie_companions(path);
    case FileKind::run_file: {
      const fs::path sidecar = sidecar_of(path);
      return {sidecar, partial_name(sidecar), recording_lock(path)};
    }
    case FileKind::checkpoint:
      return {previous_checkpoint(path), partial_name(path)};
    case FileKind::picture:
    case FileKind::script:
      return {partial_name(path)};
    case FileKind::table:
    case FileKind::text:
      break;
  }
  return {};
}

// Returns a name that is in both, or nothing.
std::optional<fs::path> common(const std::set<fs::path>& one, const std::set<fs::path>& other) {
  for (const fs::path& name : one)
    if (other.contains(name)) return name;
  return std::nullopt;
}

// Returns the first name of `path` that is in `taken`, or nothing.
std::optional<fs::path> first_taken(const fs::path& path, FileKind kind,
                                    const std::set<fs::path>& taken) {
  std::vector<fs::path> wanted = companions(path, kind);
  wanted.insert(wanted.begin(), path);
  for (const fs::path& one : wanted) {
    std::set<fs::path> names;
    add_names(one, names);
    if (auto name = common(names, taken)) return name;
  }
  return std::nullopt;
}

std::string at(const std::string& place) {
  return place.empty() ? "" : fmt::format(" ({})", place);
}

}  // namespace

void check_ending(const std::string& who, const fs::path& path, FileKind kind) {
  const auto known = std::ranges::find(all_endings(), kind, &Endings::kind);
  if (known == all_endings().end()) return;
  const std::string ending = ending_of(path);
  if (holds(*known, ending)) return;
  const std::string lacks = ending.empty()
                                ? "has no ending"
                                : fmt::format("ends in '{}', which is no {}{}", ending, known->what,
                                              did_you_mean(ending, known->endings));
  throw Error(ErrorKind::refused, fmt::format("{}: '{}' {}", who, path.filename().string(), lacks),
              fmt::format("one of {}{}", comma_list(known->endings), maker_of(ending)));
}

void OutputNames::claim(const std::string& who, const fs::path& path, FileKind kind) {
  Claim claim{who, place ? place() : "", path, kind, {}, {}};
  add_names(path, claim.own);
  claim.all = claim.own;
  for (const fs::path& companion : companions(path, kind)) add_names(companion, claim.all);
  for (const Claim& former : claims_) {
    const std::optional<fs::path> shared = first_taken(path, kind, former.all);
    if (!shared || may_replace(claim, former)) continue;
    const bool same = common(claim.own, former.own).has_value();
    const std::string what = same
                                 ? fmt::format("'{}' is already written by {}{}", path.string(),
                                               former.who, at(former.place))
                                 : fmt::format("'{}' would take '{}', which goes with '{}' of {}{}",
                                               path.string(), shared->filename().string(),
                                               former.path.string(), former.who, at(former.place));
    throw Error(ErrorKind::refused, fmt::format("{}: {}", who, what), "choose another file name");
  }
  if (!rehearses) refuse_if_written(path);
  std::erase_if(claims_, [&](const Claim& former) { return former.own == claim.own; });
  claims_.push_back(std::move(claim));
}

void OutputNames::claim_checked(const std::string& who, const fs::path& path, FileKind kind) {
  check_ending(who, path, kind);
  check_writable(path);
  claim(who, path, kind);
}

bool OutputNames::may_replace(const Claim& claim, const Claim& former) const {
  if (claim.kind != former.kind || !common(claim.own, former.own)) return false;
  // What a script saves is not what a run keeps and removes by itself.
  if (claim.kind == FileKind::checkpoint && claim.who != former.who) return false;
  const bool at_once = claim.kind != FileKind::movie && claim.kind != FileKind::run_file &&
                       claim.kind != FileKind::table;
  return at_once || (replaces_complete && former.is_complete);
}

void OutputNames::take_back(const fs::path& path) {
  std::erase_if(claims_, [&](const Claim& claim) { return claim.path == path; });
}

void OutputNames::complete(const fs::path& path) {
  for (Claim& claim : claims_)
    if (claim.path == path) claim.is_complete = true;
}

bool OutputNames::is_claimed(const fs::path& path) const {
  std::set<fs::path> names;
  add_names(path, names);
  const auto touches = [&](const Claim& claim) { return common(names, claim.all).has_value(); };
  return std::ranges::any_of(claims_, touches);
}

}  // namespace hackle
