// SPDX-License-Identifier: MIT
// Movies are decoded again and compared with what went in.
#include "movie/encoder.hpp"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libswscale/swscale.h>
}

#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "support/folder.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using test::fresh_folder;

Image plain(int width, int height, std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
  Image image(width, height);
  for (std::size_t at = 0; at < image.pixels.size(); at += 4) {
    image.pixels[at] = blue;
    image.pixels[at + 1] = green;
    image.pixels[at + 2] = red;
    image.pixels[at + 3] = 255;
  }
  return image;
}

// A square that moves a pixel a frame.
Image moving(int width, int height, int frame) {
  Image image = plain(width, height, 20, 30, 50);
  for (int y = 10; y < 40; ++y)
    for (int x = 10 + frame; x < 40 + frame; ++x) {
      auto* pixel = &image.pixels[static_cast<std::size_t>(y * image.stride() + 4 * x)];
      pixel[0] = pixel[1] = pixel[2] = 240;
    }
  return image;
}

// What a player sees of a movie.
struct Played {
  int width = 0, height = 0, profile = 0;
  AVPixelFormat format = AV_PIX_FMT_NONE;
  AVColorRange range = AVCOL_RANGE_UNSPECIFIED;
  AVColorSpace space = AVCOL_SPC_UNSPECIFIED;
  AVColorPrimaries primaries = AVCOL_PRI_UNSPECIFIED;
  AVColorTransferCharacteristic transfer = AVCOL_TRC_UNSPECIFIED;
  std::string title;
  std::vector<double> times;  // s
  std::vector<Image> frames;  // BGRA
  std::vector<std::size_t> keyframes;
};

Image to_image(const AVFrame* frame) {
  Image image(frame->width, frame->height);
  SwsContext* scaler =
      sws_getContext(frame->width, frame->height, AV_PIX_FMT_YUV420P, frame->width, frame->height,
                     AV_PIX_FMT_BGRA, SWS_BICUBIC | SWS_ACCURATE_RND, nullptr, nullptr, nullptr);
  const int* bt709 = sws_getCoefficients(SWS_CS_ITU709);
  sws_setColorspaceDetails(scaler, bt709, 0, bt709, 1, 0, 1 << 16, 1 << 16);
  std::uint8_t* rows[] = {image.pixels.data()};
  const int strides[] = {image.stride()};
  sws_scale(scaler, frame->data, frame->linesize, 0, frame->height, rows, strides);
  sws_freeContext(scaler);
  return image;
}

