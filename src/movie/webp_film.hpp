// SPDX-License-Identifier: MIT
// An animated WebP that is complete after every second.
#pragma once

#include <optional>

#include "movie/byte_file.hpp"
#include "movie/codec.hpp"
#include "movie/film.hpp"
#include "movie/film_facts.hpp"
#include "movie/film_length.hpp"
#include "movie/movie_format.hpp"

namespace hackle {

// The encoder delivers nothing before its end, so it encodes chapters of about a second, each
// beginning with a whole picture; their frames follow one another in one file. Times are in ms.
class WebpFilm : public Film {
 public:
  WebpFilm(const std::filesystem::path& path, const MovieFormat& format);

  void add(const Image& image) override;
  void finish() override;

 private:
  void write_head();
  void end_chapter();
  void write_metadata();
  void write_chapter(std::span<const std::uint8_t> animation);

  std::filesystem::path path_;
  MovieFormat format_;
  ByteFile file_;
  std::optional<Codec> chapter_;
  std::int64_t next_ = 0;        // frame
  std::int64_t chapter_at_ = 0;  // its first frame
};

// Copies `from`, which may be truncated, to `to`. Throws Error (files).
FilmLength copy_webp(const std::filesystem::path& from, const std::filesystem::path& to);

// Returns no frame for what is no WebP. Throws Error (files) if it cannot be read.
FilmFacts facts_of_webp(const std::filesystem::path& path);

}  // namespace hackle
