// SPDX-License-Identifier: MIT
#include "render/gl/gl_context.hpp"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/text.hpp"
#include "render/gl/gl_egl.hpp"
#include "render/gl/gl_osmesa.hpp"

namespace hackle {
namespace {

std::unique_ptr<GlBackEnd> back_end(GlLibrary library, Image& image) {
  const char* driver = std::getenv("GALLIUM_DRIVER");
  if (driver != nullptr && std::string_view(driver) == "swr")
    throw Error(ErrorKind::run_failed, "GALLIUM_DRIVER=swr crashes in this version of Mesa",
                "unset it, or use llvmpipe or softpipe");
  if (library == GlLibrary::egl) return make_egl(image.width, image.height);
  return make_osmesa(image);
}

}  // namespace

GlLibrary chosen_gl_library() {
  const char* wanted = std::getenv("HACKLE_GL");
  if (wanted == nullptr || *wanted == '\0') return GlLibrary::osmesa;
  const auto found = std::ranges::find(gl_library_names, wanted);
  if (found != gl_library_names.end())
    return static_cast<GlLibrary>(found - gl_library_names.begin());
  throw Error(ErrorKind::refused,
              fmt::format("HACKLE_GL is '{}'{}", wanted, did_you_mean(wanted, gl_library_names)),
              "one of " + comma_list(gl_library_names));
}

struct GlContext::Parts {
  Parts(int width, int height, GlLibrary library_)
      : library(library_), image(width, height), end(back_end(library_, image)) {}

  GlLibrary library;
  Image image;
  std::unique_ptr<GlBackEnd> end;  // declared after the image: destroyed first
  GlFunctions gl;
  GLuint target = 0;
};

GlContext::GlContext(int width, int height, GlLibrary library)
    : parts_(std::make_unique<Parts>(width, height, library)) {
  make_current();
  parts_->gl = load_gl_functions([this](const char* name) { return parts_->end->function(name); });
  parts_->target = parts_->end->make_target(parts_->gl);
}

GlContext::~GlContext() = default;

void GlContext::make_current() {
  if (parts_->end && parts_->end->make_current()) return;
  throw Error(ErrorKind::run_failed,
              fmt::format("{} gives no OpenGL 3.3 context",
                          gl_library_names[static_cast<std::size_t>(parts_->library)]),
              parts_->library == GlLibrary::osmesa
                  ? "install the Debian package libosmesa6, or set HACKLE_GL=egl"
                  : "install the Debian packages libegl1, libegl-mesa0 and libgl1-mesa-dri, or "
                    "unset HACKLE_GL");
}

const GlFunctions& GlContext::functions() const {
  return parts_->gl;
}

GLuint GlContext::target() const {
  return parts_->target;
}

const Image& GlContext::finish() {
  parts_->gl.Finish();  // pixels are undefined before this
  parts_->end->read(parts_->gl, parts_->image);
  return parts_->image;
}

std::string GlContext::renderer() const {
  return reinterpret_cast<const char*>(parts_->gl.GetString(GL_RENDERER));
}

}  // namespace hackle
