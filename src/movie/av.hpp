// SPDX-License-Identifier: MIT
// Common parts for users of FFmpeg's libraries: owners of its objects, options, errors.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "movie/ffmpeg.hpp"

namespace hackle::av {

struct Free {
  void operator()(AVCodecContext* context) const { ffmpeg().avcodec_free_context(&context); }
  void operator()(AVFrame* frame) const { ffmpeg().av_frame_free(&frame); }
  void operator()(AVPacket* packet) const { ffmpeg().av_packet_free(&packet); }
  void operator()(SwsContext* scaler) const { ffmpeg().sws_freeContext(scaler); }
  void operator()(AVFormatContext* context) const;  // of a file being read or written
};

template <class T>
using Owner = std::unique_ptr<T, Free>;

// Options in FFmpeg's form, "key=value:key=value".
class Options {
 public:
  explicit Options(const std::string& text = "");
  ~Options() { ffmpeg().av_dict_free(&dictionary_); }
  Options(const Options&) = delete;
  Options& operator=(const Options&) = delete;

  void set(const char* key, int value) { ffmpeg().av_dict_set_int(&dictionary_, key, value, 0); }
  AVDictionary** get() { return &dictionary_; }
  // FFmpeg silently ignores unused options, which would be a mistake of ours. Throws Error
  // (run_failed) for them.
  void require_all_taken() const;

 private:
  AVDictionary* dictionary_ = nullptr;
};

// Throws Error (files): "cannot `doing` the movie `path`: meaning of FFmpeg's `code`".
[[noreturn]] void fail(const std::filesystem::path& path, const char* doing, int code);
inline int check(const std::filesystem::path& path, const char* doing, int code) {
  if (code < 0) fail(path, doing, code);
  return code;
}

}  // namespace hackle::av
