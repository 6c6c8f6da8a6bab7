// SPDX-License-Identifier: MIT
// The kinds of movies, one for each ending of a file name: what they are made of and with.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/described.hpp"

namespace hackle {

// What a movie is for: a quick look, a page or a talk, print and cutting, every pixel as it was.
enum class Profile { preview, web, paper, lossless };
template <>
inline constexpr auto enum_names<Profile> = std::to_array<std::string_view>({"preview", "web",
                                                                             "paper", "lossless"});

// What a profile sets in a kind.
struct ProfileSettings {
  int crf = 0;               // where the kind takes one
  const char* options = "";  // of the encoder, as FFmpeg writes them: "preset=slow:tune=film"
  // Frames that the encoder keeps back to look ahead, but not more than half a second: they are
  // what a film of a killed program lacks.
  int lookahead = 0;
};

// How frames become a file.
enum class Writer {
  stream,  // one stream in a container of FFmpeg
  gif,     // one palette for all frames, which grows as colours are met
  webp,    // chapters of a second, each compressed as a whole
};

struct MovieKind {
  std::string_view ending;  // ".mp4"
  std::string_view name;    // "H.264"
  Writer writer = Writer::stream;
  const char* muxer = "";    // FFmpeg's names of both and of the format of its pixels
  const char* encoder = "";  // "" for a kind that needs none of FFmpeg
  const char* pixels = "";
  const char* muxer_options = "";
  // Of the muxer for a film that is complete, which is then copied once more, with its index in
  // front; "" for a kind that needs no copy.
  const char* final_options = "";
  const char* lookahead = "";  // the name of that option of the encoder, if it has one
  // A lower crf is a better picture; 0, 0 for a kind that takes none.
  int best_crf = 0, worst_crf = 0;
  double max_fps = 1000.0;  // frames a second that it can say and players show
  // In the order of Profile; empty where the kind cannot be what the profile promises.
  std::array<std::optional<ProfileSettings>, 4> profiles;
  // Of each frame: what smooth fields and plates that shatter hardly reach.
  double bytes_a_pixel = 0.0;
  std::array<std::string_view, 5> instead{};  // endings of the next best kinds, best first

  bool takes_crf() const { return worst_crf > 0; }
  const std::optional<ProfileSettings>& settings(Profile profile) const {
    return profiles[static_cast<std::size_t>(profile)];
  }
};

std::span<const MovieKind> movie_kinds();

// By the ending of the name, capitals or not. Throws Error (refused) with the nearest ending and
// the list when there is no such kind.
const MovieKind& movie_kind(const std::filesystem::path& path);

// Whether the FFmpeg at hand has the encoder of this name; it has that of "".
bool has_encoder(const std::string& name);

// A file name whose movie can be made here.
struct Makeable {
  std::filesystem::path path;
  std::string note;  // what was taken instead of what and why, or ""
};

// `path` itself if its encoder is there. Otherwise, with `fallback`, the same name with the ending
// of the next best kind; without, throws Error (run_failed), naming the Debian package. `has` tells
// which encoders there are. Throws what movie_kind throws.
Makeable makeable(const std::filesystem::path& path, bool fallback,
                  const std::function<bool(const std::string&)>& has = has_encoder);

}  // namespace hackle
