// SPDX-License-Identifier: MIT
// A file that Cairo writes.
#pragma once

#include <filesystem>
#include <fstream>

#include <cairo.h>

#include "base/partial_file.hpp"

namespace hackle {

// Has a temporary name until it is complete, and is removed if it is not.
class CairoStream {
 public:
  explicit CairoStream(std::filesystem::path path);

  // For Cairo, which calls take(closure(), bytes, count). An interrupt ends even a large picture in
  // the middle.
  static cairo_status_t take(void* stream, const unsigned char* bytes, unsigned int count);
  void* closure() { return this; }

  // Gives the file its name. Throws Error (interrupted), and Error (files) unless all was written
  // and Cairo ended with success.
  void complete(cairo_status_t status);

 private:
  std::filesystem::path path_;
  PartialFile partial_;
  std::ofstream out_;
};

}  // namespace hackle
