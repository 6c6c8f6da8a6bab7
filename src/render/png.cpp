// SPDX-License-Identifier: MIT
#include "render/png.hpp"

#include <fstream>
#include <memory>

#include <cairo.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "base/interrupt.hpp"
#include "base/partial_file.hpp"

namespace hackle {
namespace {

bool is_opaque(const Image& image) {
  for (std::size_t at = 3; at < image.pixels.size(); at += 4)
    if (image.pixels[at] != 255) return false;
  return true;
}

// Writes the bytes that Cairo has encoded so far; an interrupt ends even a large picture in the
// middle.
cairo_status_t take(void* file, const unsigned char* bytes, unsigned int count) {
  if (interrupted()) return CAIRO_STATUS_WRITE_ERROR;
  auto& out = *static_cast<std::ofstream*>(file);
  out.write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(count));
  return out ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_WRITE_ERROR;
}

}  // namespace

void write_png(const Image& image, const std::filesystem::path& path) {
  const PartialFile partial(path);
  // Cairo only reads the pixels here, though its interface takes a non-const pointer.
  auto* pixels = const_cast<std::uint8_t*>(image.pixels.data());
  const std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface(
      cairo_image_surface_create_for_data(
          pixels, is_opaque(image) ? CAIRO_FORMAT_RGB24 : CAIRO_FORMAT_ARGB32, image.width,
          image.height, image.stride()),
      cairo_surface_destroy);
  std::ofstream out(partial_name(path), std::ios::binary);
  const cairo_status_t status = cairo_surface_write_to_png_stream(surface.get(), take, &out);
  throw_if_interrupted();
  out.close();
  if (status != CAIRO_STATUS_SUCCESS || !out)
    throw Error(ErrorKind::files,
                "cannot write '" + path.string() +
                    "': " + cairo_status_to_string(out ? status : CAIRO_STATUS_WRITE_ERROR));
  publish(path);
}

}  // namespace hackle
