// SPDX-License-Identifier: MIT
#include "movie/codec.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>

namespace hackle {
namespace {

bool is_yuv(AVPixelFormat format) {
  return (av::ffmpeg().av_pix_fmt_desc_get(format)->flags & AV_PIX_FMT_FLAG_RGB) == 0;
}

// Sets the colour matrix that players assume for this size; with another one reds look dull.
void tag_as_bt709(AVCodecContext& context) {
  context.color_range = AVCOL_RANGE_MPEG;
  context.colorspace = AVCOL_SPC_BT709;
  context.color_primaries = AVCOL_PRI_BT709;
  context.color_trc = AVCOL_TRC_BT709;
}

}  // namespace

Codec::Codec(const std::filesystem::path& path, const MovieFormat& format, bool global_header)
    : path_(path), frame_(av::ffmpeg().av_frame_alloc()), packet_(av::ffmpeg().av_packet_alloc()) {
  av::ffmpeg().av_log_set_level(AV_LOG_ERROR);
  makeable(path, false);  // throws
  open(movie_kind(path), format, global_header);
  open_frame();
  open_scaler();
}

void Codec::open(const MovieKind& kind, const MovieFormat& format, bool global_header) {
  const AVCodec* codec = av::ffmpeg().avcodec_find_encoder_by_name(kind.encoder);
  context_.reset(av::ffmpeg().avcodec_alloc_context3(codec));
  const AVRational rate = av::ffmpeg().av_d2q(format.fps, 100000);
  context_->width = format.width;
  context_->height = format.height;
  context_->pix_fmt = av::ffmpeg().av_get_pix_fmt(kind.pixels);
  context_->time_base = av_inv_q(rate);
  context_->framerate = rate;
  context_->bit_rate = 0;  // the quality alone determines it
  context_->gop_size = std::max(1, static_cast<int>(std::lround(2.0 * format.fps)));
  context_->thread_count = format.threads;
  if (is_yuv(context_->pix_fmt)) tag_as_bt709(*context_);
  if (global_header) context_->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;

  const ProfileSettings& settings = *kind.settings(format.profile);
  av::Options options(settings.options);
  if (kind.takes_crf()) options.set("crf", format.crf.value_or(settings.crf));
  if (*kind.lookahead != '\0')
    options.set(kind.lookahead, std::min(settings.lookahead, static_cast<int>(format.fps / 2.0)));
  av::check(path_, "encode", av::ffmpeg().avcodec_open2(context_.get(), codec, options.get()));
  options.require_all_taken();
}

void Codec::open_frame() {
  frame_->format = context_->pix_fmt;
  frame_->width = context_->width;
  frame_->height = context_->height;
  frame_->color_range = context_->color_range;
  frame_->colorspace = context_->colorspace;
  frame_->color_primaries = context_->color_primaries;
  frame_->color_trc = context_->color_trc;
  av::check(path_, "encode", av::ffmpeg().av_frame_get_buffer(frame_.get(), 0));
}

// Converts the order of bytes; pictures in YUV take another path.
void Codec::open_scaler() {
  if (is_yuv(context_->pix_fmt)) return;
  const int width = context_->width, height = context_->height;
  scaler_.reset(av::ffmpeg().sws_getContext(width, height, AV_PIX_FMT_BGR0, width, height,
                                            context_->pix_fmt, SWS_POINT, nullptr, nullptr,
                                            nullptr));
  if (!scaler_) av::fail(path_, "encode", AVERROR(ENOMEM));
}

void Codec::fill_frame(const Image& image) {
  av::check(path_, "encode", av::ffmpeg().av_frame_make_writable(frame_.get()));
  if (!scaler_)
    return yuv_.fill(image, {frame_->data[0], frame_->data[1], frame_->data[2]},
                     {frame_->linesize[0], frame_->linesize[1], frame_->linesize[2]});
  const std::uint8_t* const rows[] = {image.pixels.data()};
  const int strides[] = {image.stride()};
  av::ffmpeg().sws_scale(scaler_.get(), rows, strides, 0, image.height, frame_->data,
                         frame_->linesize);
}

void Codec::send(const Image& image, std::int64_t number) {
  fill_frame(image);
  send_again(number);
}

void Codec::send_again(std::int64_t number) {
  frame_->pts = number;
  av::check(path_, "encode", av::ffmpeg().avcodec_send_frame(context_.get(), frame_.get()));
}

void Codec::send_end() {
  av::check(path_, "encode", av::ffmpeg().avcodec_send_frame(context_.get(), nullptr));
}

AVPacket* Codec::receive() {
  const int code = av::ffmpeg().avcodec_receive_packet(context_.get(), packet_.get());
  if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) return nullptr;
  av::check(path_, "encode", code);
  return packet_.get();
}

}  // namespace hackle
