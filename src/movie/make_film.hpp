// SPDX-License-Identifier: MIT
// Makes the film for the kind of a movie.
#pragma once

#include <filesystem>
#include <memory>

#include "movie/film.hpp"
#include "movie/movie_format.hpp"

namespace hackle {

// Makes the film for the extension of `path` and opens the partial file. Throws as Encoder does.
std::unique_ptr<Film> make_film(const std::filesystem::path& path, const MovieFormat& format);

}  // namespace hackle
