// SPDX-License-Identifier: MIT
// Draws displaced cells, anti-aliased, on the graphics library.
#pragma once

#include <array>
#include <span>

#include "render/gl/gl_objects.hpp"
#include "render/gl/shader_program.hpp"
#include "render/quadrilaterals.hpp"

namespace hackle {

class MeshPass {
 public:
  // Makes a pass for a part of the picture of this size, px.
  MeshPass(const GlFunctions& gl, int width, int height);

  // Draws the quadrilaterals in the colours of their blocks, one texel each, over `background` into
  // framebuffer().
  void paint(std::span<const MeshVertex> vertices, const Texture& colours,
             const std::array<float, 4>& background);

  // Has several samples per pixel: it must be copied into the picture.
  const Framebuffer& framebuffer() const { return framebuffer_; }

 private:
  const GlFunctions& gl_;
  int width_, height_;
  ShaderProgram program_;
  VertexArray vertices_;
  Framebuffer framebuffer_;
};

}  // namespace hackle
