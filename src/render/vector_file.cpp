// SPDX-License-Identifier: MIT
#include "render/vector_file.hpp"

#include <algorithm>
#include <cctype>
#include <string>

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include "render/cairo_stream.hpp"

namespace hackle {
namespace {

constexpr double points_an_inch = 72.0;  // the unit of both kinds of file

std::string lower_ending(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending;
}

// The same picture is the same file, so it does not say when it was made.
cairo_surface_t* page_of(CairoStream& out, const std::string& ending, double width, double height) {
  if (ending == ".svg")
    return cairo_svg_surface_create_for_stream(CairoStream::take, out.closure(), width, height);
  cairo_surface_t* page =
      cairo_pdf_surface_create_for_stream(CairoStream::take, out.closure(), width, height);
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
  CairoStream out(path);
  const double unit = points_an_inch / page.dpi;
  cairo_surface_t* surface =
      page_of(out, lower_ending(path), unit * page.width, unit * page.height);
  cairo_status_t status = CAIRO_STATUS_SUCCESS;
  {
    Canvas canvas(surface, unit);
    draw(canvas);
    status = canvas.finish();
  }
  out.complete(status);
}

}  // namespace hackle
