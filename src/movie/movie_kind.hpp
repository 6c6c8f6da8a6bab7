// SPDX-License-Identifier: MIT
// The kinds of movies, one per file extension, with their formats and encoders.
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

// The purpose of a movie: a quick look; a page or a talk; print and cutting; exact pixels.
enum class Profile { preview, web, paper, lossless };
template <>
inline constexpr auto enum_names<Profile> = std::to_array<std::string_view>({"preview", "web",
                                                                             "paper", "lossless"});

// The settings of a profile for a kind.
struct ProfileSettings {
  int crf = 0;               // if the kind has one
  const char* options = "";  // of the encoder, in FFmpeg's form: "preset=slow:tune=film"
  // Frames that the encoder holds back to look ahead, at most half a second: a movie of a killed
  // program lacks them.
  int lookahead = 0;
};

// How frames become a file.
enum class Writer {
  stream,  // one stream in an FFmpeg container
  gif,     // one palette for all frames, which grows with new colours
  webp,    // chapters of a second, each compressed as a whole
};

struct MovieKind {
  std::string_view ending;  // ".mp4"
  std::string_view name;    // "H.264"
  Writer writer = Writer::stream;
  const char* muxer = "";    // FFmpeg's names of both and of the pixel format
  const char* encoder = "";  // "" for a kind without FFmpeg
  const char* pixels = "";
  const char* muxer_options = "";
  // Of the muxer for a film that is complete, which is then copied once more, with its index in
  // front; "" for a kind that needs no copy.
  const char* final_options = "";
  const char* lookahead = "";  // the encoder's name of that option, if it has one
  // A lower crf is a better picture; 0, 0 for a kind without crf.
  int best_crf = 0, worst_crf = 0;
  double max_fps = 1000.0;  // frames per second that it can store and players show
  // In the order of Profile; empty if the kind cannot fulfil the profile.
  std::array<std::optional<ProfileSettings>, 4> profiles;
  // Per frame: a size that smooth fields and shattering plates hardly reach.
  double bytes_a_pixel = 0.0;
  std::array<std::string_view, 5> instead{};  // extensions of the next best kinds, best first

  bool takes_crf() const { return worst_crf > 0; }
  const std::optional<ProfileSettings>& settings(Profile profile) const {
    return profiles[static_cast<std::size_t>(profile)];
  }
};

std::span<const MovieKind> movie_kinds();

// Returns the kind by the extension of the name, in any case. Throws Error (refused) with the
// nearest extension and the list for an unknown one.
const MovieKind& movie_kind(const std::filesystem::path& path);

// Returns whether the installed FFmpeg has the encoder of this name; true for "".
bool has_encoder(const std::string& name);

// A file name whose movie can be made here.
struct Makeable {
  std::filesystem::path path;
  std::string note;  // the replacement and its reason, or ""
};

// Returns `path` itself if its encoder is installed. Otherwise, with `fallback`, returns the same
// name with the extension of the next best kind; without it throws Error (run_failed), naming the
// Debian package. `has` tells which encoders exist. Throws what movie_kind throws.
Makeable makeable(const std::filesystem::path& path, bool fallback,
                  const std::function<bool(const std::string&)>& has = has_encoder);

}  // namespace hackle
