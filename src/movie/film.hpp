// SPDX-License-Identifier: MIT
// The file of a movie as it grows, frame by frame.
#pragma once

#include "base/image.hpp"

namespace hackle {

// Writes the partial file of a path. What it has written stays playable, up to about the last
// second, when the program is killed.
class Film {
 public:
  virtual ~Film() = default;

  // Frame k is shown at k/fps, or at the tick of the kind next to it. What is transparent lies on
  // black. Throws Error (files) when it cannot be written.
  virtual void add(const Image& image) = 0;
  // The same as add() for an image that is the one before.
  virtual void repeat(const Image& last) { add(last); }
  // Completes the partial file. Once only. Throws Error (files).
  virtual void finish() = 0;
};

}  // namespace hackle
