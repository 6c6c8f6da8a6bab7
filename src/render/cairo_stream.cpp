// SPDX-License-Identifier: MIT
#include "render/cairo_stream.hpp"

#include <utility>

#include "base/error.hpp"
#include "base/files.hpp"
#include "base/interrupt.hpp"

namespace hackle {

CairoStream::CairoStream(std::filesystem::path path)
    : path_(std::move(path)), partial_(path_), out_(partial_name(path_), std::ios::binary) {
}

cairo_status_t CairoStream::take(void* stream, const unsigned char* bytes, unsigned int count) {
  if (interrupted()) return CAIRO_STATUS_WRITE_ERROR;
  std::ofstream& out = static_cast<CairoStream*>(stream)->out_;
  out.write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(count));
  return out ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_WRITE_ERROR;
}

void CairoStream::complete(cairo_status_t status) {
  throw_if_interrupted();
  out_.close();
  if (status != CAIRO_STATUS_SUCCESS || !out_)
    throw Error(ErrorKind::files,
                "cannot write '" + path_.string() +
                    "': " + cairo_status_to_string(out_ ? status : CAIRO_STATUS_WRITE_ERROR));
  publish(path_);
}

}  // namespace hackle
