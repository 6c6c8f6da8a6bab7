// SPDX-License-Identifier: MIT
#include "render/gl/gl_objects.hpp"

#include <numeric>

namespace hackle {

Texture::Texture(const GlFunctions& gl) : gl_(gl) {
  gl_.GenTextures(1, &id_);
  gl_.BindTexture(GL_TEXTURE_2D, id_);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl_.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    gl_.TexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
}

Texture::~Texture() {
  gl_.DeleteTextures(1, &id_);
}

void Texture::bind(GLint unit) const {
  gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  gl_.BindTexture(GL_TEXTURE_2D, id_);
}

void Texture::set_numbers(int width, int height, const float* numbers) const {
  set(GL_R32F, width, height, GL_RED, GL_FLOAT, numbers);
}

void Texture::set_bytes(int width, int height, const std::uint8_t* bytes) const {
  set(GL_R8, width, height, GL_RED, GL_UNSIGNED_BYTE, bytes);
}

void Texture::set_colours(int width, int height, const Colour* colours) const {
  set(GL_RGB8, width, height, GL_RGB, GL_UNSIGNED_BYTE, colours);
}

void Texture::make_room(int width, int height) const {
  set(GL_RGBA8, width, height, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
}

void Texture::set(GLint stored, int width, int height, GLenum format, GLenum type,
                  const void* pixels) const {
  gl_.BindTexture(GL_TEXTURE_2D, id_);
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, stored, width, height, 0, format, type, pixels);
}

Framebuffer::Framebuffer(const GlFunctions& gl, const Texture& texture) : gl_(gl) {
  gl_.GenFramebuffers(1, &id_);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, id_);
  gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.id(), 0);
}

Framebuffer::Framebuffer(const GlFunctions& gl, int width, int height, int samples) : gl_(gl) {
  gl_.GenRenderbuffers(1, &memory_);
  gl_.BindRenderbuffer(GL_RENDERBUFFER, memory_);
  gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_RGBA8, width, height);
  gl_.GenFramebuffers(1, &id_);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, id_);
  gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, memory_);
}

Framebuffer::~Framebuffer() {
  gl_.DeleteFramebuffers(1, &id_);
  if (memory_ != 0) gl_.DeleteRenderbuffers(1, &memory_);
}

VertexArray::VertexArray(const GlFunctions& gl) : gl_(gl) {
  gl_.GenVertexArrays(1, &id_);
}

VertexArray::~VertexArray() {
  for (const GLuint& buffer : {vertices_, order_})
    if (buffer != 0) gl_.DeleteBuffers(1, &buffer);
  gl_.DeleteVertexArrays(1, &id_);
}

void VertexArray::bind() const {
  gl_.BindVertexArray(id_);
}

void VertexArray::set_vertices(std::span<const float> numbers,
                               std::initializer_list<int> attributes) {
  bind();
  if (vertices_ == 0) gl_.GenBuffers(1, &vertices_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_);
  gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(numbers.size_bytes()), numbers.data(),
                 GL_STREAM_DRAW);
  constexpr std::size_t size = sizeof(float);
  const std::size_t all = std::accumulate(attributes.begin(), attributes.end(), std::size_t{0});
  GLuint attribute = 0;
  std::size_t before = 0;
  for (const int count : attributes) {
    // OpenGL takes an offset as a pointer. NOLINTNEXTLINE(performance-no-int-to-ptr)
    const auto* offset = reinterpret_cast<const void*>(before * size);
    gl_.VertexAttribPointer(attribute, count, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(all * size),
                            offset);
    gl_.EnableVertexAttribArray(attribute++);
    before += static_cast<std::size_t>(count);
  }
}

void VertexArray::set_order(std::span<const std::uint32_t> vertices) {
  bind();
  if (order_ == 0) gl_.GenBuffers(1, &order_);
  gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, order_);
  gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size_bytes()),
                 vertices.data(), GL_STREAM_DRAW);
}

}  // namespace hackle
