// SPDX-License-Identifier: MIT
#include "render/png_reader.hpp"

#include <system_error>

#include <fmt/format.h>
#include <png.h>

#include "base/error.hpp"

namespace hackle {
namespace {

// The reader of libpng, freed on every exit.
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
    png_image_free(&image_);
    // Messages of libpng may quote the file.
    throw Error(
        ErrorKind::files,
        fmt::format("cannot read the picture '{}': it is damaged or no PNG", path_.string()),
        "it must be a PNG; its place is relative to the folder of the script");
  }

  std::filesystem::path path_;
  png_image image_{};
};

void check_is_there(const std::filesystem::path& path) {
  const auto refuse = [&](const char* what) {
    throw Error(ErrorKind::files,
                fmt::format("cannot read the picture '{}': {}", path.string(), what),
                "it must be a PNG; its place is relative to the folder of the script");
  };
  std::error_code failure;
  if (!std::filesystem::exists(path, failure)) refuse("No such file");
  if (std::filesystem::is_directory(path, failure)) refuse("it is a folder");
  if (!std::filesystem::is_regular_file(path, failure)) refuse("it is no plain file");
}

void check_size(const std::filesystem::path& path, const Reader& reader) {
  if (reader.width() * reader.height() > max_pixels)
    throw Error(ErrorKind::refused,
                fmt::format("the picture '{}' has {} x {} pixels, the most is {}", path.string(),
                            reader.width(), reader.height(), max_pixels),
                "make it smaller; a pixel need not be finer than the spacing");
}

}  // namespace

PictureSize size_of_png(const std::filesystem::path& path) {
  check_is_there(path);
  const Reader reader(path);
  check_size(path, reader);
  return {static_cast<int>(reader.width()), static_cast<int>(reader.height())};
}

GreyImage read_png(const std::filesystem::path& path) {
  check_is_there(path);
  Reader reader(path);
  check_size(path, reader);
  GreyImage image{static_cast<int>(reader.width()), static_cast<int>(reader.height()), {}};
  image.pixels = reader.grey();
  return image;
}

}  // namespace hackle
