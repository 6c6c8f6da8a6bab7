// SPDX-License-Identifier: MIT
#include "render/gl/gl_osmesa.hpp"

#include <array>

#include <GL/osmesa.h>
#include <dlfcn.h>

namespace hackle {
namespace {

// The functions of OSMesa. The library, which also loads LLVM, is loaded with the first picture.
struct OsMesaFunctions {
  decltype(&OSMesaCreateContextAttribs) create_context = nullptr;
  decltype(&OSMesaDestroyContext) destroy_context = nullptr;
  decltype(&OSMesaMakeCurrent) make_current = nullptr;
  decltype(&OSMesaPixelStore) pixel_store = nullptr;
  decltype(&OSMesaGetProcAddress) find = nullptr;

  bool complete() const {
    return create_context != nullptr && destroy_context != nullptr && make_current != nullptr &&
           pixel_store != nullptr && find != nullptr;
  }
};

template <class Pointer>
void take(void* library, const char* name, Pointer& pointer) {
  pointer = reinterpret_cast<Pointer>(dlsym(library, name));
}

// Never closed: Mesa keeps its own threads and handlers in it.
OsMesaFunctions load_osmesa() {
  OsMesaFunctions mesa;
  void* library = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) return mesa;
  take(library, "OSMesaCreateContextAttribs", mesa.create_context);
  take(library, "OSMesaDestroyContext", mesa.destroy_context);
  take(library, "OSMesaMakeCurrent", mesa.make_current);
  take(library, "OSMesaPixelStore", mesa.pixel_store);
  take(library, "OSMesaGetProcAddress", mesa.find);
  return mesa;
}

const OsMesaFunctions& osmesa() {
  static const OsMesaFunctions functions = load_osmesa();
  return functions;
}

struct Destroy {
  void operator()(osmesa_context* context) const {
    // Unbound first: Mesa would keep writing into the buffer of a current context.
    osmesa().make_current(nullptr, nullptr, 0, 0, 0);
    osmesa().destroy_context(context);
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
  return osmesa().create_context(attributes.data(), nullptr);
}

class OsMesa : public GlBackEnd {
 public:
  explicit OsMesa(Image& image) : image_(image), context_(create()) {}

  bool make_current() override {
    if (!context_ || osmesa().make_current(context_.get(), image_.pixels.data(), GL_UNSIGNED_BYTE,
                                           image_.width, image_.height) != GL_TRUE)
      return false;
    osmesa().pixel_store(OSMESA_Y_UP, 0);
    return true;
  }
  Function function(const char* name) const override { return osmesa().find(name); }
  GLuint make_target(const GlFunctions&) override { return 0; }
  void read(const GlFunctions&, Image&) override {}

 private:
  Image& image_;
  std::unique_ptr<osmesa_context, Destroy> context_;
};

}  // namespace

std::unique_ptr<GlBackEnd> make_osmesa(Image& image) {
  if (!osmesa().complete()) return nullptr;
  return std::make_unique<OsMesa>(image);
}

}  // namespace hackle
