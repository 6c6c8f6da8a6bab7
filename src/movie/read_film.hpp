// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "movie/film_facts.hpp"

namespace hackle {

// Reads what a movie says of itself. The kind follows from the extension, see movie_kind(). Throws
// Error (files) for a file that is no movie of that kind, and what movie_kind() throws.
FilmFacts facts_of_film(const std::filesystem::path& path);

}  // namespace hackle
