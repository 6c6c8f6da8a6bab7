// SPDX-License-Identifier: MIT
#include "console/language/mask.hpp"

#include "base/interrupt.hpp"
#include "render/png_reader.hpp"

namespace hackle {

Bitmap read_mask(const std::filesystem::path& path, const Box& area, Mask pixels,
                 double threshold) {
  const GreyImage image = read_png(path);
  Bitmap bitmap{area.min, area.max, image.width, image.height, {}};
  bitmap.inside.reserve(image.pixels.size());
  const auto width = static_cast<std::size_t>(image.width);
  for (auto row = static_cast<std::size_t>(image.height); row-- > 0;) {
    throw_if_interrupted();
    for (std::size_t column = 0; column < width; ++column) {
      const bool dark = image.pixels[row * width + column] < threshold * 255.0;
      bitmap.inside.push_back(dark == (pixels == Mask::dark) ? 1 : 0);
    }
  }
  return bitmap;
}

}  // namespace hackle
