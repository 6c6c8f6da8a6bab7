// SPDX-License-Identifier: MIT
#include "render/png.hpp"

#include <memory>

#include <cairo.h>

#include "render/cairo_stream.hpp"

namespace hackle {
namespace {

bool is_opaque(const Image& image) {
  for (std::size_t at = 3; at < image.pixels.size(); at += 4)
    if (image.pixels[at] != 255) return false;
  return true;
}

}  // namespace

void write_png(const Image& image, const std::filesystem::path& path) {
  CairoStream out(path);
  // Cairo only reads the pixels here, though its interface takes a non-const pointer.
  auto* pixels = const_cast<std::uint8_t*>(image.pixels.data());
  const std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface(
      cairo_image_surface_create_for_data(
          pixels, is_opaque(image) ? CAIRO_FORMAT_RGB24 : CAIRO_FORMAT_ARGB32, image.width,
          image.height, image.stride()),
      cairo_surface_destroy);
  out.complete(cairo_surface_write_to_png_stream(surface.get(), CairoStream::take, out.closure()));
}

}  // namespace hackle
