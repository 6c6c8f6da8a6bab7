// SPDX-License-Identifier: MIT
#include "render/plate_painter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/units.hpp"
#include "render/camera.hpp"
#include "render/cell_mesh.hpp"
#include "render/colour_map.hpp"
#include "render/colour_pass.hpp"
#include "render/gl_context.hpp"
#include "render/layout.hpp"
#include "render/mesh_pass.hpp"
#include "render/overlay.hpp"
#include "render/samples.hpp"

namespace hackle {
namespace {

Window window_of(const PictureStyle& style) {
  return style.window.value_or(Window{0, 0, style.grid.nx, style.grid.ny});
}

// As the colour bar has it: with the prefix that suits its larger end.
PrefixedUnit unit_of(const PictureStyle& style) {
  return prefixed(std::max(std::abs(style.least), std::abs(style.most)), style.unit);
}

std::string bar_label(const PictureStyle& style) {
  return style.unit.empty() ? style.label
                            : fmt::format("{} ({})", style.label, unit_of(style).name);
}

Layout layout_of(const PictureStyle& style, const Grid& seen) {
  if (style.bare_height > 0) return bare_layout(style.width, style.bare_height);
  return make_layout(seen, style.width, label_ems(bar_label(style)));
}

ColourMap map_of(const PictureStyle& style) {
  if (style.colour_map == fringes_name) return fringe_map(style.least, style.most);
  return load_colour_map(style.colour_map);
}

std::array<float, 4> background_of(const PictureStyle& style) {
  if (style.background == Background::transparent) return {0.0F, 0.0F, 0.0F, 0.0F};
  return {background_colour.red / 255.0F, background_colour.green / 255.0F,
          background_colour.blue / 255.0F, 1.0F};
}

Colouring colouring_of(const PictureStyle& style, const ColourMap& map) {
  return {map, style.least, style.most, style.logarithmic, background_of(style)};
}

// Whether cells are not all rectangles of the same size.
bool needs_mesh(const PictureStyle& style) {
  return style.magnification > 0.0 || style.rotation != 0.0;
}

// How many points show so many cells on so many pixels: one a cell where cells are whole pixels.
int points_for(int cells, int pixels) {
  return pixels % cells == 0 ? cells : pixels;
}

}  // namespace

struct PlatePainter::Parts {
  explicit Parts(PictureStyle style_)
      : style(std::move(style_)),
        seen(part(style.grid, window_of(style))),
        layout(layout_of(style, seen)),
        map(map_of(style)),
        context(layout.width, layout.height),
        colour_pass(gl, colouring_of(style, map)) {
    if (needs_mesh(style)) mesh_pass.emplace(gl, layout.plate.width, layout.plate.height);
  }
  ~Parts() { context.make_current(); }  // its objects go to the context they came from
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  void draw_field(const Shot& shot) {
    const Window window = shot.window.value_or(window_of(style));
    if (mesh_pass)
      draw_mesh(shot, window);
    else
      draw_cells(shot, window);
    copy_to_picture();
  }

  void draw_cells(const Shot& shot, const Window& window) {
    width = points_for(window.nx, layout.plate.width);
    height = points_for(window.ny, layout.plate.height);
    colour_pass.paint(width, height,
                      samples(shot.values, style.grid, window, width, height, style.sampling),
                      gaps(shot, window));
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, colour_pass.framebuffer().id());
  }

  void draw_mesh(const Shot& shot, const Window& window) {
    const Displaced displaced{shot.displacement, shot.links, style.magnification};
    Window cells = seen_cells(window, style.rotation, style.grid, displaced);
    const Blocks blocks = blocks_of(cells, window, layout.plate.width, layout.plate.height);
    cells.nx = blocks.columns * blocks.size;
    cells.ny = blocks.rows * blocks.size;
    width = blocks.columns;
    height = blocks.rows;
    const auto values = samples(shot.values, style.grid, cells, width, height, style.sampling);
    // Single cells open where bonds are broken; blocks of them hide what is broken inside.
    const bool opens = blocks.size == 1 && !shot.links.empty();
    colour_pass.paint(width, height, values,
                      opens ? std::vector<std::uint8_t>() : gaps(shot, cells));
    auto places = corners(blocks, cells, style.grid, displaced,
                          Camera(style.grid, window, style.rotation, layout.plate));
    hide_void(values, places);
    mesh_pass->paint(blocks, places, colour_pass.colours(), background_of(style));
    width = layout.plate.width;
    height = layout.plate.height;
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, mesh_pass->framebuffer().id());
  }

  std::vector<std::uint8_t> gaps(const Shot& shot, const Window& window) const {
    if (shot.gaps.empty()) return {};
    return samples(shot.gaps, style.grid, window, width, height);
  }

  // What has no value has no size.
  static void hide_void(const std::vector<float>& values, std::vector<float>& places) {
    for (std::size_t block = 0; block < values.size(); ++block)
      if (std::isnan(values[block]))
        std::fill_n(places.begin() + static_cast<std::ptrdiff_t>(8 * block), 8, 0.0F);
  }

  // From the framebuffer that is read, of `width` x `height`, to where the plate is.
  void copy_to_picture() {
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, context.target());
    const auto [red, green, blue, alpha] = background_of(style);
    gl.ClearColor(red, green, blue, alpha);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    const Rectangle& plate = layout.plate;
    const int below = layout.height - plate.bottom();  // OpenGL counts rows from the bottom
    gl.BlitFramebuffer(0, 0, width, height, plate.x, below, plate.right(), below + plate.height,
                       GL_COLOR_BUFFER_BIT, GL_NEAREST);
  }

  OverlayText text() const {
    const PrefixedUnit unit = unit_of(style);
    OverlayText text;
    text.title = style.title;
    text.label = bar_label(style);
    text.least = style.least / unit.factor;
    text.most = style.most / unit.factor;
    text.logarithmic = style.logarithmic;
    text.metres_per_pixel = seen.nx * seen.dx / layout.plate.width;
    return text;
  }

  PictureStyle style;
  Grid seen;
  Layout layout;
  ColourMap map;
  GlContext context;  // before everything that lives in it
  const GlFunctions& gl = context.functions();
  ColourPass colour_pass;
  std::optional<MeshPass> mesh_pass;
  int width = 0, height = 0;  // of what was drawn last, px
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
  if (parts_->style.bare_height == 0) {
    draw_frame(image, parts_->layout, parts_->map, parts_->text());
    draw_time(image, parts_->layout, shot.time);
  }
  draw_discs(image, parts_->layout, parts_->seen, shot.discs);
  return image;
}

}  // namespace hackle
