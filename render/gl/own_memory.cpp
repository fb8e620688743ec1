#include "render/gl/own_memory.h"

#include <cstring>
#include <string_view>

#include "ryosen/base/column_memory.h"

namespace ryosen {
namespace {

constexpr GLenum external_memory = 0x9160;  // GL_EXTERNAL_VIRTUAL_MEMORY_BUFFER_AMD

// Drivers of graphics cards may take it as well, and then read it over the bus.
bool draws_with_the_processor() {
  const GLubyte* const name = glGetString(GL_RENDERER);
  return name && std::string_view(reinterpret_cast<const char*>(name)).starts_with("llvmpipe");
}

bool takes_memory() {
  if (!draws_with_the_processor()) return false;
  GLint count = 0;
  glGetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLint i = 0; i < count; ++i) {
    const GLubyte* const name = glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i));
    if (name && std::strcmp(reinterpret_cast<const char*>(name), "GL_AMD_pinned_memory") == 0) return true;
  }
  return false;
}

}  // namespace

bool OwnMemory::put_under(GLuint buffer, std::size_t bytes) {
  if (bytes < large_block || !takes_memory()) return false;
  constexpr std::size_t margin = 256;  // what is read behind the end of a buffer, several values at once
  OwnMemory memory;
  memory.block_ = allocate_column(bytes + margin);
  memory.bytes_ = bytes + margin;
  while (glGetError() != GL_NO_ERROR) {
  }
  glBindBuffer(external_memory, buffer);
  glBufferData(external_memory, static_cast<GLsizeiptr>(bytes), memory.block_, GL_DYNAMIC_DRAW);
  const bool is_taken = glGetError() == GL_NO_ERROR;
  glBindBuffer(external_memory, 0);
  if (is_taken) *this = std::move(memory);
  return is_taken;
}

void OwnMemory::release() {
  if (!block_) return;
  glFinish();  // what is being drawn may read it
  release_column(block_, bytes_);
  block_ = nullptr;
}

}  // namespace ryosen
