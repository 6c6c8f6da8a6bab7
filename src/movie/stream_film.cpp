// SPDX-License-Identifier: MIT
#include "movie/stream_film.hpp"

#include <cerrno>
#include <string_view>
#include <utility>

#include "base/files.hpp"
#include "movie/png_text.hpp"
#include "movie/remux.hpp"

namespace hackle {
namespace {

av::Owner<AVFormatContext> container_of(const std::filesystem::path& path, const char* muxer) {
  AVFormatContext* container = nullptr;
  // The name of a partial file does not determine its format, so the muxer is named.
  const std::string name = partial_name(path).string();
  av::check(path, "open",
            av::ffmpeg().avformat_alloc_output_context2(&container, nullptr, muxer, name.c_str()));
  // Every complete packet goes to the file at once.
  container->flags |= AVFMT_FLAG_FLUSH_PACKETS;
  // Matroska numbers tracks and segments at random unless told otherwise.
  if (std::string_view(muxer) != "mp4") container->flags |= AVFMT_FLAG_BITEXACT;
  return av::Owner<AVFormatContext>(container);
}

}  // namespace

StreamFilm::StreamFilm(const std::filesystem::path& path, const MovieFormat& format) : path_(path) {
  const MovieKind& kind = movie_kind(path);
  container_ = container_of(path, kind.muxer);
  const bool global_header = (container_->oformat->flags & AVFMT_GLOBALHEADER) != 0;
  codec_ = std::make_unique<Codec>(path, format, global_header);
  open_container(kind, format);
}

void StreamFilm::open_container(const MovieKind& kind, const MovieFormat& format) {
  stream_ = av::ffmpeg().avformat_new_stream(container_.get(), nullptr);
  if (stream_ == nullptr) av::fail(path_, "open", AVERROR(ENOMEM));
  stream_->time_base = codec_->context().time_base;
  stream_->avg_frame_rate = codec_->context().framerate;
  av::ffmpeg().avcodec_parameters_from_context(stream_->codecpar, &codec_->context());
  for (const auto& [key, text] : {std::pair{"title", &format.title}, {"comment", &format.comment}})
    if (!text->empty()) av::ffmpeg().av_dict_set(&container_->metadata, key, text->c_str(), 0);

  av::check(path_, "create",
            av::ffmpeg().avio_open(&container_->pb, partial_name(path_).c_str(), AVIO_FLAG_WRITE));
  av::Options options(kind.muxer_options);
  av::check(path_, "write", av::ffmpeg().avformat_write_header(container_.get(), options.get()));
  options.require_all_taken();
}

void StreamFilm::add(const Image& image) {
  codec_->send(image, next_++);
  write_packets();
}

void StreamFilm::repeat(const Image&) {
  codec_->send_again(next_++);
  write_packets();
}

void StreamFilm::write_packets() {
  const AVRational frame = codec_->context().time_base;
  while (AVPacket* packet = codec_->receive()) {
    // write_header has chosen the stream's time base.
    av::ffmpeg().av_packet_rescale_ts(packet, frame, stream_->time_base);
    packet->duration = av::ffmpeg().av_rescale_q(1, frame, stream_->time_base);
    packet->stream_index = stream_->index;
    av::check(path_, "write", av::ffmpeg().av_interleaved_write_frame(container_.get(), packet));
    av::check(path_, "write", container_->pb->error);
  }
}

// FFmpeg does not write any by itself.
void StreamFilm::write_png_texts() {
  for (const auto& [keyword, key] : {std::pair{"Title", "title"}, {"Comment", "comment"}}) {
    const AVDictionaryEntry* entry =
        av::ffmpeg().av_dict_get(container_->metadata, key, nullptr, 0);
    if (entry == nullptr) continue;
    const Bytes chunk = png_text(keyword, entry->value);
    av::ffmpeg().avio_write(container_->pb, chunk.all().data(), static_cast<int>(chunk.size()));
  }
}

void StreamFilm::finish() {
  codec_->send_end();
  write_packets();
  const std::string_view kind = container_->oformat->name;
  if (kind == "apng") write_png_texts();
  av::check(path_, "write", av::ffmpeg().av_write_trailer(container_.get()));
  const int broken = container_->pb->error;
  const int closed = av::ffmpeg().avio_closep(&container_->pb);
  av::check(path_, "write", broken);
  av::check(path_, "write", closed);
  if (*movie_kind(path_).final_options != '\0') put_index_first(path_, next_);
}

}  // namespace hackle
