// SPDX-License-Identifier: MIT
#include "movie/movie_kind.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/text.hpp"
#include "movie/ffmpeg.hpp"

namespace hackle {
namespace fs = std::filesystem;
namespace {

constexpr std::optional<ProfileSettings> cannot_be = std::nullopt;

// Of mp4 and mov: fragments of half a second, then the index in front.
constexpr const char* fragments =
    "movflags=frag_keyframe+delay_moov+default_base_moof:frag_duration=500000";
constexpr const char* index_first = "movflags=faststart";

// Measured on the 129 frames of 1280 x 640 of the edge crack (seconds of CPU, size, luma PSNR):
//   x264 crf 18   superfast 0.36 114 kB 62 dB   veryfast 0.43 68 kB 57 dB   faster 0.86 68 kB 59 dB
//                 fast      0.99  70 kB 60 dB   medium   0.83 70 kB 60 dB
//   VP9 crf 30    realtime, cpu-used 7: 0.8 93 kB   good, cpu-used 5: 3.4 78 kB
//   WebP          quality 80: 1.4 154 kB   lossless: 0.7 82 kB; of a smooth field lossless takes
//                 three times what quality 90 does
constexpr std::array kinds{
    MovieKind{.ending = ".mp4",
              .name = "H.264",
              .muxer = "mp4",
              .encoder = "libx264",
              .pixels = "yuv420p",  // accepted by every player
              .muxer_options = fragments,
              .final_options = index_first,
              .lookahead = "rc-lookahead",
              .best_crf = 1,
              .worst_crf = 51,
              .profiles = {ProfileSettings{28, "profile=high:preset=superfast"},
                           ProfileSettings{18, "profile=high:preset=veryfast", 10},
                           ProfileSettings{10, "profile=high:preset=slow", 20}, cannot_be},
              .bytes_a_pixel = 0.03,
              .instead = {".webm", ".webp", ".mkv", ".gif", ".apng"}},
    MovieKind{.ending = ".webm",
              .name = "VP9",
              .muxer = "webm",
              .encoder = "libvpx-vp9",
              .pixels = "yuv420p",
              .muxer_options = "cluster_time_limit=500",
              .lookahead = "lag-in-frames",
              .best_crf = 1,
              .worst_crf = 63,
              .profiles = {ProfileSettings{40, "deadline=realtime:cpu-used=8:row-mt=1"},
                           ProfileSettings{28, "deadline=realtime:cpu-used=7:row-mt=1"},
                           ProfileSettings{16, "deadline=good:cpu-used=3:row-mt=1", 20}, cannot_be},
              .bytes_a_pixel = 0.03,
              .instead = {".mp4", ".webp", ".mkv", ".gif", ".apng"}},
    MovieKind{.ending = ".mkv",
              .name = "FFV1",
              .muxer = "matroska",
              .encoder = "ffv1",
              .pixels = "bgr0",
              .muxer_options = "cluster_time_limit=500",
              .profiles = {ProfileSettings{0, "level=3:g=1:slicecrc=1"},
                           ProfileSettings{0, "level=3:g=1:slicecrc=1"},
                           ProfileSettings{0, "level=3:g=1:slicecrc=1"},
                           ProfileSettings{0, "level=3:g=1:slicecrc=1"}},
              .bytes_a_pixel = 0.2,
              .instead = {".apng", ".webp", ".mp4", ".webm", ".gif"}},
    // For programs that cut films and take no FFV1; lossless as they do.
    MovieKind{
        .ending = ".mov",
        .name = "QuickTime Animation",
        .muxer = "mov",
        .encoder = "qtrle",
        .pixels = "rgb24",
        .muxer_options = fragments,
        .final_options = index_first,
        .profiles = {ProfileSettings{}, ProfileSettings{}, ProfileSettings{}, ProfileSettings{}},
        .bytes_a_pixel = 0.8,
        .instead = {".mkv", ".apng", ".webp", ".mp4", ".gif"}},
    MovieKind{.ending = ".gif",
              .name = "GIF",
              .writer = Writer::gif,
              .max_fps = 50.0,  // players slow down faster ones
              .profiles = {ProfileSettings{}, ProfileSettings{}, ProfileSettings{}, cannot_be},
              .bytes_a_pixel = 0.3},
    MovieKind{.ending = ".apng",
              .name = "APNG",
              .muxer = "apng",
              .encoder = "apng",
              .pixels = "rgb24",
              .muxer_options = "plays=0",
              .profiles = {ProfileSettings{0, "compression_level=1"},
                           ProfileSettings{0, "compression_level=6"},
                           ProfileSettings{0, "compression_level=9"},
                           ProfileSettings{0, "compression_level=6"}},
              .bytes_a_pixel = 0.3,
              .instead = {".webp", ".mkv", ".gif", ".mp4", ".webm"}},
    MovieKind{.ending = ".webp",
              .name = "WebP",
              .writer = Writer::webp,
              .encoder = "libwebp_anim",
              .pixels = "bgra",
              .profiles = {ProfileSettings{0, "lossless=0:quality=60:compression_level=2"},
                           ProfileSettings{0, "lossless=0:quality=85:compression_level=4"},
                           ProfileSettings{0, "lossless=1:quality=20:compression_level=1"},
                           ProfileSettings{0, "lossless=1:quality=20:compression_level=1"}},
              .bytes_a_pixel = 0.1,
              .instead = {".apng", ".gif", ".mp4", ".webm", ".mkv"}},
};

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

const MovieKind* find_kind(std::string_view ending) {
  const auto found = std::ranges::find(kinds, ending, &MovieKind::ending);
  return found == kinds.end() ? nullptr : &*found;
}

std::string_view package_of(const MovieKind& kind) {
  return kind.ending == ".mp4" ? "libavcodec59 (or libavcodec-extra59)" : "libavcodec59";
}

// Returns the next best kind whose encoder is installed, or null.
const MovieKind* next_best(const MovieKind& kind,
                           const std::function<bool(const std::string&)>& has) {
  for (const std::string_view ending : kind.instead)
    if (const MovieKind* other = find_kind(ending); other != nullptr && has(other->encoder))
      return other;
  return nullptr;
}

}  // namespace

std::span<const MovieKind> movie_kinds() {
  return kinds;
}

const MovieKind& movie_kind(const fs::path& path) {
  const std::string ending = lower(path.extension().string());
  if (const MovieKind* kind = find_kind(ending)) return *kind;
  std::vector<std::string_view> endings;
  endings.reserve(kinds.size());
  for (const MovieKind& kind : kinds) endings.push_back(kind.ending);
  throw Error(ErrorKind::refused,
              fmt::format("movie: '{}' ends in '{}', which is no kind of movie{}",
                          path.filename().string(), ending, did_you_mean(ending, endings)),
              "one of " + comma_list(endings));
}

bool has_encoder(const std::string& name) {
  return name.empty() || av::ffmpeg().avcodec_find_encoder_by_name(name.c_str()) != nullptr;
}

Makeable makeable(const fs::path& path, bool fallback,
                  const std::function<bool(const std::string&)>& has) {
  const MovieKind& kind = movie_kind(path);
  if (has(kind.encoder)) return {path, ""};
  const std::string lack = fmt::format("FFmpeg has no {} encoder '{}' for '{}'", kind.name,
                                       kind.encoder, path.filename().string());
  const std::string install = fmt::format("install the Debian package {}", package_of(kind));
  const MovieKind* other = fallback ? next_best(kind, has) : nullptr;
  if (other == nullptr)
    throw Error(ErrorKind::run_failed, "movie: " + lack,
                install + (fallback ? "" : ", or allow another kind with fallback = true"));
  fs::path instead = path;
  instead.replace_extension(other->ending);
  return {instead,
          fmt::format("{}: filming '{}' instead ({})", lack, instead.filename().string(), install)};
}

}  // namespace hackle
