// SPDX-License-Identifier: MIT
#include "console/lua/sandbox.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/files.hpp"

namespace hackle {
namespace fs = std::filesystem;
namespace {

constexpr const char* trust_hint = "hackle --trust lifts this for a script you trust";

// Both must be free of links.
bool lies_below(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
         folder.end();
}

void refuse_unless_plain(const std::string& who, const fs::path& path, const fs::path& real) {
  std::error_code ignored;
  const fs::file_type type = fs::status(real, ignored).type();
  // Folders are refused by the function that opens them.
  if (type == fs::file_type::regular || type == fs::file_type::not_found ||
      type == fs::file_type::directory)
    return;
  throw Error(ErrorKind::refused, fmt::format("{}: '{}' is no plain file", who, path.string()),
              trust_hint);
}

std::string shown(const fs::path& folder) {
  return folder.empty() ? "the current folder" : fmt::format("'{}'", folder.string());
}

}  // namespace

Sandbox::Sandbox(std::vector<fs::path> readable, fs::path writable, bool trust)
    : readable_(std::move(readable)), writable_(std::move(writable)), trust_(trust) {
}

void Sandbox::check_input(const std::string& who, const fs::path& path) const {
  if (trust_) return;
  const fs::path real = real_path(path);
  const auto holds = [&](const fs::path& folder) { return lies_below(real, real_path(folder)); };
  if (std::ranges::none_of(readable_, holds))
    throw Error(ErrorKind::refused,
                fmt::format("{}: '{}' lies outside of what a script may read", who, path.string()),
                fmt::format("it may read below {}; {}", shown(readable_.front()), trust_hint));
  refuse_unless_plain(who, path, real);
}

void Sandbox::check_output(const std::string& who, const fs::path& path) const {
  if (trust_) return;
  fs::path sidecar = path;
  sidecar.replace_extension(".xdmf");
  const fs::path folder = real_path(writable_);
  for (const fs::path& name : {path, partial_name(path), sidecar, partial_name(sidecar)}) {
    const fs::path real = real_path(name);
    if (!lies_below(real, folder))
      throw Error(ErrorKind::refused,
                  fmt::format("{}: '{}' lies outside of the output folder", who, path.string()),
                  fmt::format("a script writes below {} only; {}", shown(writable_), trust_hint));
    refuse_unless_plain(who, path, real);
  }
}

}  // namespace hackle
