// SPDX-License-Identifier: MIT
#include "movie/webp_film.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "base/markup.hpp"

namespace hackle {
namespace {

using View = std::span<const std::uint8_t>;

constexpr std::size_t riff_head = 12, chunk_head = 8, frame_head = 16;  // bytes
constexpr std::size_t duration_at = 12, flags_at = 15;                  // in a frame's head
constexpr std::uint8_t cover_what_was = 0x02;
constexpr int animated = 0x02, with_xmp = 0x04, with_alpha = 0x10;
constexpr std::int64_t features_at = 20;  // in the file
constexpr std::size_t size_at = 24;       // likewise: width - 1 and height - 1, 3 bytes each

std::uint64_t number_at(View bytes, std::size_t at, int count) {
  std::uint64_t value = 0;
  for (int k = count - 1; k >= 0; --k)
    value = (value << 8) | bytes[at + static_cast<std::size_t>(k)];
  return value;
}

bool is(View chunk, std::string_view name) {
  return std::equal(name.begin(), name.end(), chunk.begin());
}

// Removes and returns the first chunk, with its head and its padding byte.
View take_chunk(View& bytes) {
  const std::size_t size = number_at(bytes, 4, 4);
  const View chunk = bytes.first(std::min(bytes.size(), chunk_head + size + size % 2));
  bytes = bytes.subspan(chunk.size());
  return chunk;
}

// A frame of the animation: its position, its duration, and its picture as chunks.
struct Frame {
  std::array<std::uint8_t, frame_head> head{};
  View picture;

  std::int64_t duration() const {
    return static_cast<std::int64_t>(number_at(head, duration_at, 3));
  }
  void show_for(std::int64_t ms) {
    for (std::size_t k = 0; k < 3; ++k)
      head[duration_at + k] = static_cast<std::uint8_t>(ms >> (8 * k));
  }
};

// A picture that never changes is encoded without animation.
Frame still(View picture, int width, int height) {
  Frame frame{.picture = picture};
  const Bytes size = Bytes().number(0, 6).number(width - 1, 3).number(height - 1, 3);
  std::ranges::copy(size.all(), frame.head.begin());
  return frame;
}

std::vector<Frame> frames_of(View animation, int width, int height) {
  std::vector<Frame> frames;
  for (View left = animation.subspan(riff_head); left.size() > chunk_head;) {
    const View rest = left;
    const View chunk = take_chunk(left);
    if (is(chunk, "VP8 ") || is(chunk, "VP8L") || is(chunk, "ALPH"))
      return {still(rest, width, height)};
    if (!is(chunk, "ANMF") || chunk.size() < chunk_head + frame_head) continue;
    Frame& frame = frames.emplace_back();
    std::ranges::copy(chunk.subspan(chunk_head, frame_head), frame.head.begin());
    frame.picture = chunk.subspan(chunk_head + frame_head);
  }
  return frames;
}

std::int64_t ms_of(std::int64_t frame, double fps) {
  return std::llround(1000.0 * static_cast<double>(frame) / fps);
}

// Title and comment as Dublin Core.
std::string xmp(const MovieFormat& format) {
  const auto property = [](const char* name, const std::string& text) {
    return fmt::format(
        R"(<dc:{0}><rdf:Alt><rdf:li xml:lang="x-default">{1}</rdf:li></rdf:Alt></dc:{0}>)", name,
        xml(text));
  };
  return R"(<x:xmpmeta xmlns:x="adobe:ns:meta/">)"
         R"(<rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#">)"
         R"(<rdf:Description rdf:about="" xmlns:dc="http://purl.org/dc/elements/1.1/">)" +
         property("title", format.title) + property("description", format.comment) +
         "</rdf:Description></rdf:RDF></x:xmpmeta>";
}

// Returns a property that xmp() wrote.
std::string property_in(std::string_view text, std::string_view name) {
  constexpr std::string_view before = "x-default\">", after = "</rdf:li>";
  const std::size_t place = text.find(fmt::format("<dc:{}>", name));
  const std::size_t begin = text.find(before, place);
  const std::size_t end = text.find(after, begin);
  if (place == text.npos || begin == text.npos || end == text.npos) return {};
  return from_xml(text.substr(begin + before.size(), end - begin - before.size()));
}

Bytes size_bytes(std::int64_t file_size) {
  return Bytes().number(static_cast<std::uint64_t>(file_size) - chunk_head, 4);
}

}  // namespace

