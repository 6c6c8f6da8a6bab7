// SPDX-License-Identifier: MIT
// OpenGL objects that live as long as their C++ objects. The context of `gl` must be current in
// every call, including the destructor.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>

#include "render/colour_map.hpp"
#include "render/gl/gl_functions.hpp"

namespace hackle {

// A texture that is read texel by texel.
class Texture {
 public:
  explicit Texture(const GlFunctions& gl);
  ~Texture();
  Texture(const Texture&) = delete;
  Texture& operator=(const Texture&) = delete;

  // Binds it to the texture unit of this number, for sampler uniforms.
  void bind(GLint unit) const;
  // Sets values, rows from the bottom.
  void set_numbers(int width, int height, const float* numbers) const;
  void set_bytes(int width, int height, const std::uint8_t* bytes) const;  // 255 is read as 1
  void set_colours(int width, int height, const Colour* colours) const;
  void make_room(int width, int height) const;  // for colours with alpha, as a render target
  GLuint id() const { return id_; }

 private:
  void set(GLint stored, int width, int height, GLenum format, GLenum type,
           const void* pixels) const;
  const GlFunctions& gl_;
  GLuint id_ = 0;
};

// A render target other than the picture: a texture, or memory with several samples per pixel.
class Framebuffer {
 public:
  // Draws into the texture, whose size must be set.
  Framebuffer(const GlFunctions& gl, const Texture& texture);
  Framebuffer(const GlFunctions& gl, int width, int height, int samples);
  ~Framebuffer();
  Framebuffer(const Framebuffer&) = delete;
  Framebuffer& operator=(const Framebuffer&) = delete;

  GLuint id() const { return id_; }

 private:
  const GlFunctions& gl_;
  GLuint id_ = 0;
  GLuint memory_ = 0;
};

// The source of attributes and order of vertices. The core profile needs one bound even without
// attributes.
class VertexArray {
 public:
  explicit VertexArray(const GlFunctions& gl);
  ~VertexArray();
  VertexArray(const VertexArray&) = delete;
  VertexArray& operator=(const VertexArray&) = delete;

  void bind() const;
  // Sets attributes 0, 1, ... with the given numbers of components, one after another, vertex by
  // vertex.
  void set_vertices(std::span<const float> numbers, std::initializer_list<int> attributes);
  // Sets the order for glDrawElements.
  void set_order(std::span<const std::uint32_t> vertices);

 private:
  const GlFunctions& gl_;
  GLuint id_ = 0;
  GLuint vertices_ = 0, order_ = 0;
};

}  // namespace hackle
