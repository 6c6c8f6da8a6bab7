// SPDX-License-Identifier: MIT
#include "render/png_reader.hpp"

#include <fmt/format.h>
#include <png.h>

#include "base/error.hpp"

namespace hackle {
namespace {

// The reader of libpng, freed on every way out.
class Reader {
 public:
  explicit Reader(const std::filesystem::path& path) : path_(path) {
    image_.version = PNG_IMAGE_VERSION;
    png_image_begin_read_from_file(&image_, path.c_str());
    check();
  }
  ~Reader() { png_image_free(&image_); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  std::int64_t width() const { return image_.width; }
  std::int64_t height() const { return image_.height; }

  std::vector<std::uint8_t> grey() {
    image_.format = PNG_FORMAT_GRAY;
    std::vector<std::uint8_t> pixels(PNG_IMAGE_SIZE(image_));
    const png_color white{255, 255, 255};
    png_image_finish_read(&image_, &white, pixels.data(), 0, nullptr);
    check();
    return pixels;
  }

 private:
  void check() {
    if (!PNG_IMAGE_FAILED(image_)) return;
    const std::string message = image_.message;
    png_image_free(&image_);
    throw Error(ErrorKind::files,
                fmt::format("cannot read the picture '{}': {}", path_.string(), message),
                "it must be a PNG; its place is relative to the folder of the script");
  }

  std::filesystem::path path_;
  png_image image_{};
};

}  // namespace

GreyImage read_png(const std::filesystem::path& path) {
  if (std::filesystem::is_directory(path))
    throw Error(ErrorKind::files,
                fmt::format("cannot read the picture '{}': it is a folder", path.string()));
  Reader reader(path);
  if (reader.width() * reader.height() > most_pixels)
    throw Error(ErrorKind::refused,
                fmt::format("the picture '{}' has {} x {} pixels, the most is {}", path.string(),
                            reader.width(), reader.height(), most_pixels),
                "make it smaller; a pixel need not be finer than the spacing");
  GreyImage image{static_cast<int>(reader.width()), static_cast<int>(reader.height()), {}};
  image.pixels = reader.grey();
  return image;
}

}  // namespace hackle
