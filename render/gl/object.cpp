#include "render/gl/object.h"

namespace ryosen {

void label_object(GLenum kind, GLuint id, const char* label) {
  if (GLAD_GL_KHR_debug && glObjectLabel) glObjectLabel(kind, id, -1, label);
}

// A buffer name becomes an object when first bound; only then can it be labelled.
GLuint BufferKind::create() {
  GLuint id = 0;
  glGenBuffers(1, &id);
  glBindBuffer(GL_COPY_WRITE_BUFFER, id);
  return id;
}
void BufferKind::destroy(GLuint id) { glDeleteBuffers(1, &id); }

GLuint TextureKind::create() {
  GLuint id = 0;
  glGenTextures(1, &id);
  glBindTexture(GL_TEXTURE_2D, id);
  return id;
}
void TextureKind::destroy(GLuint id) { glDeleteTextures(1, &id); }

GLuint BufferTextureKind::create() {
  GLuint id = 0;
  glGenTextures(1, &id);
  glBindTexture(GL_TEXTURE_BUFFER, id);
  return id;
}
void BufferTextureKind::destroy(GLuint id) { glDeleteTextures(1, &id); }

GLuint RenderbufferKind::create() {
  GLuint id = 0;
  glGenRenderbuffers(1, &id);
  glBindRenderbuffer(GL_RENDERBUFFER, id);
  return id;
}
void RenderbufferKind::destroy(GLuint id) { glDeleteRenderbuffers(1, &id); }

GLuint FramebufferKind::create() {
  GLuint id = 0;
  glGenFramebuffers(1, &id);
  glBindFramebuffer(GL_FRAMEBUFFER, id);
  return id;
}
void FramebufferKind::destroy(GLuint id) { glDeleteFramebuffers(1, &id); }

GLuint VertexArrayKind::create() {
  GLuint id = 0;
  glGenVertexArrays(1, &id);
  glBindVertexArray(id);
  return id;
}
void VertexArrayKind::destroy(GLuint id) { glDeleteVertexArrays(1, &id); }

}  // namespace ryosen
