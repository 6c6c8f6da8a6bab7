// SPDX-License-Identifier: MIT
#include "render/gl/gl_egl.hpp"

#include <array>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>

namespace hackle {
namespace {

// The functions of EGL in the library found; null if missing.
struct EglFunctions {
  PFNEGLGETPROCADDRESSPROC find = nullptr;
  PFNEGLGETPLATFORMDISPLAYPROC get_display = nullptr;
  PFNEGLINITIALIZEPROC initialize = nullptr;
  PFNEGLBINDAPIPROC bind_api = nullptr;
  PFNEGLCREATECONTEXTPROC create_context = nullptr;
  PFNEGLDESTROYCONTEXTPROC destroy_context = nullptr;
  PFNEGLMAKECURRENTPROC make_current = nullptr;

  bool complete() const {
    return find != nullptr && get_display != nullptr && initialize != nullptr &&
           bind_api != nullptr && create_context != nullptr && destroy_context != nullptr &&
           make_current != nullptr;
  }
};

template <class Pointer>
void take(PFNEGLGETPROCADDRESSPROC find, const char* name, Pointer& pointer) {
  pointer = reinterpret_cast<Pointer>(find(name));
}

// Never closed: Mesa keeps its own threads and handlers in it.
EglFunctions load_egl() {
  EglFunctions egl;
  void* library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) return egl;
  egl.find = reinterpret_cast<PFNEGLGETPROCADDRESSPROC>(dlsym(library, "eglGetProcAddress"));
  if (egl.find == nullptr) return egl;
  take(egl.find, "eglGetPlatformDisplay", egl.get_display);
  take(egl.find, "eglInitialize", egl.initialize);
  take(egl.find, "eglBindAPI", egl.bind_api);
  take(egl.find, "eglCreateContext", egl.create_context);
  take(egl.find, "eglDestroyContext", egl.destroy_context);
  take(egl.find, "eglMakeCurrent", egl.make_current);
  return egl;
}

class Egl : public GlBackEnd {
 public:
  Egl(const EglFunctions& egl, EGLDisplay display, EGLContext context, int width, int height)
      : egl_(egl), display_(display), context_(context), width_(width), height_(height) {}
  // Also deletes the target.
  ~Egl() override {
    egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    egl_.destroy_context(display_, context_);
  }
  Egl(const Egl&) = delete;
  Egl& operator=(const Egl&) = delete;

  bool make_current() override {
    return egl_.bind_api(EGL_OPENGL_API) == EGL_TRUE &&
           egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
  }
  Function function(const char* name) const override { return egl_.find(name); }

  GLuint make_target(const GlFunctions& gl) override {
    GLuint pixels = 0;
    gl.GenRenderbuffers(1, &pixels);
    gl.BindRenderbuffer(GL_RENDERBUFFER, pixels);
    gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, 0, GL_RGBA8, width_, height_);
    gl.GenFramebuffers(1, &target_);
    gl.BindFramebuffer(GL_FRAMEBUFFER, target_);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, pixels);
    return target_;
  }

  void read(const GlFunctions& gl, Image& image) override {
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, target_);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    // OpenGL counts rows from the bottom.
    for (int y = 0; y < height_; ++y)
      gl.ReadPixels(
          0, height_ - 1 - y, width_, 1, GL_BGRA, GL_UNSIGNED_BYTE,
          &image.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.stride())]);
  }

 private:
  EglFunctions egl_;
  EGLDisplay display_;
  EGLContext context_;
  int width_, height_;
  GLuint target_ = 0;
};

}  // namespace

std::unique_ptr<GlBackEnd> make_egl(int width, int height) {
  static const EglFunctions egl = load_egl();
  if (!egl.complete()) return nullptr;
  EGLDisplay display = egl.get_display(EGL_PLATFORM_SURFACELESS_MESA,
                                       reinterpret_cast<void*>(EGL_DEFAULT_DISPLAY), nullptr);
  if (display == EGL_NO_DISPLAY || egl.initialize(display, nullptr, nullptr) != EGL_TRUE ||
      egl.bind_api(EGL_OPENGL_API) != EGL_TRUE)
    return nullptr;
  constexpr std::array<EGLint, 7> attributes{EGL_CONTEXT_MAJOR_VERSION,
                                             3,
                                             EGL_CONTEXT_MINOR_VERSION,
                                             3,
                                             EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                             EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                             EGL_NONE};
  EGLContext context =
      egl.create_context(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
  if (context == EGL_NO_CONTEXT) return nullptr;
  return std::make_unique<Egl>(egl, display, context, width, height);
}

}  // namespace hackle
