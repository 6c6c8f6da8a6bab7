// SPDX-License-Identifier: MIT
#include "render/plate_painter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/units.hpp"
#include "render/colour_map.hpp"
#include "render/gl_context.hpp"
#include "render/gl_functions.hpp"
#include "render/layout.hpp"
#include "render/overlay.hpp"
#include "render/shader_program.hpp"

namespace hackle {
namespace {

// A texture that is read texel by texel.
class Texture {
 public:
  Texture() {
    glGenTextures(1, &id_);
    glBindTexture(GL_TEXTURE_2D, id_);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
      glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
      glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
  }
  ~Texture() { glDeleteTextures(1, &id_); }
  Texture(const Texture&) = delete;
  Texture& operator=(const Texture&) = delete;

  void bind() const { glBindTexture(GL_TEXTURE_2D, id_); }

 private:
  GLuint id_ = 0;
};

constexpr GLint field_unit = 0, colour_map_unit = 1, damage_unit = 2;

void check(const Grid& grid) {
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
  if (grid.nx <= most && grid.ny <= most) return;
  throw Error(ErrorKind::refused,
              fmt::format("a picture of {} x {} nodes is not possible: OpenGL takes {} a side",
                          grid.nx, grid.ny, most));
}

Window window_of(const PictureStyle& style) {
  return style.window.value_or(Window{0, 0, style.grid.nx, style.grid.ny});
}

// As the colour bar has it: with the prefix that suits its larger end.
PrefixedUnit unit_of(const PictureStyle& style) {
  return prefixed(std::max(std::abs(style.least), std::abs(style.most)), style.unit);
}

std::string bar_label(const PictureStyle& style) {
  return style.unit.empty()
             ? style.label
             : fmt::format("{} ({})", style.label, printed_unit(unit_of(style).name));
}

OverlayText text_of(const PictureStyle& style) {
  const PrefixedUnit unit = unit_of(style);
  OverlayText text;
  text.parts = style.overlay;
  text.title = style.title;
  text.note = style.note;
  text.slow_motion = style.slow_motion;
  text.label = bar_label(style);
  text.least = style.least / unit.factor;
  text.most = style.most / unit.factor;
  text.logarithmic = style.logarithmic;
  text.background = style.background;
  return text;
}

// Premultiplied by its opacity.
std::array<float, 4> background_of(const PictureStyle& style) {
  const Theme& theme = theme_of(style.background);
  const auto opacity = static_cast<float>(theme.opacity);
  const auto part = [&](std::uint8_t colour) { return opacity * colour / 255.0F; };
  const Colour c = theme.background;
  return {part(c.red), part(c.green), part(c.blue), opacity};
}

ColourMap map_of(const PictureStyle& style) {
  if (style.colour_map == fringes_name) return fringe_map(style.least, style.most);
  return load_colour_map(style.colour_map);
}

}  // namespace

Layout layout_of(const PictureStyle& style) {
  if (style.bare_height > 0) return bare_layout(style.width, style.bare_height);
  return make_layout(part(style.grid, window_of(style)), style.width, text_of(style));
}

struct PlatePainter::Parts {
  explicit Parts(PictureStyle style_)
      : style(std::move(style_)),
        seen(part(style.grid, window_of(style))),
        layout(layout_of(style)),
        map(map_of(style)),
        overlay(layout, text_of(style), map, seen),
        context(layout.width, layout.height),
        gl(load_gl_functions()),
        program(gl, "field") {
    check(style.grid);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.GenVertexArrays(1, &no_vertices);  // core profile wants one bound, even without attributes
    gl.BindVertexArray(no_vertices);
    gl.ActiveTexture(GL_TEXTURE0 + colour_map_unit);
    colours.bind();
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, static_cast<GLsizei>(map.colours.size()), 1, 0, GL_RGB,
                 GL_UNSIGNED_BYTE, map.colours.data());
    program.use();
    gl.Uniform1i(program.uniform("field"), field_unit);
    gl.Uniform1i(program.uniform("damage"), damage_unit);
    gl.Uniform1i(program.uniform("colour_map"), colour_map_unit);
    gl.Uniform1i(program.uniform("largest"), style.sampling == Sampling::largest ? 1 : 0);
    gl.Uniform1i(program.uniform("logarithmic"), style.logarithmic ? 1 : 0);
    set_window(window_of(style));
    set_range();
    const std::array<float, 4> ground = background_of(style);
    gl.Uniform4f(program.uniform("background"), ground[0], ground[1], ground[2], ground[3]);
  }
  ~Parts() {
    context.make_current();  // the textures go to the context they came from
    gl.DeleteVertexArrays(1, &no_vertices);
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  void set_window(const Window& window) {
    gl.Uniform2f(program.uniform("origin"), static_cast<float>(window.left),
                 static_cast<float>(window.bottom));
    gl.Uniform2f(program.uniform("cells"), static_cast<float>(window.nx),
                 static_cast<float>(window.ny));
  }

  void set_range() {
    const auto end = [&](double value) {
      return static_cast<float>(style.logarithmic ? std::log(value) : value);
    };
    gl.Uniform2f(program.uniform("range"), end(style.least), end(style.most));
  }

  void set_values(GLint unit, const Texture& texture, const std::vector<float>& numbers) {
    gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    texture.bind();
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, style.grid.nx, style.grid.ny, 0, GL_RED, GL_FLOAT,
                 numbers.data());
  }

  void draw_field(const Shot& shot) {
    set_values(field_unit, values, shot.values);
    if (!shot.gaps.empty()) set_values(damage_unit, gaps, shot.gaps);
    gl.Uniform1i(program.uniform("gaps"), shot.gaps.empty() ? 0 : 1);
    glDisable(GL_SCISSOR_TEST);
    const std::array<float, 4> ground = background_of(style);
    glClearColor(ground[0], ground[1], ground[2], ground[3]);
    glClear(GL_COLOR_BUFFER_BIT);
    // OpenGL counts rows from the bottom.
    glViewport(layout.plate.x, layout.height - layout.plate.bottom(), layout.plate.width,
               layout.plate.height);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }

  PictureStyle style;
  Grid seen;
  Layout layout;
  ColourMap map;
  Overlay overlay;
  GlContext context;  // before everything that lives in it
  GlFunctions gl;
  ShaderProgram program;
  Texture values, gaps, colours;
  GLuint no_vertices = 0;
};

PlatePainter::PlatePainter(PictureStyle style) : parts_(std::make_unique<Parts>(std::move(style))) {
}
PlatePainter::~PlatePainter() = default;

int PlatePainter::width() const {
  return parts_->layout.width;
}
int PlatePainter::height() const {
  return parts_->layout.height;
}

Image PlatePainter::paint(const Shot& shot) {
  parts_->context.make_current();
  parts_->draw_field(shot);
  Image image = parts_->context.finish();
  parts_->overlay.draw(image, {shot.time, shot.discs, shot.load_curve, shot.energy});
  return image;
}

}  // namespace hackle
