// RAII for OpenGL objects: move-only, labelled for debuggers; destroy them in the context they were made in.
#pragma once

#include <utility>

#include "render/gl/api.h"

namespace ryosen {

// Sets the debug label of an object, if the driver supports it.
void label_object(GLenum kind, GLuint id, const char* label);

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
  explicit operator bool() const { return id_ != 0; }

 private:
  void release() {
    if (id_ != 0) Kind::destroy(id_);
    id_ = 0;
  }

  GLuint id_ = 0;
};

struct BufferKind {
  static constexpr GLenum identifier = GL_BUFFER;
  static GLuint create();
  static void destroy(GLuint id);
};

struct TextureKind {
  static constexpr GLenum identifier = GL_TEXTURE;
  static GLuint create();
  static void destroy(GLuint id);
};

struct BufferTextureKind {
  static constexpr GLenum identifier = GL_TEXTURE;
  static GLuint create();
  static void destroy(GLuint id);
};

struct RenderbufferKind {
  static constexpr GLenum identifier = GL_RENDERBUFFER;
  static GLuint create();
  static void destroy(GLuint id);
};

struct FramebufferKind {
  static constexpr GLenum identifier = GL_FRAMEBUFFER;
  static GLuint create();
  static void destroy(GLuint id);
};

struct VertexArrayKind {
  static constexpr GLenum identifier = GL_VERTEX_ARRAY;
  static GLuint create();
  static void destroy(GLuint id);
};

using VertexArray = GlObject<VertexArrayKind>;

}  // namespace ryosen
