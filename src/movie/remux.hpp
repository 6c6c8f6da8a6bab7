// SPDX-License-Identifier: MIT
// Copies the packets of a movie into another file without encoding again.
#pragma once

#include <cstdint>
#include <filesystem>

#include "movie/film_facts.hpp"
#include "movie/film_length.hpp"

namespace hackle {

// Copies `from`, which may be truncated anywhere, to `to`, a complete file with its index in front.
// `named` is the movie in messages, and its extension gives the kind of both. If `from` cannot be
// read, the result has no frame and `to` is not written. Throws Error (files) if `to` cannot be
// written.
FilmLength copy_film(const std::filesystem::path& from, const std::filesystem::path& to,
                     const std::filesystem::path& named);

// Returns the length of a movie that FFmpeg can read.
FilmLength length_of_film(const std::filesystem::path& path);

// Returns what FFmpeg reads of a movie; no frame if it cannot.
FilmFacts facts_by_ffmpeg(const std::filesystem::path& path);

// The name that the copy of put_index_first() bears while it is written.
std::filesystem::path indexed_name(const std::filesystem::path& path);

// Replaces the partial file of `path`, which is complete and in fragments, by one with its index in
// front, so that players can start at once. Both are on the disk for a moment; if there is no room
// for that, the partial file stays as it is, which also plays. `frames` is its number of frames.
void put_index_first(const std::filesystem::path& path, std::int64_t frames);

}  // namespace hackle
