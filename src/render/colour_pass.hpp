// SPDX-License-Identifier: MIT
// Values into colours, on the graphics library.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "render/colour_map.hpp"
#include "render/gl_objects.hpp"
#include "render/shader_program.hpp"

namespace hackle {

// How values become colours.
struct Colouring {
  ColourMap map;
  double least = 0.0, most = 1.0;  // values at its ends
  bool logarithmic = false;
  std::array<float, 4>
      background{};  // where a value is nan: red, green, blue, alpha; premultiplied
};

class ColourPass {
 public:
  ColourPass(const GlFunctions& gl, const Colouring& colouring);

  // Draws `width` x `height` values, rows from the bottom, into colours(). `gaps` is damage in
  // 255ths, to be seen as gaps, or nothing. Leaves its framebuffer and its program bound.
  void paint(int width, int height, std::span<const float> values,
             std::span<const std::uint8_t> gaps);

  const Texture& colours() const { return colours_; }
  // That colours() is the pixels of.
  const Framebuffer& framebuffer() const { return framebuffer_; }

 private:
  const GlFunctions& gl_;
  ShaderProgram program_;
  VertexArray triangle_;
  Texture map_, values_, gaps_, colours_;
  Framebuffer framebuffer_;
  int width_ = 0, height_ = 0;  // of colours_
};

}  // namespace hackle
