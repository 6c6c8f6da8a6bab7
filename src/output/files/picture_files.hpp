// SPDX-License-Identifier: MIT
// The pictures that a run has written, one file each.
#pragma once

#include <filesystem>
#include <vector>

#include "measure/crack_growth.hpp"
#include "output/picture/picture.hpp"
#include "output/report/summary.hpp"
#include "solver/view.hpp"

namespace hackle {

class PictureFiles {
 public:
  // Writes a picture of the present state, and makes its folder. Throws what write_picture throws.
  void write(const std::filesystem::path& path, const View& view, const PictureOptions& options,
             const CrackGrowth& growth);

  // Adds the files and the wall time so far.
  void add_to(Summary& summary) const;

 private:
  std::vector<std::filesystem::path> files_;
  double render_seconds_ = 0.0;
};

}  // namespace hackle
