// SPDX-License-Identifier: MIT
// An FFmpeg encoder, set up for a movie, with its input frame.
#pragma once

#include <cstdint>

#include "base/image.hpp"
#include "movie/av.hpp"
#include "movie/movie_format.hpp"
#include "movie/yuv_planes.hpp"

namespace hackle {

class Codec {
 public:
  // With `global_header` the decoder's set-up data are kept out of the packets. Throws Error
  // (run_failed) if the encoder is missing, Error (files) naming `path` if it does not open.
  Codec(const std::filesystem::path& path, const MovieFormat& format, bool global_header);

  // Sends the frame shown at `number`/fps. Throws Error (files).
  void send(const Image& image, std::int64_t number);
  // Sends the previous frame again.
  void send_again(std::int64_t number);
  // Tells the encoder that no frame follows.
  void send_end();
  // Returns the next packet in units of 1/fps, or null until more is sent. Valid until the next
  // call.
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
  av::Owner<SwsContext> scaler_;  // null for pictures in YUV
  YuvPlanes yuv_;
};

}  // namespace hackle
