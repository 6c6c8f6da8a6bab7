// SPDX-License-Identifier: MIT
#include "movie/make_film.hpp"

#include "movie/gif_film.hpp"
#include "movie/stream_film.hpp"
#include "movie/webp_film.hpp"

namespace hackle {

std::unique_ptr<Film> make_film(const std::filesystem::path& path, const MovieFormat& format) {
  switch (movie_kind(path).writer) {
    case Writer::gif:
      return std::make_unique<GifFilm>(path, format);
    case Writer::webp:
      return std::make_unique<WebpFilm>(path, format);
    default:
      return std::make_unique<StreamFilm>(path, format);
  }
}

}  // namespace hackle
