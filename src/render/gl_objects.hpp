// SPDX-License-Identifier: MIT
// Objects of OpenGL that live as long as their C++ objects. The context of `gl` must be current in
// every call, the destructor included.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>

#include "render/colour_map.hpp"
#include "render/gl_functions.hpp"

namespace hackle {

// A texture that is read texel by texel.
class Texture {
 public:
  explicit Texture(const GlFunctions& gl);
  ~Texture();
  Texture(const Texture&) = delete;
  Texture& operator=(const Texture&) = delete;

  // To the texture unit of that number, for sampler uniforms.
  void bind(GLint unit) const;
  // Rows from the bottom.
  void set_numbers(int width, int height, const float* numbers) const;
  void set_bytes(int width, int height, const std::uint8_t* bytes) const;  // 255 is read as 1
  void set_colours(int width, int height, const Colour* colours) const;
  void make_room(int width, int height) const;  // for colours with alpha, to be drawn into
  GLuint id() const { return id_; }

 private:
  void set(GLint stored, int width, int height, GLenum format, GLenum type,
           const void* pixels) const;
  const GlFunctions& gl_;
  GLuint id_ = 0;
};

// Where to draw that is not the picture: a texture, or memory with several samples a pixel.
class Framebuffer {
 public:
  // Draws into the texture, which has its size already.
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

// What the attributes and the order of vertices come from. Core profile wants one to be bound even
// where there are no attributes.
class VertexArray {
 public:
  explicit VertexArray(const GlFunctions& gl);
  ~VertexArray();
  VertexArray(const VertexArray&) = delete;
  VertexArray& operator=(const VertexArray&) = delete;

  void bind() const;
  // Attributes 0, 1, ... of so many numbers each, one after the other, vertex by vertex.
  void set_vertices(std::span<const float> numbers, std::initializer_list<int> attributes);
  // For glDrawElements.
  void set_order(std::span<const std::uint32_t> vertices);

 private:
  const GlFunctions& gl_;
  GLuint id_ = 0;
  GLuint vertices_ = 0, order_ = 0;
};

}  // namespace hackle
