// SPDX-License-Identifier: MIT
// Plays a movie.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

extern "C" {
#include <libavcodec/avcodec.h>
}

#include "base/image.hpp"

namespace hackle::test {

struct Played {
  int width = 0, height = 0, profile = 0;
  AVPixelFormat format = AV_PIX_FMT_NONE;
  AVColorRange range = AVCOL_RANGE_UNSPECIFIED;
  AVColorSpace space = AVCOL_SPC_UNSPECIFIED;
  AVColorPrimaries primaries = AVCOL_PRI_UNSPECIFIED;
  AVColorTransferCharacteristic transfer = AVCOL_TRC_UNSPECIFIED;
  std::map<std::string, std::string> metadata;  // names in lower case
  std::vector<double> times;                    // s, start of each frame
  std::vector<Image> frames;                    // BGRA
  std::vector<std::size_t> keyframes;
  double seconds = 0.0;  // of an animated WebP
};

// Plays a file of any kind; a truncated end is ignored.
Played play(const std::filesystem::path& path);

// Returns the largest difference of any channel except alpha, in levels.
int difference(const Image& one, const Image& other);

}  // namespace hackle::test
