// SPDX-License-Identifier: MIT
#include "output/files/picture_files.hpp"

#include <algorithm>

#include "base/files.hpp"
#include "base/stopwatch.hpp"
#include "output/picture/painting.hpp"

namespace hackle {

void PictureFiles::write(const std::filesystem::path& path, const View& view,
                         const PictureOptions& options, const CrackGrowth& growth) {
  const Stopwatch watch(render_seconds_);
  make_folder_of(path);
  write_picture(view, options, path, &growth);
  if (std::ranges::find(files_, path) == files_.end()) files_.push_back(path);
}

void PictureFiles::add_to(Summary& summary) const {
  summary.files.insert(summary.files.end(), files_.begin(), files_.end());
  summary.wall.render += render_seconds_;
}

}  // namespace hackle
