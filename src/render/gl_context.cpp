// SPDX-License-Identifier: MIT
#include "render/gl_context.hpp"

#include <cstdlib>
#include <string_view>

#include <GL/osmesa.h>

#include "base/error.hpp"

namespace hackle {
namespace {

struct Destroy {
  void operator()(osmesa_context* context) const {
    // Unbound first: Mesa would go on writing into the buffer of a current context.
    OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
    OSMesaDestroyContext(context);
  }
};

OSMesaContext create() {
  const char* driver = std::getenv("GALLIUM_DRIVER");
  if (driver != nullptr && std::string_view(driver) == "swr")
    throw Error(ErrorKind::run_failed, "GALLIUM_DRIVER=swr crashes in this version of Mesa",
                "unset it, or use llvmpipe or softpipe");
  const int attributes[] = {OSMESA_FORMAT,
                            OSMESA_BGRA,
                            OSMESA_PROFILE,
                            OSMESA_CORE_PROFILE,
                            OSMESA_CONTEXT_MAJOR_VERSION,
                            3,
                            OSMESA_CONTEXT_MINOR_VERSION,
                            3,
                            0};
  return OSMesaCreateContextAttribs(attributes, nullptr);
}

}  // namespace

struct GlContext::Parts {
  Parts(int width, int height) : image(width, height), context(create()) {}
  Image image;
  std::unique_ptr<osmesa_context, Destroy> context;  // after the image: it goes first
};

GlContext::GlContext(int width, int height) : parts_(std::make_unique<Parts>(width, height)) {
  make_current();
  OSMesaPixelStore(OSMESA_Y_UP, 0);
}

void GlContext::make_current() {
  Parts& parts = *parts_;
  if (parts.context &&
      OSMesaMakeCurrent(parts.context.get(), parts.image.pixels.data(), GL_UNSIGNED_BYTE,
                        parts.image.width, parts.image.height) == GL_TRUE)
    return;
  throw Error(ErrorKind::run_failed, "OSMesa gives no OpenGL 3.3 context",
              "install the Debian package libosmesa6");
}

GlContext::~GlContext() = default;

GlContext::Function GlContext::function(const char* name) {
  return OSMesaGetProcAddress(name);
}

const Image& GlContext::finish() {
  glFinish();  // the buffer is undefined before
  return parts_->image;
}

std::string GlContext::renderer() const {
  return reinterpret_cast<const char*>(glGetString(GL_RENDERER));
}

}  // namespace hackle
