// SPDX-License-Identifier: MIT
#include "movie/av.hpp"

#include <array>
#include <cerrno>

#include <fmt/format.h>

#include "base/error.hpp"

namespace hackle::av {
namespace {

std::string text_of(int code) {
  std::array<char, AV_ERROR_MAX_STRING_SIZE> text{};
  ffmpeg().av_strerror(code, text.data(), text.size());
  return text.data();
}

const char* remedy_of(int code) {
  const bool full = code == AVERROR(ENOSPC) || code == AVERROR(EFBIG) || code == AVERROR(EDQUOT);
  return full ? "make room there, or choose another folder with -o" : "";
}

}  // namespace

void Free::operator()(AVFormatContext* context) const {
  if (context->iformat != nullptr) return ffmpeg().avformat_close_input(&context);
  if (context->pb != nullptr) ffmpeg().avio_closep(&context->pb);
  ffmpeg().avformat_free_context(context);
}

Options::Options(const std::string& text) {
  if (ffmpeg().av_dict_parse_string(&dictionary_, text.c_str(), "=", ":", 0) < 0)
    throw Error(ErrorKind::run_failed, fmt::format("'{}' are no options of FFmpeg", text));
}

void Options::require_all_taken() const {
  const AVDictionaryEntry* entry =
      ffmpeg().av_dict_get(dictionary_, "", nullptr, AV_DICT_IGNORE_SUFFIX);
  if (entry != nullptr)
    throw Error(ErrorKind::run_failed, fmt::format("FFmpeg ignores the option '{}'", entry->key));
}

void fail(const std::filesystem::path& path, const char* doing, int code) {
  throw Error(ErrorKind::files,
              fmt::format("cannot {} the movie '{}': {}", doing, path.string(), text_of(code)),
              remedy_of(code));
}

}  // namespace hackle::av
