// SPDX-License-Identifier: MIT
#include "render/vector_file.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <string>

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "base/interrupt.hpp"
#include "base/partial_file.hpp"

namespace hackle {
namespace {

constexpr double points_an_inch = 72.0;  // the unit of both kinds of file

std::string lower_ending(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending;
}

cairo_status_t take_vectors(void* file, const unsigned char* bytes, unsigned int count) {
  if (interrupted()) return CAIRO_STATUS_WRITE_ERROR;
  auto& out = *static_cast<std::ofstream*>(file);
  out.write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(count));
  return out ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_WRITE_ERROR;
}

// The same picture is the same file, so it does not say when it was made.
cairo_surface_t* page_of(std::ofstream& out, const std::string& ending, double width,
                         double height) {
  if (ending == ".svg")
    return cairo_svg_surface_create_for_stream(take_vectors, &out, width, height);
  cairo_surface_t* page = cairo_pdf_surface_create_for_stream(take_vectors, &out, width, height);
  cairo_pdf_surface_set_metadata(page, CAIRO_PDF_METADATA_CREATE_DATE, "");
  cairo_pdf_surface_set_metadata(page, CAIRO_PDF_METADATA_CREATOR, "Hackle");
  return page;
}

}  // namespace

bool is_vector_file(const std::filesystem::path& path) {
  return std::ranges::find(vector_endings, lower_ending(path)) != vector_endings.end();
}

void write_vectors(const std::filesystem::path& path, const Page& page,
                   const std::function<void(Canvas&)>& draw) {
  const PartialFile partial(path);
  std::ofstream out(partial_name(path), std::ios::binary);
  const double unit = points_an_inch / page.dpi;
  cairo_surface_t* surface =
      page_of(out, lower_ending(path), unit * page.width, unit * page.height);
  cairo_status_t status = CAIRO_STATUS_SUCCESS;
  {
    Canvas canvas(surface, unit);
    draw(canvas);
    status = canvas.finish();
  }
  throw_if_interrupted();
  out.close();
  if (status != CAIRO_STATUS_SUCCESS || !out)
    throw Error(ErrorKind::files,
                "cannot write '" + path.string() +
                    "': " + cairo_status_to_string(out ? status : CAIRO_STATUS_WRITE_ERROR));
  publish(path);
}

}  // namespace hackle
