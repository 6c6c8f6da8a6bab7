// SPDX-License-Identifier: MIT
#include "movie/encoder.hpp"

#include <atomic>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "base/partial_file.hpp"
#include "base/stopwatch.hpp"
#include "base/worker.hpp"
#include "movie/ffmpeg.hpp"
#include "movie/make_film.hpp"

namespace hackle {
namespace {

constexpr std::size_t waiting_frames = 4;

}  // namespace

struct Encoder::Parts {
  Parts(const std::filesystem::path& path_, const MovieFormat& format_,
        std::unique_ptr<PartialFile> held)
      : path(path_),
        format(format_),
        partial(held ? std::move(held) : std::make_unique<PartialFile>(path_)),
        film(make_film(path_, format_)) {}

  std::filesystem::path path;
  MovieFormat format;
  std::unique_ptr<PartialFile> partial;
  std::unique_ptr<Film> film;
  std::optional<Image> last;  // to be repeated
  std::atomic<double> seconds = 0.0;
  int frames = 0;
  // Declared last, so that its thread ends before the objects it uses.
  Worker<Image> thread{waiting_frames, [this](Image image) { encode(std::move(image)); }};

  void encode(Image image) {
    double taken = 0.0;
    {
      const Stopwatch watch(taken);
      film->add(image);
    }
    seconds += taken;
    if (format.hold > 0.0) last = std::move(image);
  }

  void complete() {
    for (auto left = std::llround(format.hold * format.fps); last && left > 0; --left)
      film->repeat(*last);
    film->finish();
    publish(path);
  }
};

Encoder::Encoder(const std::filesystem::path& path, const MovieFormat& format,
                 std::unique_ptr<PartialFile> held) {
  check(path, format);
  parts_ = std::make_unique<Parts>(path, format, std::move(held));
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
    parts_->complete();
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
  return fmt::format("libavcodec {}, libavformat {}", dotted(LIBAVCODEC_VERSION_INT),
                     dotted(LIBAVFORMAT_VERSION_INT));
}

}  // namespace hackle
