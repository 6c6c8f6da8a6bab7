// SPDX-License-Identifier: MIT
#include "render/png.hpp"

#include <memory>

#include <cairo.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "base/partial_file.hpp"

namespace hackle {
namespace {

bool is_opaque(const Image& image) {
  for (std::size_t at = 3; at < image.pixels.size(); at += 4)
    if (image.pixels[at] != 255) return false;
  return true;
}

}  // namespace

void write_png(const Image& image, const std::filesystem::path& path) {
  const PartialFile partial(path);
  // Cairo only reads the pixels here, but its interface does not say so.
  auto* pixels = const_cast<std::uint8_t*>(image.pixels.data());
  const std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface(
      cairo_image_surface_create_for_data(
          pixels, is_opaque(image) ? CAIRO_FORMAT_RGB24 : CAIRO_FORMAT_ARGB32, image.width,
          image.height, image.stride()),
      cairo_surface_destroy);
  const cairo_status_t status =
      cairo_surface_write_to_png(surface.get(), partial_name(path).c_str());
  if (status != CAIRO_STATUS_SUCCESS)
    throw Error(ErrorKind::files,
                "cannot write '" + path.string() + "': " + cairo_status_to_string(status));
  publish(path);
}

}  // namespace hackle
