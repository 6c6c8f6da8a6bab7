// SPDX-License-Identifier: MIT
#include "output/files/picture_files.hpp"

#include <algorithm>

#include "base/files.hpp"
#include "base/stopwatch.hpp"
#include "render/png.hpp"

namespace hackle {

void write_picture_file(const Image& image, const std::filesystem::path& path) {
  make_folder_of(path);
  write_png(image, path);
}

void PictureFiles::write(const std::filesystem::path& path, const std::function<Image()>& make) {
  Image image;
  {
    const Stopwatch watch(render_seconds_);
    image = make();
  }
  const Stopwatch watch(store_seconds_);
  write_picture_file(image, path);
  if (std::ranges::find(files_, path) == files_.end()) files_.push_back(path);
}

void PictureFiles::add_to(Summary& summary) const {
  summary.files.insert(summary.files.end(), files_.begin(), files_.end());
  summary.wall.render += render_seconds_;
  summary.wall.store += store_seconds_;
}

}  // namespace hackle
