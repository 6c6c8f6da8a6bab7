// SPDX-License-Identifier: MIT
#include "store/stored_kind.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "base/error.hpp"

namespace hackle {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view of_hdf5 = "\x89HDF\r\n\x1a\n";
constexpr std::string_view of_checkpoint = "Hackle checkpoint ";

[[noreturn]] void refuse_file(const fs::path& path, const std::string& why,
                              const std::string& remedy = {}) {
  throw Error(ErrorKind::files, fmt::format("cannot read '{}': {}", path.string(), why), remedy);
}

}  // namespace

StoredKind kind_of_stored(const fs::path& path) {
  std::error_code failure;
  if (!fs::exists(path, failure)) refuse_file(path, "there is no such file");
  if (fs::is_directory(path, failure)) refuse_file(path, "it is a folder");
  if (!fs::is_regular_file(path, failure)) refuse_file(path, "it is no plain file");
  std::array<char, 32> bytes{};
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse_file(path, std::strerror(errno));
  file.read(bytes.data(), bytes.size());
  const std::string_view head(bytes.data(), static_cast<std::size_t>(file.gcount()));
  if (head.starts_with(of_hdf5)) return StoredKind::run;
  return head.starts_with(of_checkpoint) ? StoredKind::checkpoint : StoredKind::other;
}

void refuse_kind(const fs::path& path, const std::string& what) {
  refuse_file(path, fmt::format("it is {} of Hackle", what),
              "s:record{} writes run files, s:save{} checkpoints");
}

}  // namespace hackle
