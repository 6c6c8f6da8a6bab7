// SPDX-License-Identifier: MIT
#include "movie/encoder.hpp"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
}

#include <atomic>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "base/stopwatch.hpp"
#include "base/units.hpp"
#include "base/worker.hpp"
#include "movie/video_stream.hpp"

namespace hackle {
namespace {

constexpr std::size_t waiting_frames = 4;
constexpr int most_pixels = 16384;  // a side; x264 takes no more

void check(const MovieFormat& format) {
  Problems problems;
  for (const auto& [name, size] : {std::pair{"width", format.width}, {"height", format.height}})
    if (size < 2 || size > most_pixels || size % 2 != 0)
      problems.add(fmt::format("movie: the {} is {} px, it must be even and between 2 and {} px",
                               name, size, most_pixels));
  if (!(format.fps >= 0.1 && format.fps <= 1000.0))
    problems.add(
        fmt::format("movie: fps is {}, it must lie between 0.1 and 1000", shortest(format.fps)));
  if (format.crf < 1 || format.crf > 51)
    problems.add(fmt::format("movie: crf is {}, it must lie between 1 and 51", format.crf));
  if (format.threads < 1)
    problems.add(fmt::format("movie: threads is {}, it must be at least 1", format.threads));
  problems.throw_if_any();
}

// Leaves no partial file behind, whatever happens: after publish() there is none.
struct PartialFile {
  std::filesystem::path path;

  ~PartialFile() {
    std::error_code ignored;
    std::filesystem::remove(partial_name(path), ignored);
  }
};

}  // namespace

struct Encoder::Parts {
  Parts(const std::filesystem::path& path_, const MovieFormat& format_)
      : path(path_), format(format_), partial{path_}, stream(path_, format_) {}

  std::filesystem::path path;
  MovieFormat format;
  PartialFile partial;
  VideoStream stream;
  std::atomic<double> seconds = 0.0;
  int frames = 0;
  // Last, so that its thread ends before what it works on.
  Worker<Image> thread{waiting_frames, [this](const Image& image) { encode(image); }};

  void encode(const Image& image) {
    double taken = 0.0;
    {
      const Stopwatch watch(taken);
      stream.add(image);
    }
    seconds += taken;
  }
};

Encoder::Encoder(const std::filesystem::path& path, const MovieFormat& format) {
  check(format);
  parts_ = std::make_unique<Parts>(path, format);
}

Encoder::~Encoder() = default;

void Encoder::add(Image frame) {
  if (frame.width != parts_->format.width || frame.height != parts_->format.height)
    throw Error(ErrorKind::run_failed, "movie: a frame has another size than the movie");
  parts_->thread.push(std::move(frame));
  ++parts_->frames;
}

void Encoder::finish() {
  parts_->thread.finish();
  double taken = 0.0;
  {
    const Stopwatch watch(taken);
    parts_->stream.finish();
    publish(parts_->path);
  }
  parts_->seconds += taken;
}

int Encoder::frames() const {
  return parts_->frames;
}
double Encoder::seconds() const {
  return parts_->seconds;
}

std::string Encoder::library_version() {
  const auto dotted = [](unsigned version) {
    return fmt::format("{}.{}.{}", AV_VERSION_MAJOR(version), AV_VERSION_MINOR(version),
                       AV_VERSION_MICRO(version));
  };
  return fmt::format("libavcodec {}, libavformat {}", dotted(avcodec_version()),
                     dotted(avformat_version()));
}

}  // namespace hackle
