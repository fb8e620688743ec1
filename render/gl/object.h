// RAII for OpenGL objects: move-only, labelled for debuggers; destroy them in the context they were made in.
#pragma once

#include <utility>

#include "render/gl/api.h"

namespace ryosen {

// Sets the debug label of an object, if the driver supports it.
inline void label_object(GLenum kind, GLuint id, const char* label) {
  if (GLAD_GL_KHR_debug && glObjectLabel) glObjectLabel(kind, id, -1, label);
}

// An OpenGL object, or none. Kind provides creation and deletion.
template <class Kind>
class GlObject {
 public:
  GlObject() = default;
  explicit GlObject(const char* label) : id_(Kind::create()) { label_object(Kind::identifier, id_, label); }
  ~GlObject() { release(); }
  GlObject(GlObject&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    if (this != &other) {
      release();
      id_ = std::exchange(other.id_, 0);
    }
    return *this;
  }

  GLuint id() const { return id_; }

 private:
  void release() {
    if (id_ != 0) Kind::destroy(id_);
    id_ = 0;
  }

  GLuint id_ = 0;
};

// What makes and deletes a kind of object. A name becomes an object when it is first bound; only then can it be
// labelled.
template <GLenum kind, auto& generate, auto& remove, auto& bind, GLenum... target>
struct GlKind {
  static constexpr GLenum identifier = kind;
  static GLuint create() {
    GLuint id = 0;
    generate(1, &id);
    bind(target..., id);
    return id;
  }
  static void destroy(GLuint id) { remove(1, &id); }
};

using BufferKind = GlKind<GL_BUFFER, glGenBuffers, glDeleteBuffers, glBindBuffer, GL_COPY_WRITE_BUFFER>;
using TextureKind = GlKind<GL_TEXTURE, glGenTextures, glDeleteTextures, glBindTexture, GL_TEXTURE_2D>;
using BufferTextureKind = GlKind<GL_TEXTURE, glGenTextures, glDeleteTextures, glBindTexture, GL_TEXTURE_BUFFER>;
using RenderbufferKind =
    GlKind<GL_RENDERBUFFER, glGenRenderbuffers, glDeleteRenderbuffers, glBindRenderbuffer, GL_RENDERBUFFER>;
using FramebufferKind =
    GlKind<GL_FRAMEBUFFER, glGenFramebuffers, glDeleteFramebuffers, glBindFramebuffer, GL_FRAMEBUFFER>;
using VertexArrayKind = GlKind<GL_VERTEX_ARRAY, glGenVertexArrays, glDeleteVertexArrays, glBindVertexArray>;
using VertexArray = GlObject<VertexArrayKind>;

}  // namespace ryosen
