// SPDX-License-Identifier: MIT
#include "movie/rescue.hpp"

#include <string>
#include <system_error>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "movie/movie_kind.hpp"
#include "movie/partial_file.hpp"
#include "movie/webp_film.hpp"

namespace hackle {
namespace fs = std::filesystem;
namespace {

fs::path free_name(const fs::path& path) {
  for (int number = 1;; ++number) {
    const std::string which = number == 1 ? "" : fmt::format("_{}", number);
    fs::path name = path.parent_path() / fmt::format("{}.cut_off{}{}", path.stem().string(), which,
                                                     path.extension().string());
    std::error_code ignored;
    if (!fs::exists(name, ignored)) return name;
  }
}

// Into the partial file of `name`.
FilmLength complete(const fs::path& partial, const fs::path& name) {
  const fs::path to = partial_name(name);
  switch (movie_kind(name).writer) {
    case Writer::gif:  // complete after every frame
      fs::copy_file(partial, to, fs::copy_options::overwrite_existing);
      return length_of_film(to);
    case Writer::webp:
      return copy_webp(partial, to);
    default:
      return copy_film(partial, to, name);
  }
}

}  // namespace

std::optional<Rescued> rescue(const fs::path& path) {
  const fs::path partial = partial_name(path);
  std::error_code ignored;
  if (!fs::is_regular_file(fs::symlink_status(partial, ignored))) return std::nullopt;
  const FileLock lock(partial, false);
  if (lock.is_foreign()) return std::nullopt;
  const fs::path name = free_name(path);
  const PartialFile copy(name);
  const FilmLength length = complete(partial, name);
  if (length.frames == 0) return std::nullopt;
  publish(name);
  fs::remove(partial, ignored);
  return Rescued{name, length};
}

}  // namespace hackle
