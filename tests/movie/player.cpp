// SPDX-License-Identifier: MIT
#include "movie/player.hpp"

extern "C" {
#include <libavformat/avformat.h>
#include <libavutil/pixdesc.h>
#include <libswscale/swscale.h>
}

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <cstring>
#include <span>

#include <gtest/gtest.h>

#include "base/files.hpp"

namespace hackle::test {
namespace {

Image to_image(const AVFrame* frame) {
  const auto format = static_cast<AVPixelFormat>(frame->format);
  Image image(frame->width, frame->height);
  SwsContext* scaler =
      sws_getContext(frame->width, frame->height, format, frame->width, frame->height,
                     AV_PIX_FMT_BGRA, SWS_BICUBIC | SWS_ACCURATE_RND, nullptr, nullptr, nullptr);
  if ((av_pix_fmt_desc_get(format)->flags & AV_PIX_FMT_FLAG_RGB) == 0) {
    const int* bt709 = sws_getCoefficients(SWS_CS_ITU709);
    sws_setColorspaceDetails(scaler, bt709, 0, bt709, 1, 0, 1 << 16, 1 << 16);
  }
  std::uint8_t* rows[] = {image.pixels.data()};
  const int strides[] = {image.stride()};
  sws_scale(scaler, frame->data, frame->linesize, 0, frame->height, rows, strides);
  sws_freeContext(scaler);
  return image;
}

void note_metadata(const AVDictionary* dictionary, Played& played) {
  const AVDictionaryEntry* entry = nullptr;
  while ((entry = av_dict_get(dictionary, "", entry, AV_DICT_IGNORE_SUFFIX)) != nullptr) {
    std::string key = entry->key;
    std::ranges::transform(key, key.begin(), [](unsigned char c) { return std::tolower(c); });
    played.metadata[key] = entry->value;
  }
}

Played play_stream(const std::filesystem::path& path) {
  Played played;
  av_log_set_level(AV_LOG_FATAL);
  AVFormatContext* container = nullptr;
  if (avformat_open_input(&container, path.c_str(), nullptr, nullptr) != 0) return played;
  avformat_find_stream_info(container, nullptr);
  const AVStream* stream = container->streams[0];
  note_metadata(container->metadata, played);
  AVCodecContext* codec = avcodec_alloc_context3(avcodec_find_decoder(stream->codecpar->codec_id));
  avcodec_parameters_to_context(codec, stream->codecpar);
  avcodec_open2(codec, codec->codec, nullptr);
  AVPacket* packet = av_packet_alloc();
  AVFrame* frame = av_frame_alloc();
  const auto receive = [&] {
    while (avcodec_receive_frame(codec, frame) == 0) {
      if (frame->key_frame != 0) played.keyframes.push_back(played.frames.size());
      played.times.push_back(static_cast<double>(frame->pts) * av_q2d(stream->time_base));
      played.frames.push_back(to_image(frame));
    }
  };
  while (av_read_frame(container, packet) == 0) {
    avcodec_send_packet(codec, packet);
    av_packet_unref(packet);
    receive();
  }
  avcodec_send_packet(codec, nullptr);
  receive();
  played.width = codec->width;
  played.height = codec->height;
  played.profile = codec->profile;
  played.format = codec->pix_fmt;
  played.range = codec->color_range;
  played.space = codec->colorspace;
  played.primaries = codec->color_primaries;
  played.transfer = codec->color_trc;
  av_frame_free(&frame);
  av_packet_free(&packet);
  avcodec_free_context(&codec);
  avformat_close_input(&container);
  return played;
}

using View = std::span<const std::uint8_t>;

int number(View bytes, std::size_t at, int count) {
  int value = 0;
  for (int k = count - 1; k >= 0; --k)
    value = value * 256 + bytes[at + static_cast<std::size_t>(k)];
  return value;
}

// Decodes one picture of an animated WebP as a separate file.
Image decode_webp(View chunks) {
  std::vector<std::uint8_t> file{'R', 'I', 'F', 'F'};
  for (int k = 0; k < 4; ++k)
    file.push_back(static_cast<std::uint8_t>((chunks.size() + 4) >> (8 * k)));
  for (const char c : {'W', 'E', 'B', 'P'}) file.push_back(static_cast<std::uint8_t>(c));
  file.insert(file.end(), chunks.begin(), chunks.end());
  const std::size_t size = file.size();
  file.resize(size + AV_INPUT_BUFFER_PADDING_SIZE);
  AVCodecContext* codec = avcodec_alloc_context3(avcodec_find_decoder(AV_CODEC_ID_WEBP));
  avcodec_open2(codec, codec->codec, nullptr);
  AVPacket* packet = av_packet_alloc();
  AVFrame* frame = av_frame_alloc();
  packet->data = file.data();
  packet->size = static_cast<int>(size);
  avcodec_send_packet(codec, packet);
  const int code = avcodec_receive_frame(codec, frame);
  Image image;
  if (code == 0) {
    // The format has limited-range BT.601, the default of the scaler.
    image = Image(frame->width, frame->height);
    SwsContext* scaler = sws_getContext(
        frame->width, frame->height, static_cast<AVPixelFormat>(frame->format), frame->width,
        frame->height, AV_PIX_FMT_BGRA, SWS_BICUBIC | SWS_ACCURATE_RND, nullptr, nullptr, nullptr);
    std::uint8_t* rows[] = {image.pixels.data()};
    const int strides[] = {image.stride()};
    sws_scale(scaler, frame->data, frame->linesize, 0, frame->height, rows, strides);
    sws_freeContext(scaler);
  }
  av_frame_free(&frame);
  av_packet_free(&packet);
  avcodec_free_context(&codec);
  return image;
}

// Lays a part over the canvas; alpha is 0 or 255 in our movies.
void lay_over(Image& canvas, const Image& part, int left, int top, bool blend) {
  for (int y = 0; y < part.height; ++y)
    for (int x = 0; x < part.width; ++x) {
      const auto* from = &part.pixels[static_cast<std::size_t>(y * part.stride() + 4 * x)];
      auto* to =
          &canvas.pixels[static_cast<std::size_t>((top + y) * canvas.stride() + 4 * (left + x))];
      if (!blend || from[3] >= 128) std::memcpy(to, from, 4);
    }
}

Played play_webp(const std::string& text) {
  Played played;
  const View all(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  const auto end = static_cast<std::size_t>(number(all, 4, 4)) + 8;
  EXPECT_LE(end, all.size());
  Image canvas;
  int ms = 0;
  for (std::size_t at = 12; at + 8 <= end;) {
    const std::string name = text.substr(at, 4);
    const auto size = static_cast<std::size_t>(number(all, at + 4, 4));
    EXPECT_LE(at + 8 + size, end);
    const View chunk = all.subspan(at + 8, size);
    if (name == "VP8X") {
      played.width = number(chunk, 4, 3) + 1;
      played.height = number(chunk, 7, 3) + 1;
      canvas = Image(played.width, played.height);
    } else if (name == "ANMF") {
      const Image part = decode_webp(chunk.subspan(16));
      EXPECT_EQ(part.width, number(chunk, 6, 3) + 1);
      EXPECT_EQ(part.height, number(chunk, 9, 3) + 1);
      lay_over(canvas, part, 2 * number(chunk, 0, 3), 2 * number(chunk, 3, 3),
               (chunk[15] & 2) == 0);
      EXPECT_EQ(chunk[15] & 1, 0) << "a frame is cleared away";
      played.frames.push_back(canvas);
      played.times.push_back(1e-3 * ms);
      ms += number(chunk, 12, 3);
    }
    at += 8 + size + size % 2;
  }
  played.seconds = 1e-3 * ms;
  return played;
}

}  // namespace

Played play(const std::filesystem::path& path) {
  return path.extension() == ".webp" ? play_webp(read_text(path)) : play_stream(path);
}

int difference(const Image& one, const Image& other) {
  if (one.width != other.width || one.height != other.height) return 256;
  int max = 0;
  for (std::size_t at = 0; at < one.pixels.size(); ++at)
    if (at % 4 != 3) max = std::max(max, std::abs(one.pixels[at] - other.pixels[at]));
  return max;
}

}  // namespace hackle::test
