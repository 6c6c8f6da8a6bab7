// SPDX-License-Identifier: MIT
#include "console/language/picture_options.hpp"

namespace hackle {

PictureOptions picture_of(const Arguments& arguments) {
  PictureOptions picture;
  picture.field = arguments.text_of_choice("field", picture.field);
  picture.colours = arguments.text_of_choice("colours", picture.colours);
  if (const std::string second = arguments.text_of_choice("second", not_chosen);
      second != not_chosen)
    picture.second = second;
  picture.arrangement = arguments.choice<Arrangement>("arrange");
  if (arguments.has("second_range")) {
    const Vec2 range = arguments.pair("second_range");
    picture.second_range = Ends{range.x(), range.y()};
  }
  picture.cracks = arguments.flag("cracks", picture.cracks);
  picture.thickness = arguments.number("thickness", picture.thickness);
  picture.overlay = overlay_of(arguments);
  if (arguments.has("range")) {
    const Vec2 range = arguments.pair("range");
    picture.range = Ends{range.x(), range.y()};
  }
  if (arguments.has("percentile")) picture.percentile = arguments.number("percentile");
  if (arguments.has("scale")) picture.logarithmic = arguments.text_of_choice("scale", "") == "log";
  // Its first choice means none.
  if (const auto follow = arguments.choice<std::size_t>("follow", 0); follow > 0)
    picture.follow = static_cast<Toward>(follow - 1);
  picture.rotation = arguments.number("rotate", picture.rotation);
  picture.deformed = arguments.flag("deformed", picture.deformed);
  if (arguments.has("magnify")) picture.magnification = arguments.number("magnify");
  picture.bonds = arguments.flag("bonds", picture.bonds);
  picture.background = arguments.choice<Background>("background");
  if (!arguments.has("zoom")) return picture;
  const Eigen::Vector3d window = arguments.window("zoom");
  picture.zoom = Zoom{window.head<2>(), window.z()};
  return picture;
}

PictureOptions sized_picture_of(const Arguments& arguments) {
  PictureOptions picture = picture_of(arguments);
  picture.width = static_cast<int>(arguments.integer("width", picture.width));
  if (arguments.has("px_per_mm")) picture.pixels_a_metre = 1e3 * arguments.number("px_per_mm");
  return picture;
}

}  // namespace hackle
