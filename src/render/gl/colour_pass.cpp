// SPDX-License-Identifier: MIT
#include "render/gl/colour_pass.hpp"

#include <cmath>

namespace hackle {
namespace {

// Texture units, in the order of the samplers.
enum Unit : GLint { values_unit, second_unit, gaps_unit, map_unit, second_map_unit };
constexpr std::array samplers{"values", "second", "damage", "colour_map", "second_map"};

}  // namespace

ColourPass::ColourPass(const GlFunctions& gl, const std::array<float, 4>& background,
                       const std::array<float, 4>& gap, const Colouring& colouring)
    : gl_(gl),
      program_(gl, "colours"),
      triangle_(gl),
      map_(gl),
      values_(gl),
      second_map_(gl),
      second_(gl),
      gaps_(gl),
      colours_(gl),
      framebuffer_(gl, colours_) {
  program_.use();
  for (std::size_t unit = 0; unit < samplers.size(); ++unit)
    gl_.Uniform1i(program_.uniform(samplers[unit]), static_cast<GLint>(unit));
  gl_.Uniform4f(program_.uniform("background"), background[0], background[1], background[2],
                background[3]);
  gl_.Uniform4f(program_.uniform("gap_colour"), gap[0], gap[1], gap[2], gap[3]);
  gl_.Uniform1i(program_.uniform("arrangement"), 0);
  set_first(colouring);
}

void ColourPass::set_first(const Colouring& colouring) {
  program_.use();
  set_colouring(colouring, map_, "range", "logarithmic");
}

void ColourPass::set_second(const Colouring& colouring, Arrangement arrangement) {
  program_.use();
  gl_.Uniform1i(program_.uniform("arrangement"), 1 + static_cast<GLint>(arrangement));
  set_colouring(colouring, second_map_, "second_range", "second_logarithmic");
}

void ColourPass::set_colouring(const Colouring& colouring, const Texture& map, const char* range,
                               const char* logarithmic) {
  map.set_colours(static_cast<int>(colouring.map.colours.size()), 1, colouring.map.colours.data());
  const auto end = [&](double value) {
    return static_cast<float>(colouring.logarithmic ? std::log(value) : value);
  };
  gl_.Uniform2f(program_.uniform(range), end(colouring.min), end(colouring.max));
  gl_.Uniform1i(program_.uniform(logarithmic), colouring.logarithmic ? 1 : 0);
}

void ColourPass::paint(const Points& points) {
  if (points.width != width_ || points.height != height_)
    colours_.make_room(width_ = points.width, height_ = points.height);
  paint(points, framebuffer_.id(), 0, 0);
}

void ColourPass::paint(const Points& points, GLuint framebuffer, int x, int y) {
  const int width = points.width, height = points.height;
  values_.set_numbers(width, height, points.values.data());
  if (!points.second.empty()) second_.set_numbers(width, height, points.second.data());
  if (!points.gaps.empty()) gaps_.set_bytes(width, height, points.gaps.data());
  values_.bind(values_unit);
  second_.bind(second_unit);
  gaps_.bind(gaps_unit);
  map_.bind(map_unit);
  second_map_.bind(second_map_unit);
  program_.use();
  gl_.Uniform1i(program_.uniform("gaps"), points.gaps.empty() ? 0 : 1);
  gl_.Uniform2f(program_.uniform("split"), static_cast<float>(points.middle.x()),
                static_cast<float>(points.middle.y()));
  gl_.Uniform2f(program_.uniform("corner"), static_cast<float>(x), static_cast<float>(y));
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl_.Viewport(x, y, width, height);
  triangle_.bind();
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace hackle
