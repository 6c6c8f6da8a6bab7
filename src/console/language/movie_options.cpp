// SPDX-License-Identifier: MIT
#include "console/language/movie_options.hpp"

namespace hackle {

MovieOptions movie_of(const Arguments& arguments) {
  MovieOptions options;
  options.picture = sized_picture_of(arguments);
  options.fps = arguments.number("fps", options.fps);
  options.profile = arguments.choice("profile", options.profile);
  if (arguments.has("crf")) options.crf = static_cast<int>(arguments.integer("crf"));
  options.hold = arguments.number("hold", options.hold);
  options.fallback = arguments.flag("fallback");
  return options;
}

}  // namespace hackle
