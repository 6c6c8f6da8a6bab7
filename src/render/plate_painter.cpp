// SPDX-License-Identifier: MIT
#include "render/plate_painter.hpp"

#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
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

constexpr GLint field_unit = 0, colour_map_unit = 1;

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

Layout layout_of(const PictureStyle& style, const Grid& seen) {
  if (style.bare_height > 0) return bare_layout(style.width, style.bare_height);
  return make_layout(seen, style.width);
}

}  // namespace

struct PlatePainter::Parts {
  explicit Parts(PictureStyle style_)
      : style(std::move(style_)),
        seen(part(style.grid, window_of(style))),
        layout(layout_of(style, seen)),
        map(load_colour_map(style.colour_map)),
        context(layout.width, layout.height),
        gl(load_gl_functions()),
        program(gl, "field") {
    check(style.grid);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.GenVertexArrays(1, &no_vertices);  // core profile wants one bound, even without attributes
    gl.BindVertexArray(no_vertices);
    gl.ActiveTexture(GL_TEXTURE0 + colour_map_unit);
    colours.bind();
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, 256, 1, 0, GL_RGB, GL_UNSIGNED_BYTE,
                 map.colours.data());
    program.use();
    gl.Uniform1i(program.uniform("field"), field_unit);
    gl.Uniform1i(program.uniform("colour_map"), colour_map_unit);
    set_window(window_of(style));
    gl.Uniform2f(program.uniform("range"), static_cast<float>(style.least),
                 static_cast<float>(style.most));
    gl.Uniform4f(program.uniform("background"), background_colour.red / 255.0F,
                 background_colour.green / 255.0F, background_colour.blue / 255.0F, 1.0F);
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

  void draw_field(const Field& field) {
    gl.ActiveTexture(GL_TEXTURE0 + field_unit);
    values.bind();
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, style.grid.nx, style.grid.ny, 0, GL_RED, GL_FLOAT,
                 field.values.data());
    glDisable(GL_SCISSOR_TEST);
    glClearColor(background_colour.red / 255.0F, background_colour.green / 255.0F,
                 background_colour.blue / 255.0F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    // OpenGL counts rows from the bottom.
    glViewport(layout.plate.x, layout.height - layout.plate.bottom(), layout.plate.width,
               layout.plate.height);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }

  OverlayText text_for(const Field& field) const {
    OverlayText text;
    text.title = style.title;
    text.field = field.name;
    text.unit = field.unit;
    text.least = style.least;
    text.most = style.most;
    text.metres_per_pixel = seen.nx * seen.dx / layout.plate.width;
    return text;
  }

  PictureStyle style;
  Grid seen;
  Layout layout;
  ColourMap map;
  GlContext context;  // before everything that lives in it
  GlFunctions gl;
  ShaderProgram program;
  Texture values, colours;
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

Image PlatePainter::paint(const Field& field, double time, const std::vector<Circle>& discs) {
  parts_->context.make_current();
  parts_->draw_field(field);
  Image image = parts_->context.finish();
  if (parts_->style.bare_height == 0) {
    draw_frame(image, parts_->layout, parts_->map, parts_->text_for(field));
    draw_time(image, parts_->layout, time);
  }
  draw_discs(image, parts_->layout, parts_->seen, discs);
  return image;
}

}  // namespace hackle