Played play(const fs::path& path) {
  Played played;
  AVFormatContext* container = nullptr;
  EXPECT_EQ(avformat_open_input(&container, path.c_str(), nullptr, nullptr), 0);
  if (container == nullptr) return played;
  avformat_find_stream_info(container, nullptr);
  const AVStream* stream = container->streams[0];
  const AVDictionaryEntry* title = av_dict_get(container->metadata, "title", nullptr, 0);
  if (title != nullptr) played.title = title->value;
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

MovieFormat format(int width, int height, double fps = 30.0) {
  MovieFormat format{width, height};
  format.fps = fps;
  return format;
}

TEST(Encoder, EveryFrameIsThereAtItsTime) {
  const fs::path path = fresh_folder() / "a.mp4";
  Encoder encoder(path, format(160, 90, 25.0));
  for (int k = 0; k < 70; ++k) encoder.add(moving(160, 90, k));
  EXPECT_EQ(encoder.frames(), 70);
  encoder.finish();
  const Played played = play(path);
  ASSERT_EQ(played.times.size(), 70U);
  for (std::size_t k = 0; k < 70; ++k)
    EXPECT_NEAR(played.times[k], static_cast<double>(k) / 25.0, 1e-4);
  EXPECT_GT(encoder.seconds(), 0.0);
}

// Where the square of moving() begins in a row that crosses it.
int left_end_of_square(const Image& image) {
  int x = 0;
  while (image.pixels[static_cast<std::size_t>(25 * image.stride() + 4 * x)] < 145) ++x;
  return x;
}

TEST(Encoder, FramesAreShownInTheOrderTheyWereGiven) {
  const fs::path path = fresh_folder() / "a.mp4";
  Encoder encoder(path, format(160, 90));
  for (int k = 0; k < 70; ++k) encoder.add(moving(160, 90, k));
  encoder.finish();
  const Played played = play(path);
  ASSERT_EQ(played.frames.size(), 70U);
  // The edge of the square is sharp: half-way between its colours it is where it was drawn.
  for (std::size_t k = 0; k < 70; ++k)
    EXPECT_EQ(left_end_of_square(played.frames[k]), 10 + static_cast<int>(k));
}

TEST(Encoder, TimesAreThoseOfARateThatIsNoWholeNumber) {
  const fs::path path = fresh_folder() / "a.mp4";
  Encoder encoder(path, format(64, 64, 29.97));
  for (int k = 0; k < 100; ++k) encoder.add(plain(64, 64, 1, 2, 3));
  encoder.finish();
  const Played played = play(path);
  ASSERT_EQ(played.times.size(), 100U);
  // The container counts in ticks of at most 0.1 ms.
  for (std::size_t k = 0; k < 100; ++k)
    EXPECT_NEAR(played.times[k], static_cast<double>(k) / 29.97, 1e-4);
}

TEST(Encoder, CanBeEnteredEveryTwoSeconds) {
  const fs::path path = fresh_folder() / "a.mp4";
  Encoder encoder(path, format(64, 64, 10.0));
  for (int k = 0; k < 45; ++k) encoder.add(plain(64, 64, 1, 2, 3));
  encoder.finish();
  EXPECT_THAT(play(path).keyframes, testing::ElementsAre(0, 20, 40));
}

TEST(Encoder, WritesWhatEveryPlayerTakes) {
  const fs::path path = fresh_folder() / "a.mp4";
  MovieFormat f = format(160, 90);
  f.title = "edge crack";
  Encoder encoder(path, f);
  encoder.add(moving(160, 90, 0));
  encoder.finish();
  const Played played = play(path);
  EXPECT_EQ(played.width, 160);
  EXPECT_EQ(played.height, 90);
  EXPECT_EQ(played.format, AV_PIX_FMT_YUV420P);
  EXPECT_EQ(played.profile, FF_PROFILE_H264_HIGH);
  EXPECT_EQ(played.range, AVCOL_RANGE_MPEG);
  EXPECT_EQ(played.space, AVCOL_SPC_BT709);
  EXPECT_EQ(played.primaries, AVCOL_PRI_BT709);
  EXPECT_EQ(played.transfer, AVCOL_TRC_BT709);
  EXPECT_EQ(played.title, "edge crack");
}

TEST(Encoder, KeepsColours) {
  const std::uint8_t colours[][3] = {
      {255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {36, 54, 79}, {240, 163, 92}};
  const fs::path path = fresh_folder() / "a.mp4";
  Encoder encoder(path, format(64, 64));
  for (const auto& c : colours) encoder.add(plain(64, 64, c[0], c[1], c[2]));
  encoder.finish();
  const Played played = play(path);
  ASSERT_EQ(played.frames.size(), std::size(colours));
  for (std::size_t k = 0; k < played.frames.size(); ++k) {
    const auto* pixel = &played.frames[k].pixels[4 * (32 * 64 + 32)];
    // 8-bit limited range rounds by 1 to 2; quantisation at crf 18 by another 1 to 2.
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(pixel[2 - c], colours[k][c], 3) << k << " " << c;
  }
}

TEST(Encoder, TheIndexComesFirstSoThatMoviesStartAtOnce) {
  const fs::path path = fresh_folder() / "a.mp4";
  Encoder encoder(path, format(64, 64));
  encoder.add(plain(64, 64, 1, 2, 3));
  encoder.finish();
  const std::string bytes = read_text(path);
  EXPECT_LT(bytes.find("moov"), bytes.find("mdat"));
}

TEST(Encoder, BearsItsNameOnlyWhenComplete) {
  const fs::path path = fresh_folder() / "a.mp4";
  {
    Encoder encoder(path, format(64, 64));
    encoder.add(plain(64, 64, 1, 2, 3));
    EXPECT_TRUE(fs::exists(partial_name(path)));
    EXPECT_FALSE(fs::exists(path));
  }
  EXPECT_FALSE(fs::exists(partial_name(path)));
  EXPECT_FALSE(fs::exists(path));
}

TEST(Encoder, AFailedMovieLeavesAnOlderOneAlone) {
  const fs::path path = fresh_folder() / "a.mp4";
  write_text(path, "old");
  { Encoder encoder(path, format(64, 64)); }
  EXPECT_EQ(read_text(path), "old");
}

TEST(Encoder, RefusesImpossibleFormats) {
  const fs::path path = fresh_folder() / "a.mp4";
  for (const MovieFormat& bad : {format(641, 360), format(640, 361), format(0, 0), format(99998, 2),
                                 format(64, 64, 0.0), format(64, 64, std::nan(""))}) {
    try {
      const Encoder encoder(path, bad);
      FAIL() << bad.width << " x " << bad.height << " at " << bad.fps;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::refused);
    }
  }
}

TEST(Encoder, AFolderThatIsNotThereIsAnError) {
  try {
    const Encoder encoder(fresh_folder() / "no" / "a.mp4", format(64, 64));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::files);
    EXPECT_THAT(error.what(), testing::HasSubstr("cannot create the movie"));
  }
}

TEST(Encoder, AFolderThatVanishesIsAnError) {
  const fs::path folder = fresh_folder();
  Encoder encoder(folder / "a.mp4", format(64, 64));
  encoder.add(plain(64, 64, 1, 2, 3));
  fs::remove_all(folder);
  try {
    encoder.finish();
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::files);
    EXPECT_THAT(error.what(), testing::HasSubstr("No such file or directory"));
  }
}

TEST(Encoder, RefusesAFrameOfAnotherSize) {
  Encoder encoder(fresh_folder() / "a.mp4", format(64, 64));
  EXPECT_THROW(encoder.add(plain(64, 32, 1, 2, 3)), Error);
}

TEST(Encoder, NamesEveryProblemAtOnce) {
  MovieFormat bad = format(641, 64, 0.0);
  bad.crf = 0;
  bad.threads = 0;
  try {
    const Encoder encoder(fresh_folder() / "a.mp4", bad);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.problems().size(), 4U);
    EXPECT_THAT(error.what(), testing::HasSubstr("the width is 641 px, it must be even"));
  }
}

TEST(Encoder, AFullDiskIsOneClearError) {
  // The partial file is a link to a device that is always full.
  const fs::path path = fresh_folder() / "a.mp4";
  fs::create_symlink("/dev/full", partial_name(path));
  try {
    Encoder encoder(path, format(64, 64));
    for (int k = 0; k < 2000; ++k) encoder.add(moving(64, 64, k % 20));
    encoder.finish();
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::files);
    EXPECT_THAT(error.what(), testing::HasSubstr("No space left on device"));
  }
  EXPECT_FALSE(fs::exists(path));
  EXPECT_FALSE(fs::is_symlink(partial_name(path)));
}

}  // namespace
}  // namespace hackle
