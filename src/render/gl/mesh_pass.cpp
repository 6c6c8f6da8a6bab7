// SPDX-License-Identifier: MIT
#include "render/gl/mesh_pass.hpp"

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

void MeshPass::paint(std::span<const MeshVertex> vertices, const Texture& colours,
                     const std::array<float, 4>& background) {
  static_assert(sizeof(MeshVertex) == 8 * sizeof(float));
  vertices_.set_vertices({reinterpret_cast<const float*>(vertices.data()), 8 * vertices.size()},
                         {2, 2, 4});
  const std::vector<std::uint32_t> order = triangles(vertices.size() / 4);
  vertices_.set_order(order);
  colours.bind(colours_unit);
  program_.use();
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  gl_.Viewport(0, 0, width_, height_);
  gl_.ClearColor(background[0], background[1], background[2], background[3]);
  gl_.Clear(GL_COLOR_BUFFER_BIT);
  gl_.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(order.size()), GL_UNSIGNED_INT, nullptr);
}

}  // namespace hackle
