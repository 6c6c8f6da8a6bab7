// SPDX-License-Identifier: MIT
// The pictures that a run has written, one file each.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "base/image.hpp"
#include "output/report/summary.hpp"

namespace hackle {

// Makes the folder, too. Throws what write_png throws.
void write_picture_file(const Image& image, const std::filesystem::path& path);

class PictureFiles {
 public:
  // Writes what `make` paints. Throws what that and write_png throw.
  void write(const std::filesystem::path& path, const std::function<Image()>& make);

  // Adds the files and the wall time so far.
  void add_to(Summary& summary) const;

 private:
  std::vector<std::filesystem::path> files_;
  double render_seconds_ = 0.0;
  double store_seconds_ = 0.0;
};

}  // namespace hackle
