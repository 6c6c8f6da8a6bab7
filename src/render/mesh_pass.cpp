// SPDX-License-Identifier: MIT
#include "render/mesh_pass.hpp"

namespace hackle {
namespace {

constexpr int samples_a_pixel = 4;
constexpr GLint colours_unit = 0;

}  // namespace

MeshPass::MeshPass(const GlFunctions& gl, int width, int height)
    : gl_(gl),
      width_(width),
      height_(height),
      program_(gl, "cells"),
      vertices_(gl),
      framebuffer_(gl, width, height, samples_a_pixel) {
  program_.use();
  gl_.Uniform1i(program_.uniform("colours"), colours_unit);
}

void MeshPass::paint(const Blocks& blocks, std::span<const float> corners, const Texture& colours,
                     const std::array<float, 4>& background) {
  if (ordered_ != blocks.count()) vertices_.set_order(triangles(blocks));
  ordered_ = blocks.count();
  vertices_.set_places(corners);
  colours.bind(colours_unit);
  program_.use();
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  gl_.Viewport(0, 0, width_, height_);
  gl_.ClearColor(background[0], background[1], background[2], background[3]);
  gl_.Clear(GL_COLOR_BUFFER_BIT);
  gl_.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(6 * blocks.count()), GL_UNSIGNED_INT,
                   nullptr);
}

}  // namespace hackle
