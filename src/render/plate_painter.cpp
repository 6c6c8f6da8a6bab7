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
PrefixedUnit unit_of(const FieldStyle& field) {
  return prefixed(std::max(std::abs(field.least), std::abs(field.most)), field.unit);
}

std::string bar_label(const FieldStyle& field) {
  return field.unit.empty()
             ? field.label
             : fmt::format("{} ({})", field.label, printed_unit(unit_of(field).name));
}

BarText bar_of(const FieldStyle& field) {
  const double unit = unit_of(field).factor;
  return {bar_label(field), field.least / unit, field.most / unit, field.logarithmic};
}

OverlayText text_of(const PictureStyle& style) {
  OverlayText text;
  text.parts = style.overlay;
  text.title = style.title;
  text.note = style.note;
  text.slow_motion = style.slow_motion;
  text.bars = {bar_of(style.field)};
  if (style.second) text.bars.push_back(bar_of(*style.second));
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

ColourMap map_of(const FieldStyle& field) {
  if (field.colour_map == fringes_name) return fringe_map(field.least, field.most);
  return load_colour_map(field.colour_map);
}

std::vector<ColourMap> maps_of(const PictureStyle& style) {
  std::vector<ColourMap> maps{map_of(style.field)};
  if (style.second) maps.push_back(map_of(*style.second));
  return maps;
}

Colouring colouring_of(const FieldStyle& field) {
  return {map_of(field), field.least, field.most, field.logarithmic};
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

Layout layout_of(const PictureStyle& style) {
  if (style.bare_height > 0) return bare_layout(style.width, style.bare_height);
  return make_layout(part(style.grid, window_of(style)), style.width, text_of(style));
}

struct PlatePainter::Parts {
  explicit Parts(PictureStyle style_)
      : style(std::move(style_)),
        layout(layout_of(style)),
        overlay(layout, text_of(style), maps_of(style),
                camera(window_of(style)).pixels_a_metre().x()),
        context(layout.width, layout.height),
        colour_pass(gl, background_of(style), colouring_of(style.field)) {
    if (style.second) colour_pass.set_second(colouring_of(*style.second), style.arrangement);
    if (needs_mesh(style)) mesh_pass.emplace(gl, layout.plate.width, layout.plate.height);
  }
  ~Parts() { context.make_current(); }  // its objects go to the context they came from
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  Camera camera(const Window& window) const {
    return {style.grid, window, style.rotation, layout.plate};
  }

  void draw_field(const Shot& shot, const Window& window) {
    if (mesh_pass)
      draw_mesh(shot, window);
    else
      draw_cells(shot, window);
  }

  void draw_cells(const Shot& shot, const Window& window) {
    const int width = points_for(window.nx, layout.plate.width);
    const int height = points_for(window.ny, layout.plate.height);
    colour_pass.paint(points_of(shot, window, width, height));
    copy_to_picture(colour_pass.framebuffer(), width, height);
  }

  void draw_mesh(const Shot& shot, const Window& window) {
    const Displaced displaced{shot.displacement, shot.links, style.magnification};
    Window cells = seen_cells(window, style.rotation, style.grid, displaced);
    const Blocks blocks = blocks_of(cells, window, layout.plate.width, layout.plate.height);
    cells.nx = blocks.columns * blocks.size;
    cells.ny = blocks.rows * blocks.size;
    Points points = points_of(shot, cells, blocks.columns, blocks.rows);
    // Single cells open where bonds are broken; blocks of them hide what is broken inside.
    if (blocks.size == 1 && !shot.links.empty()) points.gaps.clear();
    colour_pass.paint(points);
    auto places = corners(blocks, cells, style.grid, displaced, camera(window));
    hide_void(points.values, places);
    mesh_pass->paint(blocks, places, colour_pass.colours(), background_of(style));
    copy_to_picture(mesh_pass->framebuffer(), layout.plate.width, layout.plate.height);
  }

  // Spread evenly over the window.
  Points points_of(const Shot& shot, const Window& window, int width, int height) const {
    Points points{width, height, {}, {}, {}, {}};
    points.values = samples(shot.values, style.grid, window, width, height, style.field.sampling);
    if (style.second)
      points.second =
          samples(shot.second, style.grid, window, width, height, style.second->sampling);
    if (!shot.gaps.empty()) points.gaps = samples(shot.gaps, style.grid, window, width, height);
    points.middle = {width * (0.5 * style.grid.nx - window.left) / window.nx,
                     height * (0.5 * style.grid.ny - window.bottom) / window.ny};
    return points;
  }

  // What has no value has no size.
  static void hide_void(const std::vector<float>& values, std::vector<float>& places) {
    for (std::size_t block = 0; block < values.size(); ++block)
      if (std::isnan(values[block]))
        std::fill_n(places.begin() + static_cast<std::ptrdiff_t>(8 * block), 8, 0.0F);
  }

  // All `width` x `height` px of it, to where the plate is.
  void copy_to_picture(const Framebuffer& from, int width, int height) {
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, from.id());
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, context.target());
    const auto [red, green, blue, alpha] = background_of(style);
    gl.ClearColor(red, green, blue, alpha);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    const Rectangle& plate = layout.plate;
    const int below = layout.height - plate.bottom();  // OpenGL counts rows from the bottom
    gl.BlitFramebuffer(0, 0, width, height, plate.x, below, plate.right(), below + plate.height,
                       GL_COLOR_BUFFER_BIT, GL_NEAREST);
  }

  PictureStyle style;
  Layout layout;
  Overlay overlay;
  GlContext context;  // before everything that lives in it
  const GlFunctions& gl = context.functions();
  ColourPass colour_pass;
  std::optional<MeshPass> mesh_pass;
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
  const Window window = shot.window.value_or(window_of(parts_->style));
  parts_->context.make_current();
  parts_->draw_field(shot, window);
  Image image = parts_->context.finish();
  parts_->overlay.draw(image, parts_->camera(window),
                       {shot.time, shot.discs, shot.load_curve, shot.energy});
  return image;
}

}  // namespace hackle
