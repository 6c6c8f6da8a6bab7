// SPDX-License-Identifier: MIT
// A movie of one stream in an FFmpeg container, written in fragments.
#pragma once

#include "movie/codec.hpp"
#include "movie/film.hpp"
#include "movie/movie_format.hpp"

namespace hackle {

class StreamFilm : public Film {
 public:
  StreamFilm(const std::filesystem::path& path, const MovieFormat& format);

  void add(const Image& image) override;
  void repeat(const Image& last) override;
  void finish() override;

 private:
  void open_container(const MovieKind& kind, const MovieFormat& format);
  void write_packets();
  void write_png_texts();

  std::filesystem::path path_;
  av::Owner<AVFormatContext> container_;
  std::unique_ptr<Codec> codec_;
  AVStream* stream_ = nullptr;  // owned by container_
  std::int64_t next_ = 0;
};

}  // namespace hackle
