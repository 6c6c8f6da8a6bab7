// SPDX-License-Identifier: MIT
#include "output/picture/painting.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/units.hpp"
#include "measure/gaps.hpp"
#include "measure/links.hpp"
#include "output/picture/automatic_range.hpp"
#include "output/picture/chart_data.hpp"
#include "output/picture/crack_picture.hpp"
#include "output/picture/field_choice.hpp"
#include "output/picture/paper.hpp"
#include "output/picture/view.hpp"
#include "render/png.hpp"
#include "render/seen_range.hpp"
#include "render/vector_file.hpp"
#include "scene/check_members.hpp"
#include "solver/divergence.hpp"

namespace hackle {
namespace {

FieldStyle style_of(const FieldChoice& field, const View& view) {
  FieldStyle style;
  style.colour_map = field.colours;
  const Ends ends = field.range.value_or(usual_ends(field, view));
  style.min = ends.min;
  style.max = ends.max;
  style.logarithmic = field.logarithmic;
  style.sampling = field.scalar.sampling;
  style.label = field.scalar.label;
  style.unit = field.scalar.unit;
  style.whole = field.is_fringes();
  style.widens = !field.range && field.is_unlimited();
  return style;
}

void check_range(const char* output, const char* option, const FieldChoice& field,
                 Problems& problems) {
  if (!field.range) return;
  const auto [min, max] = *field.range;
  if (!(std::isfinite(min) && std::isfinite(max) && min < max))
    problems.add(fmt::format("{}: {} is {{{}, {}}}, it must go from a smaller to a larger value",
                             output, option, min, max));
  else if (field.logarithmic && min <= 0.0)
    problems.add(fmt::format("{}: {} begins at {}, on a logarithmic scale it must be above 0",
                             output, option, min));
}

// Includes bonds of outside nodes that reach into the window.
std::vector<BondLine> bonds_in(const Window& window, const View& view) {
  const int reach = view.lattice().family.reach();
  return bond_lines(view, {window.left - reach, window.left + window.nx - 1 + reach,
                           window.bottom - reach, window.bottom + window.ny - 1 + reach});
}

std::vector<std::uint8_t> in_255ths(const std::vector<float>& shares) {
  std::vector<std::uint8_t> bytes(shares.size());
  std::ranges::transform(shares, bytes.begin(), [](float share) {
    return static_cast<std::uint8_t>(std::lround(255.0F * share));
  });
  return bytes;
}

Paper paper_of(const PictureOptions& options) {
  return {options.width, options.paper, options.dpi, options.font_size};
}

// Throws Error (refused) if the picture would be too large.
void set_size(PictureStyle& style, const PictureOptions& options) {
  style.width = pixels_of(paper_of(options));
  style.dpi = options.dpi;
  style.font = font_pixels(paper_of(options));
  if (!options.pixels_a_mm) return;
  style.cell = 1e3 * *options.pixels_a_mm * style.grid.dx;
  const Grid seen = part(style.grid, *style.window);
  const double longest = style.cell * std::max(seen.nx, seen.ny);
  const PlateSize size{style.cell, options.second && options.arrangement == Arrangement::beside};
  if (longest < max_picture_width) style.width = width_for(seen, size);
  if (longest >= max_picture_width || style.width > max_picture_width)
    throw Error(ErrorKind::refused,
                fmt::format("px_per_mm is {}, the picture would be wider or higher than {} px",
                            shortest(*options.pixels_a_mm), max_picture_width),
                "take fewer, or a zoom");
}

std::string title_of(const PictureOptions& options, const View& view) {
  if (options.overlay.title) return *options.overlay.title;
  const std::string& name = view.plate().material.name;
  if (!first_field(options).is_fringes()) return name;
  return fmt::format("{}, {} thick", name, quantity(options.thickness, "m"));
}

}  // namespace

void refuse_percentile(const char* output, const PictureOptions& options) {
  if (options.percentile)
    throw Error(ErrorKind::refused,
                fmt::format("{}: percentile needs to know what will be seen", output),
                "give a range; or record the run, and let recording(...):movie{} find it");
}

void check_opaque(const char* output, const PictureOptions& options) {
  if (options.background == Background::transparent)
    throw Error(ErrorKind::refused, fmt::format("{}: the background cannot be transparent", output),
                "only a PNG by itself can; here it is dark or light");
}

void check(const char* output, const PictureOptions& options, const Grid& grid) {
  Problems problems;
  check_members(options, output, problems);
  check_members(options.overlay, output, problems);
  if (options.width % 2 != 0)
    problems.add(fmt::format("{}: width is {} px, it must be even", output, options.width));
  if (options.paper && options.pixels_a_mm)
    problems.add(fmt::format("{}: paper and px_per_mm are given", output),
                 "paper is the width of the picture, px_per_mm that of the plate");
  check_paper(output, paper_of(options), problems);
  if (options.overlay.axes && options.rotation != 0.0)
    problems.add(fmt::format("{}: axes cannot be turned", output), "leave out axes or rotate");
  check_view(output, options, grid, problems);
  problems.throw_if_any();
  check_range(output, "range", first_field(options), problems);
  if (options.second) check_range(output, "second_range", second_field(options), problems);
  if (options.range && options.percentile)
    problems.add(fmt::format("{}: range and percentile are given", output),
                 "range says where the colour bar ends, percentile lets the values say it");
  if (options.overlay.graph && options.deformed)
    problems.add(fmt::format("{}: graph and deformed are given", output),
                 "paths of cracks are those of the undeformed plate");
  problems.throw_if_any();
}

PictureStyle style_of(const PictureOptions& options, const View& view) {
  PictureStyle style;
  style.grid = view.lattice().grid;
  style.window = window_of(options, view);
  style.rotation = options.rotation;
  style.magnification = magnification_of(options, view);
  style.encloses = !options.zoom && style.magnification > 0.0;
  if (style.magnification > 0.0)
    style.note = fmt::format("displacements × {:.4g}", style.magnification);
  style.background = options.background.value_or(ground_of(options.look));
  style.bonds = options.bonds;
  style.smooth = options.smooth;
  set_size(style, options);
  FieldChoice first = first_field(options);
  if (options.percentile) first.range = automatic_range(options, view);
  style.field = style_of(first, view);
  if (options.second) style.second = style_of(second_field(options), view);
  style.arrangement = options.arrangement;
  style.overlay = options.overlay;
  style.title = title_of(options, view);
  return style;
}

Ends fitting_range(const FieldChoice& choice, const View& view, const Ends& ends) {
  FieldStyle field = style_of(choice, view);
  field.min = ends.min;
  field.max = ends.max;
  const std::vector<float> values = values_of(choice, view);
  field = widened(field, widening(field, {values, {}}));
  return {field.min, field.max};
}

Image paint(const View& view, const PictureOptions& options, const std::optional<Extent>& bare) {
  check_finite(view);
  PictureStyle style = style_of(options, view);
  if (bare) {
    style.width = bare->width;
    style.bare_height = bare->height;
  }
  return PlatePainter(style).paint(shot_of(options, view));
}

void write_picture(const View& view, const PictureOptions& options,
                   const std::filesystem::path& path, const CrackGrowth* growth) {
  check_finite(view);
  PlatePainter painter(style_of(options, view));
  const Shot shot = shot_of(options, view, growth);
  if (is_vector_file(path)) return painter.write_vectors(shot, path);
  write_png(painter.paint(shot), path);
}

int widest_picture(const PictureOptions& options, const View& view, const Extent& max) {
  PictureStyle style = style_of(options, view);
  for (int width = std::min(max.width, max_picture_width) / 2 * 2; width >= min_picture_width;
       width -= 2) {
    style.width = width;
    if (layout_of(style).height <= max.height) return width;
  }
  return 0;
}

Shot shot_of(const PictureOptions& options, const View& view, const CrackGrowth* growth) {
  Shot shot;
  shot.values = field_values(options, view);
  if (options.second) shot.second = values_of(second_field(options), view);
  shot.time = view.time();
  shot.discs = round_bodies(view);
  shot.boxes = platens(view);
  if (options.cracks && options.field != "damage" && options.second != "damage")
    shot.gaps = in_255ths(gaps(view));
  if (magnification_of(options, view) > 0.0) {
    shot.displacement = displacement(view).values;
    shot.links = links(view);
  } else if (options.smooth) {
    shot.links = links(view);
  }
  const Window window = followed(window_of(options, view), options, view);
  if (options.follow) shot.window = window;
  if (options.bonds) shot.bonds = bonds_in(window, view);
  if (options.overlay.load_curve) shot.load_curve = load_curve(view);
  if (options.overlay.energy) shot.energy = energy_chart(view);
  if (options.overlay.graph)
    shot.cracks = growth != nullptr ? crack_drawing(crack_graph(*growth)) : crack_drawing(view);
  return shot;
}

}  // namespace hackle
