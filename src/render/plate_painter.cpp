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
#include "render/gl/colour_pass.hpp"
#include "render/gl/gl_context.hpp"
#include "render/gl/mesh_pass.hpp"
#include "render/interpolation.hpp"
#include "render/overlay/layout.hpp"
#include "render/overlay/overlay.hpp"
#include "render/samples.hpp"
#include "render/seen_range.hpp"
#include "render/style_text.hpp"
#include "render/vector_file.hpp"

namespace hackle {
namespace {

Window window_of(const PictureStyle& style) {
  return style.window.value_or(Window{0, 0, style.grid.nx, style.grid.ny});
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

Colouring colouring_of(const FieldStyle& field) {
  return {colour_map_of(field), field.min, field.max, field.logarithmic};
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
  return make_layout(part(style.grid, window_of(style)), style.width, overlay_text_of(style),
                     {style.cell, is_beside(style)});
}

struct PlatePainter::Parts {
  explicit Parts(PictureStyle style_)
      : style(std::move(style_)),
        layout(layout_of(style)),
        overlay(layout, overlay_text_of(style), colour_maps_of(style),
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
    const bool smooth = is_smooth(plate, window);
    const int width = smooth ? plate.width : points_for(window.nx, plate.width);
    const int height = smooth ? plate.height : points_for(window.ny, plate.height);
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

  bool is_smooth(const Rectangle& plate, const Window& window) const {
    return style.smooth && plate.width > window.nx && plate.height > window.ny;
  }

  // Spreads the points evenly over the window.
  Points points_of(const ColourPass& pass, const Shot& shot, const Window& window, int width,
                   int height) const {
    const bool smooth = !mesh_pass && is_smooth({0, 0, width, height}, window);
    const auto sampled = [&](const std::vector<float>& values, const FieldStyle& field) {
      if (smooth) return interpolated(values, shot.links, style.grid, window, width, height);
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

  Window window_for(const Shot& shot) {
    if (shot.window) return *shot.window;
    if (style.encloses && !shot.displacement.empty()) enclose(shot);
    return window_of(style);
  }

  // Grows the window by halves until it contains all nodes that are joined to others.
  void enclose(const Shot& shot) {
    const Window before = window_of(style);
    Window window = before;
    const int most = 10 * std::max(style.grid.nx, style.grid.ny);
    while (leaves(shot, window) && std::max(window.nx, window.ny) < most)
      window = {window.left - window.nx / 4, window.bottom - window.ny / 4,
                window.nx + 2 * (window.nx / 4), window.ny + 2 * (window.ny / 4)};
    if (window.nx != before.nx) set_window(window);
  }

  void set_window(const Window& window) {
    style.window = window;
    overlay.set_scale(camera(layout.plate, window).pixels_a_metre().x());
  }

  bool leaves(const Shot& shot, const Window& window) const {
    const Camera seen = camera(layout.plate, window);
    const double cells_a_metre = style.magnification / style.grid.dx;
    for (int j = 0; j < style.grid.ny; ++j)
      for (int i = 0; i < style.grid.nx; ++i) {
        const std::size_t node = style.grid.index(i, j);
        if (shot.links[node] == 0) continue;
        const Vec2 u(shot.displacement[2 * node], shot.displacement[2 * node + 1]);
        if (seen.share(Vec2(i + 0.5, j + 0.5) + cells_a_metre * u).cwiseAbs().maxCoeff() > 1.0)
          return true;
      }
    return false;
  }

  bool is_second(const ColourPass& pass) const { return second_pass && &pass == &*second_pass; }

  // Widens the ranges that do not fit, and finds what still lies beyond them.
  void fit_ranges(ColourPass& pass, const Points& points) {
    if (is_second(pass)) {
      if (fit(*style.second, widened_by[1], {points.values, points.gaps})) recolour_second();
      return;
    }
    if (fit(style.field, widened_by[0], {points.values, points.gaps})) recolour_first();
    if (!style.second || second_pass) return;
    if (fit(*style.second, widened_by[1], {points.second, points.gaps})) recolour_second();
  }

  void recolour_first() {
    first_pass.set_first(colouring_of(style.field));
    bars_changed = true;
  }
  void recolour_second() {
    if (second_pass)
      second_pass->set_first(colouring_of(*style.second));
    else
      first_pass.set_second(colouring_of(*style.second), style.arrangement);
    bars_changed = true;
  }

  Adaptation::Range range(int field) const {
    const FieldStyle& shown = field == 0 || !style.second ? style.field : *style.second;
    return {shown.min, shown.max, widened_by[static_cast<std::size_t>(field)]};
  }

  void adapt(const Adaptation& adaptation) {
    set_window(adaptation.window);
    const auto take = [&](FieldStyle& field, std::size_t k) {
      field.min = adaptation.ranges[k].min;
      field.max = adaptation.ranges[k].max;
      widened_by[k] = adaptation.ranges[k].widened_by;
    };
    context.make_current();
    take(style.field, 0);
    recolour_first();
    if (!style.second) return;
    take(*style.second, 1);
    recolour_second();
  }

  // Returns whether the range has changed.
  bool fit(FieldStyle& field, double& widened_so_far, const Seen& seen) {
    const double times = widening(field, seen);
    field = widened(std::move(field), times);
    widened_so_far *= times;
    beyond.push_back(hackle::beyond(field, seen));
    return times > 1.0;
  }

  void update_bars() {
    if (!bars_changed) return;
    std::vector<BarText> bars = overlay_text_of(style).bars;
    for (std::size_t k = 0; k < bars.size(); ++k)
      if (widened_by[k] > 1.0) bars[k].remark = fmt::format("range × {:g}", widened_by[k]);
    overlay.set_bars(bars, colour_maps_of(style));
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

  // Paints the plates, with nothing on them or around them.
  Image painted(const Shot& shot, const Window& window) {
    context.make_current();
    draw_all(shot, window);
    update_bars();
    return context.finish();
  }

  Moment moment(const Shot& shot) const {
    return {shot.time, shot.discs, shot.load_curve, shot.energy, beyond, shot.boxes, shot.cracks};
  }

  void draw_page(Canvas& canvas, const Image& plates, const Shot& shot, const Window& window) {
    const Theme& theme = theme_of(style.background);
    canvas.colour(theme.background, theme.opacity);
    canvas.fill(0, 0, layout.width, layout.height);
    for (const Rectangle& plate : {layout.plate, layout.second_plate})
      canvas.copy(plates, plate, plate.x, plate.y);
    draw_lattice(canvas, shot, window);
    overlay.draw(canvas, cameras(window), moment(shot));
  }

  void draw_lattice(Canvas& canvas, const Shot& shot, const Window& window) const {
    for (const Rectangle& plate : {layout.plate, layout.second_plate}) {
      if (plate.empty() || !style.bonds) continue;
      const Displaced displaced{shot.displacement, shot.links, style.magnification};
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
const std::vector<Beyond>& PlatePainter::beyond() const {
  return parts_->beyond;
}

Image PlatePainter::paint(const Shot& shot) {
  const Window window = parts_->window_for(shot);
  Image image = parts_->painted(shot, window);
  if (parts_->style.bonds) {
    Canvas canvas(image);
    parts_->draw_lattice(canvas, shot, window);
  }
  parts_->overlay.draw(image, parts_->cameras(window), parts_->moment(shot));
  return image;
}

Adaptation PlatePainter::adaptation() const {
  return {{parts_->range(0), parts_->range(1)}, window_of(parts_->style)};
}

void PlatePainter::adapt(const Adaptation& adaptation) {
  parts_->adapt(adaptation);
}

void PlatePainter::write_vectors(const Shot& shot, const std::filesystem::path& path) {
  const Window window = parts_->window_for(shot);
  const Image plates = parts_->painted(shot, window);
  hackle::write_vectors(path, {width(), height(), parts_->style.dpi},
                        [&](Canvas& canvas) { parts_->draw_page(canvas, plates, shot, window); });
}

}  // namespace hackle
