// SPDX-License-Identifier: MIT
#include "console/picture_options.hpp"

namespace hackle {

PictureOptions picture_of(const Arguments& arguments) {
  PictureOptions picture;
  picture.field = arguments.text_of_choice("field", picture.field);
  if (!arguments.has("zoom")) return picture;
  const Eigen::Vector3d window = arguments.window("zoom");
  picture.zoom = Zoom{window.head<2>(), window.z()};
  return picture;
}

PictureOptions sized_picture_of(const Arguments& arguments) {
  PictureOptions picture = picture_of(arguments);
  picture.width = static_cast<int>(arguments.integer("width", picture.width));
  return picture;
}

}  // namespace hackle
