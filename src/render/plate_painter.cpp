// SPDX-License-Identifier: MIT
#include "render/plate_painter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/units.hpp"
#include "render/bond_drawing.hpp"
#include "render/camera.hpp"
#include "render/cell_mesh.hpp"
#include "render/colour_map.hpp"
#include "render/gl/colour_pass.hpp"
#include "render/gl/gl_context.hpp"
#include "render/gl/mesh_pass.hpp"
#include "render/overlay/layout.hpp"
#include "render/overlay/overlay.hpp"
#include "render/samples.hpp"
#include "render/seen_range.hpp"

namespace hackle {
namespace {

Window window_of(const PictureStyle& style) {
  return style.window.value_or(Window{0, 0, style.grid.nx, style.grid.ny});
}

// The unit of the colour bar, with the prefix that suits its larger end.
PrefixedUnit unit_of(const FieldStyle& field) {
  return prefixed(std::max(std::abs(field.min), std::abs(field.max)), field.unit);
}

std::string bar_label(const FieldStyle& field) {
  return field.unit.empty()
             ? field.label
             : fmt::format("{} ({})", field.label, printed_unit(unit_of(field).name));
}

BarText bar_of(const FieldStyle& field) {
  const double unit = unit_of(field).factor;
  return {bar_label(field), field.min / unit, field.max / unit, field.logarithmic, field.whole, ""};
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

// Premultiplied by the opacity of the theme.
std::array<float, 4> with_opacity(const Theme& theme, Colour c) {
  const auto opacity = static_cast<float>(theme.opacity);
  const auto part = [&](std::uint8_t colour) { return opacity * colour / 255.0F; };
  return {part(c.red), part(c.green), part(c.blue), opacity};
}
std::array<float, 4> background_of(const PictureStyle& style) {
  const Theme& theme = theme_of(style.background);
  return with_opacity(theme, theme.background);
}
std::array<float, 4> gap_of(const PictureStyle& style) {
  const Theme& theme = theme_of(style.background);
  return with_opacity(theme, theme.gap);
}

ColourMap map_of(const FieldStyle& field) {
  if (field.colour_map == fringes_name) return fringe_map(field.min, field.max);
  return load_colour_map(field.colour_map);
}

std::vector<ColourMap> maps_of(const PictureStyle& style) {
  std::vector<ColourMap> maps{map_of(style.field)};
  if (style.second) maps.push_back(map_of(*style.second));
  return maps;
}

Colouring colouring_of(const FieldStyle& field) {
  return {map_of(field), field.min, field.max, field.logarithmic};
}

bool is_beside(const PictureStyle& style) {
  return style.second && style.arrangement == Arrangement::beside && style.bare_height == 0;
}

// Returns whether the cells are not all rectangles of equal size.
bool needs_mesh(const PictureStyle& style) {
  return style.magnification > 0.0 || style.rotation != 0.0;
}

// Number of sample points: one per cell if cells are whole pixels, else one per pixel.
int points_for(int cells, int pixels) {
  return pixels % cells == 0 ? cells : pixels;
}

}  // namespace

Layout layout_of(const PictureStyle& style) {
  if (style.bare_height > 0) return bare_layout(style.width, style.bare_height);
  return make_layout(part(style.grid, window_of(style)), style.width, text_of(style),
                     {style.cell, is_beside(style)});
}

struct PlatePainter::Parts {
  explicit Parts(PictureStyle style_)
      : style(std::move(style_)),
        layout(layout_of(style)),
        overlay(layout, text_of(style), maps_of(style),
                camera(layout.plate, window_of(style)).pixels_a_metre().x()),
        context(layout.width, layout.height),
        first_pass(gl, background_of(style), gap_of(style), colouring_of(style.field)) {
    if (is_beside(style))
      second_pass.emplace(gl, background_of(style), gap_of(style), colouring_of(*style.second));
    else if (style.second)
      first_pass.set_second(colouring_of(*style.second), style.arrangement);
    if (needs_mesh(style)) mesh_pass.emplace(gl, layout.plate.width, layout.plate.height);
  }
  ~Parts() { context.make_current(); }  // its objects are deleted in their context
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  Camera camera(const Rectangle& plate, const Window& window) const {
    return {style.grid, window, style.rotation, plate};
  }
  std::vector<Camera> cameras(const Window& window) const {
    return {camera(layout.plate, window), camera(layout.second_plate, window)};
  }

  void draw_all(const Shot& shot, const Window& window) {
    beyond.clear();
    clear_picture();
    draw_plate(first_pass, layout.plate, shot, window);
    if (second_pass) draw_plate(*second_pass, layout.second_plate, shot, window);
  }

  void draw_plate(ColourPass& pass, const Rectangle& plate, const Shot& shot,
                  const Window& window) {
    if (mesh_pass)
      draw_mesh(pass, plate, shot, window);
    else
      draw_cells(pass, plate, shot, window);
  }

  void draw_cells(ColourPass& pass, const Rectangle& plate, const Shot& shot,
                  const Window& window) {
    const int width = points_for(window.nx, plate.width);
    const int height = points_for(window.ny, plate.height);
    const Points points = points_of(pass, shot, window, width, height);
    fit_ranges(pass, points);
    if (width == plate.width && height == plate.height)
      return pass.paint(points, context.target(), plate.x, row_from_below(plate));
    pass.paint(points);
    copy_to_picture(pass.framebuffer(), width, height, plate);
  }

