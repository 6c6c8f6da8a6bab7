// SPDX-License-Identifier: MIT
// Pictures for movies.
#pragma once

#include <cstdint>
#include <random>

#include "base/image.hpp"
#include "movie/movie_format.hpp"

namespace hackle::test {

inline Image plain(int width, int height, std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
  Image image(width, height);
  for (std::size_t at = 0; at < image.pixels.size(); at += 4) {
    image.pixels[at] = blue;
    image.pixels[at + 1] = green;
    image.pixels[at + 2] = red;
    image.pixels[at + 3] = 255;
  }
  return image;
}

// Makes a square that moves by a pixel per frame, with its first column at 10 + frame.
inline Image moving(int width, int height, int frame) {
  Image image = plain(width, height, 20, 30, 50);
  for (int y = 10; y < 40; ++y)
    for (int x = 10 + frame; x < 40 + frame; ++x) {
      auto* pixel = &image.pixels[static_cast<std::size_t>(y * image.stride() + 4 * x)];
      pixel[0] = pixel[1] = pixel[2] = 240;
    }
  return image;
}

// Makes the hardest picture: every pixel has a random colour, or a random grey of a few levels.
inline Image noise(int width, int height, unsigned seed, bool grey = false) {
  std::mt19937 random(seed);
  Image image(width, height);
  for (std::size_t at = 0; at < image.pixels.size(); at += 4) {
    const auto level = static_cast<std::uint8_t>(random() % 60 * 4);
    for (std::size_t c = 0; c < 3; ++c)
      image.pixels[at + c] = grey ? level : static_cast<std::uint8_t>(random());
    image.pixels[at + 3] = 255;
  }
  return image;
}

inline MovieFormat format(int width, int height, double fps = 30.0) {
  MovieFormat format{width, height};
  format.fps = fps;
  return format;
}

}  // namespace hackle::test
