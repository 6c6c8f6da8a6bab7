// SPDX-License-Identifier: MIT
// An encoder of FFmpeg, set up for a movie, and the frame it is fed with.
#pragma once

#include <cstdint>

#include "base/image.hpp"
#include "movie/av.hpp"
#include "movie/movie_format.hpp"
#include "movie/yuv_planes.hpp"

namespace hackle {

class Codec {
 public:
  // With `global_header` what a decoder must know first is kept out of the packets. Throws Error
  // (run_failed) when the encoder is not there, Error (files) naming `path` when it does not open.
  Codec(const std::filesystem::path& path, const MovieFormat& format, bool global_header);

  // Hands over the frame that is shown at `number`/fps. Throws Error (files).
  void send(const Image& image, std::int64_t number);
  // The frame before once more.
  void send_again(std::int64_t number);
  // No frame follows.
  void send_end();
  // The next packet in units of 1/fps, or null until more is sent. Valid until the next call.
  AVPacket* receive();

  const AVCodecContext& context() const { return *context_; }

 private:
  void open(const MovieKind& kind, const MovieFormat& format, bool global_header);
  void open_frame();
  void open_scaler();
  void fill_frame(const Image& image);

  std::filesystem::path path_;
  av::Owner<AVCodecContext> context_;
  av::Owner<AVFrame> frame_;
  av::Owner<AVPacket> packet_;
  av::Owner<SwsContext> scaler_;  // none for pictures in YUV
  YuvPlanes yuv_;
};

}  // namespace hackle
