// SPDX-License-Identifier: MIT
#include "render/colour_pass.hpp"

#include <cmath>

namespace hackle {
namespace {

constexpr GLint values_unit = 0, map_unit = 1, gaps_unit = 2;

}  // namespace

ColourPass::ColourPass(const GlFunctions& gl, const Colouring& colouring)
    : gl_(gl),
      program_(gl, "colours"),
      triangle_(gl),
      map_(gl),
      values_(gl),
      gaps_(gl),
      colours_(gl),
      framebuffer_(gl, colours_) {
  map_.set_colours(static_cast<int>(colouring.map.colours.size()), 1, colouring.map.colours.data());
  program_.use();
  gl_.Uniform1i(program_.uniform("values"), values_unit);
  gl_.Uniform1i(program_.uniform("damage"), gaps_unit);
  gl_.Uniform1i(program_.uniform("colour_map"), map_unit);
  gl_.Uniform1i(program_.uniform("logarithmic"), colouring.logarithmic ? 1 : 0);
  const auto end = [&](double value) {
    return static_cast<float>(colouring.logarithmic ? std::log(value) : value);
  };
  gl_.Uniform2f(program_.uniform("range"), end(colouring.least), end(colouring.most));
  const auto& [red, green, blue, alpha] = colouring.background;
  gl_.Uniform4f(program_.uniform("background"), red, green, blue, alpha);
}

void ColourPass::paint(int width, int height, std::span<const float> values,
                       std::span<const std::uint8_t> gaps) {
  values_.set_numbers(width, height, values.data());
  if (!gaps.empty()) gaps_.set_bytes(width, height, gaps.data());
  if (width != width_ || height != height_) colours_.make_room(width_ = width, height_ = height);
  values_.bind(values_unit);
  map_.bind(map_unit);
  gaps_.bind(gaps_unit);
  program_.use();
  gl_.Uniform1i(program_.uniform("gaps"), gaps.empty() ? 0 : 1);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  gl_.Viewport(0, 0, width, height);
  triangle_.bind();
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace hackle
