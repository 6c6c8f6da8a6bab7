// SPDX-License-Identifier: MIT
#include "movie/read_film.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "movie/movie_kind.hpp"
#include "movie/png_text.hpp"
#include "movie/remux.hpp"
#include "movie/webp_film.hpp"

namespace hackle {

FilmFacts facts_of_film(const std::filesystem::path& path) {
  const MovieKind& kind = movie_kind(path);
  FilmFacts facts = kind.writer == Writer::webp ? facts_of_webp(path) : facts_by_ffmpeg(path);
  if (facts.length.frames == 0)
    throw Error(ErrorKind::files, fmt::format("cannot read '{}': it is no {} movie, or is damaged",
                                              path.string(), kind.name));
  if (kind.ending == ".apng") {  // FFmpeg does not read its texts
    const std::string bytes = read_text(path);
    facts.title = text_in_png(bytes, "Title");
    facts.comment = text_in_png(bytes, "Comment");
  }
  return facts;
}

}  // namespace hackle
