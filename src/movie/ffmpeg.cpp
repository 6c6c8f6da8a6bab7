// SPDX-License-Identifier: MIT
#include "movie/ffmpeg.hpp"

#include <string>

#include <dlfcn.h>
#include <fmt/format.h>

#include "base/error.hpp"

namespace hackle::av {
namespace {

// The names under which Debian installs them: "libavcodec.so.59".
struct Libraries {
  std::string avformat = name_of("avformat", LIBAVFORMAT_VERSION_MAJOR);
  std::string avcodec = name_of("avcodec", LIBAVCODEC_VERSION_MAJOR);
  std::string swscale = name_of("swscale", LIBSWSCALE_VERSION_MAJOR);
  std::string avutil = name_of("avutil", LIBAVUTIL_VERSION_MAJOR);

  static std::string name_of(const char* library, int version) {
    return fmt::format("lib{}.so.{}", library, version);
  }
};

// Never closed: encoders leave threads and handlers behind.
template <class Function>
void load(const std::string& library, const char* name, Function& function) {
  void* handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle != nullptr) function = reinterpret_cast<Function>(dlsym(handle, name));
  if (function == nullptr)
    throw Error(ErrorKind::run_failed,
                fmt::format("movies need FFmpeg's {}, which cannot be loaded", library),
                "install FFmpeg's libraries, libavformat59 and libswscale6 on Debian 12");
}

Functions load_all() {
  const Libraries libraries;
  Functions functions;
#define HACKLE_FFMPEG_LOAD(library, name) load(libraries.library, #name, functions.name);
  HACKLE_FFMPEG_FUNCTIONS(HACKLE_FFMPEG_LOAD)
#undef HACKLE_FFMPEG_LOAD
  return functions;
}

}  // namespace

const Functions& ffmpeg() {
  static const Functions functions = load_all();
  return functions;
}

}  // namespace hackle::av