  void draw_mesh(ColourPass& pass, const Rectangle& plate, const Shot& shot, const Window& window) {
    const Displaced displaced{shot.displacement, shot.links, style.magnification};
    Window cells = seen_cells(window, style.rotation, style.grid, displaced);
    const Blocks blocks = blocks_of(cells, window, plate.width, plate.height);
    cells.nx = blocks.columns * blocks.size;
    cells.ny = blocks.rows * blocks.size;
    Points points = points_of(pass, shot, cells, blocks.columns, blocks.rows);
    // Single cells open where bonds are broken, so need no gaps; blocks of cells hide broken bonds
    // inside.
    if (blocks.size == 1 && !shot.links.empty()) points.gaps.clear();
    fit_ranges(pass, points);
    pass.paint(points);
    const auto places = corners(blocks, cells, style.grid, displaced, camera(plate, window));
    constexpr double tolerance = 2.0 * 0.05;  // px, in the two units of Camera::share
    mesh_pass->paint(quadrilaterals(blocks, places, points.values,
                                    {tolerance / plate.width, tolerance / plate.height}),
                     pass.colours(), background_of(style));
    copy_to_picture(mesh_pass->framebuffer(), plate.width, plate.height, plate);
  }

  // Spreads the points evenly over the window.
  Points points_of(const ColourPass& pass, const Shot& shot, const Window& window, int width,
                   int height) const {
    const auto sampled = [&](const std::vector<float>& values, const FieldStyle& field) {
      return samples(values, style.grid, window, width, height, field.sampling);
    };
    Points points{width, height, {}, {}, {}, {}};
    points.values =
        is_second(pass) ? sampled(shot.second, *style.second) : sampled(shot.values, style.field);
    if (style.second && !second_pass) points.second = sampled(shot.second, *style.second);
    if (!shot.gaps.empty()) points.gaps = samples(shot.gaps, style.grid, window, width, height);
    points.middle = {width * (0.5 * style.grid.nx - window.left) / window.nx,
                     height * (0.5 * style.grid.ny - window.bottom) / window.ny};
    return points;
  }

  bool is_second(const ColourPass& pass) const { return second_pass && &pass == &*second_pass; }

  // Widens the ranges that do not fit, and finds what still lies beyond them.
  void fit_ranges(ColourPass& pass, const Points& points) {
    if (is_second(pass)) {
      if (fit(*style.second, widened_by[1], {points.values, points.gaps}))
        second_pass->set_first(colouring_of(*style.second));
      return;
    }
    if (fit(style.field, widened_by[0], {points.values, points.gaps}))
      first_pass.set_first(colouring_of(style.field));
    if (!style.second || second_pass) return;
    if (fit(*style.second, widened_by[1], {points.second, points.gaps}))
      first_pass.set_second(colouring_of(*style.second), style.arrangement);
  }

  // Returns whether the range has changed.
  bool fit(FieldStyle& field, double& widened_so_far, const Seen& seen) {
    const double times = widening(field, seen);
    field = widened(std::move(field), times);
    widened_so_far *= times;
    beyond.push_back(hackle::beyond(field, seen));
    if (times > 1.0) bars_changed = true;
    return times > 1.0;
  }

  void update_bars() {
    if (!bars_changed) return;
    std::vector<BarText> bars = text_of(style).bars;
    for (std::size_t k = 0; k < bars.size(); ++k)
      if (widened_by[k] > 1.0) bars[k].remark = fmt::format("range × {:g}", widened_by[k]);
    overlay.set_bars(bars, maps_of(style));
    bars_changed = false;
  }

  void clear_picture() {
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, context.target());
    const auto [red, green, blue, alpha] = background_of(style);
    gl.ClearColor(red, green, blue, alpha);
    gl.Clear(GL_COLOR_BUFFER_BIT);
  }

  // OpenGL counts rows from the bottom.
  int row_from_below(const Rectangle& plate) const { return layout.height - plate.bottom(); }

  // Copies all `width` x `height` px to the position of the plate.
  void copy_to_picture(const Framebuffer& from, int width, int height, const Rectangle& plate) {
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, from.id());
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, context.target());
    const int below = row_from_below(plate);
    gl.BlitFramebuffer(0, 0, width, height, plate.x, below, plate.right(), below + plate.height,
                       GL_COLOR_BUFFER_BIT, GL_NEAREST);
  }

  void draw_lattice(Image& image, const Shot& shot, const Window& window) const {
    for (const Rectangle& plate : {layout.plate, layout.second_plate}) {
      if (plate.empty() || !style.bonds) continue;
      const Displaced displaced{shot.displacement, shot.links, style.magnification};
      Canvas canvas(image);
      draw_bonds(canvas, shot.bonds,
                 {seen_cells(window, style.rotation, style.grid, displaced), shot.values},
                 style.grid, displaced, camera(plate, window), plate);
    }
  }

  PictureStyle style;
  Layout layout;
  Overlay overlay;
  GlContext context;  // declared before everything that lives in it
  const GlFunctions& gl = context.functions();
  ColourPass first_pass;
  std::optional<ColourPass> second_pass;  // for a second plate
  std::optional<MeshPass> mesh_pass;
  std::array<double, 2> widened_by{1.0, 1.0};  // of both fields, so far
  bool bars_changed = false;
  std::vector<Beyond> beyond;  // in the picture that is being painted
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
  parts_->draw_all(shot, window);
  Image image = parts_->context.finish();
  parts_->draw_lattice(image, shot, window);
  parts_->update_bars();
  parts_->overlay.draw(image, parts_->cameras(window),
                       {shot.time, shot.discs, shot.load_curve, shot.energy, parts_->beyond});
  return image;
}

}  // namespace hackle
