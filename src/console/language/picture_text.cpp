// SPDX-License-Identifier: MIT
#include "console/language/picture_text.hpp"

#include <fmt/format.h>

#include "base/units.hpp"
#include "measure/energy.hpp"
#include "measure/field.hpp"
#include "output/picture/view.hpp"

namespace hackle {
namespace {

// Includes texts if there are enough pixels to read them.
Image paint_for(const Terminal& terminal, const View& view, PictureOptions options) {
  if (terminal.graphics != Graphics::symbols)
    options.width = widest_picture(options, view, room_for_picture(terminal));
  if (terminal.graphics != Graphics::symbols && options.width > 0) return paint(view, options);
  const Window window = window_of(options, view);
  const double shape = static_cast<double>(window.nx) / window.ny;
  return paint(view, options, bare_picture(terminal, shape));
}

}  // namespace

std::string caption(const View& view, const PictureOptions& options) {
  std::string text =
      fmt::format("{} at {}, {} bonds broken", options.field, quantity(view.time(), "s"),
                  grouped(count_damage(view).broken_bonds));
  if (options.zoom) text += fmt::format(", {} wide", quantity(2.0 * options.zoom->half_width, "m"));
  return text;
}

std::string picture_text(const View& view, const PictureOptions& options,
                         const Terminal& terminal) {
  return text_of(paint_for(terminal, view, options), terminal) + caption(view, options) + "\n";
}

}  // namespace hackle
