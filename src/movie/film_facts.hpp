// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "movie/film_length.hpp"

namespace hackle {

// What the file of a movie says of itself.
struct FilmFacts {
  int width = 0, height = 0;  // px
  FilmLength length;
  std::string title;    // as MovieFormat has them; "" where the file has none: a GIF keeps no
  std::string comment;  // title, and WebP and APNG that were cut off have neither
};

}  // namespace hackle
