// SPDX-License-Identifier: MIT
#include "movie/rescue.hpp"

#include <system_error>

#include "base/error.hpp"
#include "base/files.hpp"
#include "base/partial_file.hpp"
#include "movie/movie_kind.hpp"
#include "movie/webp_film.hpp"

namespace hackle {
namespace fs = std::filesystem;
namespace {

// Completes the remains of `name` into its partial file.
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

std::optional<Rescued> rescue(const fs::path& path,
                              const std::function<bool(const fs::path&)>& taken) {
  const fs::path partial = partial_name(path);
  std::error_code ignored;
  if (!fs::is_regular_file(fs::symlink_status(partial, ignored))) return std::nullopt;
  const FileLock lock(partial, false);
  if (lock.is_foreign()) return std::nullopt;
  const fs::path name = cut_off_name(
      path, [&](const fs::path& other) { return taken(other) || is_locked(partial_name(other)); });
  const PartialFile copy(name);
  const FilmLength length = complete(partial, name);
  if (length.frames == 0) return std::nullopt;
  publish(name);
  fs::remove(partial, ignored);
  return Rescued{name, length};
}

}  // namespace hackle
