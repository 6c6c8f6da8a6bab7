// SPDX-License-Identifier: MIT
#include "output/files/values_file.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "base/files.hpp"
#include "base/image.hpp"
#include "measure/quantity.hpp"
#include "render/colour_map.hpp"
#include "render/png.hpp"

namespace hackle {

void write_values(const NodeValues& values, const std::filesystem::path& path) {
  std::string text = fmt::format("x_m,y_m,{}\n", heading_of({values.name(), values.unit(), {}}));
  values.for_each([&](int i, int j, double value) {
    const Vec2 place = values.grid().position(i, j);
    fmt::format_to(std::back_inserter(text), "{},{},{}\n", place.x(), place.y(),
                   static_cast<float>(value));
  });
  make_folder_of(path);
  write_text(path, text);
}

void write_values_image(const NodeValues& values, const std::string& colours,
                        const std::filesystem::path& path) {
  const ColourMap map = load_colour_map(colours);
  const double min = values.min().value, max = values.max().value;
  const auto last = static_cast<double>(map.colours.size() - 1);
  Image image(values.grid().nx, values.grid().ny);
  values.for_each([&](int i, int j, double value) {
    const double share = max > min ? (value - min) / (max - min) : 0.0;
    const Colour& colour = map.colours[static_cast<std::size_t>(std::lround(share * last))];
    const int row = image.height - 1 - j;
    auto* pixel = image.pixels.data() + static_cast<std::ptrdiff_t>(row) * image.stride() +
                  std::ptrdiff_t{4} * i;
    pixel[0] = colour.blue;
    pixel[1] = colour.green;
    pixel[2] = colour.red;
    pixel[3] = 255;
  });
  make_folder_of(path);
  write_png(image, path);
}

}  // namespace hackle
