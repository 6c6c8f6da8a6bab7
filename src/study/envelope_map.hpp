// SPDX-License-Identifier: MIT
// The envelope as a map: a row of squares for each family, coloured by how its cells ended.
#pragma once

#include <string>
#include <vector>

#include "base/image.hpp"
#include "study/envelope.hpp"

namespace hackle {

// Returns lines of at most 80 columns: "step  ++++++ss  8 cells" with + right, r refused, s stopped
// and X failed, the counts, and each failed cell with its reason and the command that repeats it.
std::string text_map(const std::vector<CellResult>& results);

// Returns the map as a picture with a legend.
Image picture_map(const std::vector<CellResult>& results);

}  // namespace hackle
