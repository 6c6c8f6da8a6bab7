// SPDX-License-Identifier: MIT
// The file of a movie as it grows, frame by frame.
#pragma once

#include "base/image.hpp"

namespace hackle {

// Writes the partial file of a path. If the program is killed, the written part stays playable up
// to about the last second.
class Film {
 public:
  virtual ~Film() = default;

  // Adds frame k, shown at k/fps or the nearest tick of the kind. Transparent pixels are laid on
  // black. Throws Error (files) if it cannot be written.
  virtual void add(const Image& image) = 0;
  // Like add(), for an image equal to the previous one.
  virtual void repeat(const Image& last) { add(last); }
  // Completes the partial file. Call it only once. Throws Error (files).
  virtual void finish() = 0;
};

}  // namespace hackle
