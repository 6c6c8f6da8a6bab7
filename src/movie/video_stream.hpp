// SPDX-License-Identifier: MIT
// The calls into FFmpeg: one H.264 stream in one MP4 file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "base/image.hpp"
#include "movie/encoder.hpp"

struct AVCodecContext;
struct AVFormatContext;
struct AVFrame;
struct AVPacket;
struct AVStream;
struct SwsContext;

namespace hackle {

class VideoStream {
 public:
  // Opens the partial file of `path` and writes the header. Throws as Encoder does.
  VideoStream(const std::filesystem::path& path, const MovieFormat& format);
  ~VideoStream();
  VideoStream(const VideoStream&) = delete;
  VideoStream& operator=(const VideoStream&) = delete;

  // Encodes one frame; frame k is shown at k/fps. Throws Error (files) when it cannot be written.
  void add(const Image& image);
  // Flushes the encoder (x264 holds back dozens of frames) and completes the file.
  void finish();

 private:
  struct Free {
    void operator()(AVCodecContext* context) const;
    void operator()(AVFormatContext* context) const;
    void operator()(AVFrame* frame) const;
    void operator()(AVPacket* packet) const;
    void operator()(SwsContext* scaler) const;
  };

  void open_encoder();
  void open_file();
  void open_scaler();
  void convert(const Image& image);
  void drain(const AVFrame* frame);
  [[noreturn]] void fail(const char* doing, int code) const;

  MovieFormat format_;
  std::filesystem::path path_;
  std::unique_ptr<AVFormatContext, Free> container_;
  std::unique_ptr<AVCodecContext, Free> codec_;
  std::unique_ptr<AVFrame, Free> frame_;
  std::unique_ptr<AVPacket, Free> packet_;
  std::unique_ptr<SwsContext, Free> scaler_;
  AVStream* stream_ = nullptr;  // owned by container_
  std::int64_t next_ = 0;
};

}  // namespace hackle
