// SPDX-License-Identifier: MIT
#include "console/overlay_options.hpp"

namespace hackle {

OverlayOptions overlay_of(const Arguments& arguments) {
  OverlayOptions overlay;
  if (arguments.has("title")) overlay.title = arguments.text("title");
  overlay.clock = arguments.flag("clock", overlay.clock);
  overlay.bar = arguments.flag("bar", overlay.bar);
  overlay.scale_bar = arguments.flag("scale_bar", overlay.scale_bar);
  overlay.load_curve = arguments.flag("load_curve", overlay.load_curve);
  overlay.energy = arguments.flag("energy", overlay.energy);
  overlay.markers = arguments.markers("markers");
  return overlay;
}

}  // namespace hackle
