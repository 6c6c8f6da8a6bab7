// SPDX-License-Identifier: MIT
// Copies the packets of a movie into another file, without encoding anything again.
#pragma once

#include <cstdint>
#include <filesystem>

#include "movie/film_length.hpp"

namespace hackle {

// Of `from`, which may have been cut off anywhere, into `to`, a complete file with its index in
// front; `named` is the movie in messages, and its ending says the kind of both. Without a frame,
// and without `to`, when `from` cannot be read. Throws Error (files) when `to` cannot be written.
FilmLength copy_film(const std::filesystem::path& from, const std::filesystem::path& to,
                     const std::filesystem::path& named);

// Of a film that FFmpeg reads.
FilmLength length_of_film(const std::filesystem::path& path);

// The name that the copy of put_index_first() bears while it is written.
std::filesystem::path indexed_name(const std::filesystem::path& path);

// Replaces the partial file of `path`, which is complete and in fragments, by one with its index in
// front, so that it starts at once wherever it is played. Both are on the disk for a moment; where
// there is no room for that, the partial file stays as it is, which plays too. `frames` is how many
// it has.
void put_index_first(const std::filesystem::path& path, std::int64_t frames);

}  // namespace hackle
