// SPDX-License-Identifier: MIT
#include "movie/video_stream.hpp"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/opt.h>
#include <libswscale/swscale.h>
}

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/files.hpp"

namespace hackle {
namespace {

std::string text_of(int code) {
  std::array<char, AV_ERROR_MAX_STRING_SIZE> text{};
  av_strerror(code, text.data(), text.size());
  return text.data();
}

const AVCodec* h264_encoder() {
  const AVCodec* codec = avcodec_find_encoder_by_name("libx264");
  if (codec != nullptr) return codec;
  throw Error(ErrorKind::run_failed, "FFmpeg has no H.264 encoder 'libx264'",
              "install the Debian package libavcodec59 (or libavcodec-extra59)");
}

// Options the encoder did not take are silently ignored by FFmpeg: they are our mistake.
void require_all_taken(AVDictionary* left) {
  const AVDictionaryEntry* entry = av_dict_get(left, "", nullptr, AV_DICT_IGNORE_SUFFIX);
  if (entry != nullptr)
    throw Error(ErrorKind::run_failed, fmt::format("the encoder ignores '{}'", entry->key));
}

}  // namespace

void VideoStream::Free::operator()(AVCodecContext* context) const {
  avcodec_free_context(&context);
}
void VideoStream::Free::operator()(AVFrame* frame) const {
  av_frame_free(&frame);
}
void VideoStream::Free::operator()(AVPacket* packet) const {
  av_packet_free(&packet);
}
void VideoStream::Free::operator()(SwsContext* scaler) const {
  sws_freeContext(scaler);
}
void VideoStream::Free::operator()(AVFormatContext* context) const {
  if (context->pb != nullptr) avio_closep(&context->pb);
  avformat_free_context(context);
}

VideoStream::VideoStream(const std::filesystem::path& path, const MovieFormat& format)
    : format_(format), path_(path), frame_(av_frame_alloc()), packet_(av_packet_alloc()) {
  av_log_set_level(AV_LOG_ERROR);
  AVFormatContext* container = nullptr;
  // The name of a partial file says nothing about its format: name the muxer.
  const std::string name = partial_name(path_).string();
  const int code = avformat_alloc_output_context2(&container, nullptr, "mp4", name.c_str());
  if (code < 0) fail("open", code);
  container_.reset(container);
  open_encoder();
  open_file();
  open_scaler();
}

VideoStream::~VideoStream() = default;

void VideoStream::fail(const char* doing, int code) const {
  throw Error(ErrorKind::files,
              fmt::format("cannot {} the movie '{}': {}", doing, path_.string(), text_of(code)));
}

void VideoStream::open_encoder() {
  const AVCodec* codec = h264_encoder();
  codec_.reset(avcodec_alloc_context3(codec));
  const AVRational rate = av_d2q(format_.fps, 100000);
  codec_->width = format_.width;
  codec_->height = format_.height;
  codec_->pix_fmt = AV_PIX_FMT_YUV420P;  // what every player takes
  codec_->time_base = av_inv_q(rate);
  codec_->framerate = rate;
  codec_->gop_size = std::max(1, static_cast<int>(std::lround(2.0 * format_.fps)));
  codec_->thread_count = format_.threads;
  codec_->profile = FF_PROFILE_H264_HIGH;
  codec_->color_range = AVCOL_RANGE_MPEG;
  codec_->colorspace = AVCOL_SPC_BT709;
  codec_->color_primaries = AVCOL_PRI_BT709;
  codec_->color_trc = AVCOL_TRC_BT709;
  if ((container_->oformat->flags & AVFMT_GLOBALHEADER) != 0)
    codec_->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;

  AVDictionary* options = nullptr;
  av_dict_set_int(&options, "crf", format_.crf, 0);
  av_dict_set(&options, "preset", "medium", 0);
  const int code = avcodec_open2(codec_.get(), codec, &options);
  const std::unique_ptr<AVDictionary, void (*)(AVDictionary*)> left(
      options, [](AVDictionary* dictionary) { av_dict_free(&dictionary); });
  if (code < 0) fail("encode", code);
  require_all_taken(left.get());
}

void VideoStream::open_file() {
  stream_ = avformat_new_stream(container_.get(), nullptr);
  if (stream_ == nullptr) fail("open", AVERROR(ENOMEM));
  stream_->time_base = codec_->time_base;
  stream_->avg_frame_rate = codec_->framerate;
  avcodec_parameters_from_context(stream_->codecpar, codec_.get());
  if (!format_.title.empty()) av_dict_set(&container_->metadata, "title", format_.title.c_str(), 0);

  int code = avio_open(&container_->pb, partial_name(path_).c_str(), AVIO_FLAG_WRITE);
  if (code < 0) fail("create", code);
  AVDictionary* options = nullptr;
  av_dict_set(&options, "movflags", "+faststart", 0);
  code = avformat_write_header(container_.get(), &options);
  av_dict_free(&options);
  if (code < 0) fail("write", code);
}

void VideoStream::open_scaler() {
  frame_->format = codec_->pix_fmt;
  frame_->width = format_.width;
  frame_->height = format_.height;
  frame_->color_range = codec_->color_range;
  frame_->colorspace = codec_->colorspace;
  frame_->color_primaries = codec_->color_primaries;
  frame_->color_trc = codec_->color_trc;
  const int code = av_frame_get_buffer(frame_.get(), 0);
  if (code < 0) fail("encode", code);
  scaler_.reset(sws_getContext(format_.width, format_.height, AV_PIX_FMT_BGRA, format_.width,
                               format_.height, AV_PIX_FMT_YUV420P,
                               SWS_BICUBIC | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INT, nullptr,
                               nullptr, nullptr));
  if (!scaler_) fail("encode", AVERROR(ENOMEM));
  // Full-range RGB to limited-range BT.709; the default of swscale is BT.601, which dulls reds.
  const int* bt709 = sws_getCoefficients(SWS_CS_ITU709);
  sws_setColorspaceDetails(scaler_.get(), bt709, 1, bt709, 0, 0, 1 << 16, 1 << 16);
}

void VideoStream::convert(const Image& image) {
  const int code = av_frame_make_writable(frame_.get());
  if (code < 0) fail("encode", code);
  const std::uint8_t* const rows[] = {image.pixels.data()};
  const int strides[] = {image.stride()};
  sws_scale(scaler_.get(), rows, strides, 0, image.height, frame_->data, frame_->linesize);
}

void VideoStream::add(const Image& image) {
  convert(image);
  frame_->pts = next_++;
  drain(frame_.get());
}

void VideoStream::drain(const AVFrame* frame) {
  int code = avcodec_send_frame(codec_.get(), frame);
  if (code < 0) fail("encode", code);
  for (;;) {
    code = avcodec_receive_packet(codec_.get(), packet_.get());
    if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) return;
    if (code < 0) fail("encode", code);
    // write_header chose the stream's own time base.
    av_packet_rescale_ts(packet_.get(), codec_->time_base, stream_->time_base);
    packet_->duration = av_rescale_q(1, codec_->time_base, stream_->time_base);
    packet_->stream_index = stream_->index;
    code = av_interleaved_write_frame(container_.get(), packet_.get());
    if (code < 0) fail("write", code);
    if (container_->pb->error < 0) fail("write", container_->pb->error);
  }
}

void VideoStream::finish() {
  drain(nullptr);
  int code = av_write_trailer(container_.get());
  if (code >= 0) code = container_->pb->error;
  const int closed = avio_closep(&container_->pb);
  if (code < 0) fail("write", code);
  if (closed < 0) fail("write", closed);
}

}  // namespace hackle
