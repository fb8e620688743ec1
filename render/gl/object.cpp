#include "render/gl/object.h"

namespace ryosen {

void label_object(GLenum kind, GLuint id, const char* label) {
  if (GLAD_GL_KHR_debug && glObjectLabel) glObjectLabel(kind, id, -1, label);
}

}  // namespace ryosen