WebpFilm::WebpFilm(const std::filesystem::path& path, const MovieFormat& format)
    : path_(path), format_(format), file_(path) {
  write_head();
}

void WebpFilm::write_head() {
  Bytes head;
  head.add("RIFF").number(0, 4).add("WEBP");
  head.add("VP8X").number(10, 4).number(animated | with_alpha, 4);
  head.number(format_.width - 1, 3).number(format_.height - 1, 3);
  head.add("ANIM").number(6, 4).number(0, 4).number(0, 2);  // loops for ever
  file_.append(head);
  file_.write(size_bytes(file_.size()), 4);
}

void WebpFilm::add(const Image& image) {
  if (!chapter_) chapter_.emplace(path_, format_, false);
  chapter_->send(image, next_++);
  if (static_cast<double>(next_ - chapter_at_) >= format_.fps) end_chapter();
}

void WebpFilm::end_chapter() {
  chapter_->send_end();
  while (const AVPacket* packet = chapter_->receive())
    write_chapter(View(packet->data, static_cast<std::size_t>(packet->size)));
  chapter_.reset();
  chapter_at_ = next_;
}

void WebpFilm::write_chapter(View animation) {
  std::vector<Frame> frames = frames_of(animation, format_.width, format_.height);
  if (frames.empty()) throw Error(ErrorKind::run_failed, "movie: the WebP encoder gave no frames");
  // The encoder can only guess the duration of its last frame.
  std::int64_t left = ms_of(next_, format_.fps) - ms_of(chapter_at_, format_.fps);
  for (const Frame& frame : std::span(frames).first(frames.size() - 1)) left -= frame.duration();
  frames.back().show_for(left);
  frames.front().head[flags_at] |= cover_what_was;
  Bytes bytes;
  for (const Frame& frame : frames) {
    bytes.add("ANMF").number(frame_head + frame.picture.size(), 4);
    bytes.add(frame.head).add(frame.picture);
  }
  file_.append(bytes);
  file_.write(size_bytes(file_.size()), 4);
}

void WebpFilm::write_metadata() {
  const std::string text = xmp(format_);
  Bytes chunk;
  chunk.add("XMP ").number(text.size(), 4).add(text).number(0, static_cast<int>(text.size() % 2));
  file_.append(chunk);
  file_.write(size_bytes(file_.size()), 4);
  file_.write(Bytes().number(animated | with_xmp | with_alpha, 1), features_at);
}

void WebpFilm::finish() {
  if (chapter_) end_chapter();
  if (!format_.title.empty() || !format_.comment.empty()) write_metadata();
  file_.close();
}

FilmLength copy_webp(const std::filesystem::path& from, const std::filesystem::path& to) {
  const std::string text = read_text(from);
  const View all(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  if (all.size() < riff_head) return {};
  // Bytes beyond the size in the head were being written.
  const View whole = all.first(std::min(all.size(), chunk_head + number_at(all, 4, 4)));
  FilmLength length;
  for (const Frame& frame : frames_of(whole, 1, 1)) {
    ++length.frames;
    length.seconds += 1e-3 * static_cast<double>(frame.duration());
  }
  std::filesystem::copy_file(from, to, std::filesystem::copy_options::overwrite_existing);
  std::filesystem::resize_file(to, whole.size());
  return length;
}

FilmFacts facts_of_webp(const std::filesystem::path& path) {
  const std::string text = read_text(path);
  const View all(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  if (all.size() < size_at + 6 || !is(all, "RIFF") || !is(all.subspan(8), "WEBP")) return {};
  FilmFacts facts;
  facts.width = static_cast<int>(number_at(all, size_at, 3)) + 1;
  facts.height = static_cast<int>(number_at(all, size_at + 3, 3)) + 1;
  for (const Frame& frame : frames_of(all, facts.width, facts.height)) {
    ++facts.length.frames;
    facts.length.seconds += 1e-3 * static_cast<double>(frame.duration());
  }
  for (View left = all.subspan(riff_head); left.size() > chunk_head;) {
    const View chunk = take_chunk(left);
    if (!is(chunk, "XMP ")) continue;
    const std::string_view xmp(reinterpret_cast<const char*>(chunk.data()), chunk.size());
    facts.title = property_in(xmp, "title");
    facts.comment = property_in(xmp, "description");
  }
  return facts;
}

}  // namespace hackle
