// SPDX-License-Identifier: MIT
// Turns the values of one field, or of two, into colours on the graphics library.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/colour_map.hpp"
#include "render/gl/gl_objects.hpp"
#include "render/gl/shader_program.hpp"
#include "render/picture_style.hpp"
#include "scene/vec2.hpp"

namespace hackle {

// The mapping from values to colours.
struct Colouring {
  ColourMap map;
  double min = 0.0, max = 1.0;  // values at its ends
  bool logarithmic = false;
};

// Numbers in rows from the bottom.
struct Points {
  int width = 0, height = 0;
  std::vector<float> values, second;  // nan without material; second may be empty
  std::vector<std::uint8_t> gaps;     // damage in 1/255, shown as gaps; may be empty
  Vec2 middle{0, 0};                  // where the halves of the plate meet, in points
};

class ColourPass {
 public:
  // `background` shows where a value is nan, `gap` in cracks: premultiplied red, green, blue and
  // alpha.
  ColourPass(const GlFunctions& gl, const std::array<float, 4>& background,
             const std::array<float, 4>& gap, const Colouring& colouring);
  // Changes the colours of the first values of points from now on.
  void set_first(const Colouring& colouring);
  // Also shows the second values of points from now on.
  void set_second(const Colouring& colouring, Arrangement arrangement);

  // Draws the points into colours(). Its framebuffer and its program stay bound.
  void paint(const Points& points);
  // Draws the points straight into a framebuffer, the lower left one at x, y px.
  void paint(const Points& points, GLuint framebuffer, int x, int y);

  const Texture& colours() const { return colours_; }
  // Returns the framebuffer that draws into colours().
  const Framebuffer& framebuffer() const { return framebuffer_; }

 private:
  void set_colouring(const Colouring& colouring, const Texture& map, const char* range,
                     const char* logarithmic);

  const GlFunctions& gl_;
  ShaderProgram program_;
  VertexArray triangle_;
  Texture map_, values_, second_map_, second_, gaps_, colours_;
  Framebuffer framebuffer_;
  int width_ = 0, height_ = 0;  // of colours_
};

}  // namespace hackle
