// SPDX-License-Identifier: MIT
#include "render/gl_osmesa.hpp"

#include <array>

#include <GL/osmesa.h>

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
  constexpr std::array attributes{OSMESA_FORMAT,
                                  OSMESA_BGRA,
                                  OSMESA_PROFILE,
                                  OSMESA_CORE_PROFILE,
                                  OSMESA_CONTEXT_MAJOR_VERSION,
                                  3,
                                  OSMESA_CONTEXT_MINOR_VERSION,
                                  3,
                                  0};
  return OSMesaCreateContextAttribs(attributes.data(), nullptr);
}

class OsMesa : public GlBackEnd {
 public:
  explicit OsMesa(Image& image) : image_(image), context_(create()) {}

  bool make_current() override {
    if (!context_ || OSMesaMakeCurrent(context_.get(), image_.pixels.data(), GL_UNSIGNED_BYTE,
                                       image_.width, image_.height) != GL_TRUE)
      return false;
    OSMesaPixelStore(OSMESA_Y_UP, 0);
    return true;
  }
  Function function(const char* name) const override { return OSMesaGetProcAddress(name); }
  GLuint make_target(const GlFunctions&) override { return 0; }
  void read(const GlFunctions&, Image&) override {}

 private:
  Image& image_;
  std::unique_ptr<osmesa_context, Destroy> context_;
};

}  // namespace

std::unique_ptr<GlBackEnd> make_osmesa(Image& image) {
  return std::make_unique<OsMesa>(image);
}

}  // namespace hackle
