// SPDX-License-Identifier: MIT
#include "movie/remux.hpp"

#include <algorithm>
#include <cerrno>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "movie/av.hpp"
#include "movie/movie_kind.hpp"

namespace hackle {
namespace fs = std::filesystem;
namespace {

av::Owner<AVFormatContext> open_to_read(const fs::path& path) {
  av::ffmpeg().av_log_set_level(AV_LOG_FATAL);  // a truncated file is expected
  AVFormatContext* context = nullptr;
  if (av::ffmpeg().avformat_open_input(&context, path.c_str(), nullptr, nullptr) < 0)
    return nullptr;
  av::Owner<AVFormatContext> input(context);
  if (av::ffmpeg().avformat_find_stream_info(context, nullptr) < 0 || context->nb_streams < 1)
    return nullptr;
  return input;
}

// Opens the output file, with a stream like that of the input.
av::Owner<AVFormatContext> open_to_write(const fs::path& path, const AVFormatContext& input,
                                         const fs::path& named) {
  const MovieKind& kind = movie_kind(named);
  AVFormatContext* context = nullptr;
  av::check(
      named, "open",
      av::ffmpeg().avformat_alloc_output_context2(&context, nullptr, kind.muxer, path.c_str()));
  av::Owner<AVFormatContext> output(context);
  const AVStream* from = input.streams[0];
  AVStream* to = av::ffmpeg().avformat_new_stream(context, nullptr);
  if (to == nullptr) av::fail(named, "open", AVERROR(ENOMEM));
  av::ffmpeg().avcodec_parameters_copy(to->codecpar, from->codecpar);
  to->codecpar->codec_tag = 0;
  to->time_base = from->time_base;
  to->avg_frame_rate = from->avg_frame_rate;
  av::ffmpeg().av_dict_copy(&context->metadata, input.metadata, 0);
  av::check(named, "create", av::ffmpeg().avio_open(&context->pb, path.c_str(), AVIO_FLAG_WRITE));
  av::Options options(kind.final_options);
  av::check(named, "write", av::ffmpeg().avformat_write_header(context, options.get()));
  return output;
}

void close(AVFormatContext& output, const fs::path& named) {
  av::check(named, "write", av::ffmpeg().av_write_trailer(&output));
  const int broken = output.pb->error;
  av::check(named, "write", av::ffmpeg().avio_closep(&output.pb));
  av::check(named, "write", broken);
}

// Visits every packet; the end of a truncated file may be an error, but everything before it is
// whole.
template <class Visit>
FilmLength for_each_packet(AVFormatContext& input, Visit visit) {
  FilmLength length;
  const double tick = av_q2d(input.streams[0]->time_base);
  const av::Owner<AVPacket> packet(av::ffmpeg().av_packet_alloc());
  for (; av::ffmpeg().av_read_frame(&input, packet.get()) >= 0;
       av::ffmpeg().av_packet_unref(packet.get())) {
    if (packet->stream_index != 0 || (packet->flags & AV_PKT_FLAG_CORRUPT) != 0) continue;
    ++length.frames;
    const double end = static_cast<double>(packet->pts + packet->duration) * tick;
    length.seconds = std::max(length.seconds, end);
    visit(*packet);
  }
  return length;
}

}  // namespace

FilmLength copy_film(const fs::path& from, const fs::path& to, const fs::path& named) {
  const auto input = open_to_read(from);
  if (!input) return {};
  const auto output = open_to_write(to, *input, named);
  const AVRational old_ticks = input->streams[0]->time_base;
  const FilmLength length = for_each_packet(*input, [&](AVPacket& packet) {
    av::ffmpeg().av_packet_rescale_ts(&packet, old_ticks, output->streams[0]->time_base);
    packet.pos = -1;
    av::check(named, "write", av::ffmpeg().av_interleaved_write_frame(output.get(), &packet));
  });
  close(*output, named);
  return length;
}

FilmLength length_of_film(const fs::path& path) {
  const auto input = open_to_read(path);
  return input ? for_each_packet(*input, [](const AVPacket&) {}) : FilmLength{};
}

FilmFacts facts_by_ffmpeg(const fs::path& path) {
  const auto input = open_to_read(path);
  if (!input) return {};
  const auto entry = [&](const char* key) -> std::string {
    const AVDictionaryEntry* found = av::ffmpeg().av_dict_get(input->metadata, key, nullptr, 0);
    return found == nullptr ? "" : found->value;
  };
  const AVCodecParameters& codec = *input->streams[0]->codecpar;
  return {codec.width, codec.height, for_each_packet(*input, [](const AVPacket&) {}),
          entry("title"), entry("comment")};
}

fs::path indexed_name(const fs::path& path) {
  return path.parent_path() /
         fmt::format(".{}.indexed{}", path.stem().string(), path.extension().string());
}

void put_index_first(const fs::path& path, std::int64_t frames) {
  const fs::path partial = partial_name(path);
  const fs::path indexed = indexed_name(path);
  std::error_code ignored;
  try {
    if (copy_film(partial, indexed, path).frames == frames) fs::rename(indexed, partial, ignored);
  } catch (const Error&) {  // no space for two files; the fragments also play
  }
  fs::remove(indexed, ignored);
}

}  // namespace hackle
