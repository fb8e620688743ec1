#include "render/gl/buffer.h"

#include <algorithm>
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
  std::unique_ptr<void, Release> block(allocate_column(bytes + margin), {bytes + margin});
  while (glGetError() != GL_NO_ERROR) {
  }
  glBindBuffer(external_memory, buffer);
  glBufferData(external_memory, static_cast<GLsizeiptr>(bytes), block.get(), GL_DYNAMIC_DRAW);
  const bool is_taken = glGetError() == GL_NO_ERROR;
  glBindBuffer(external_memory, 0);
  if (is_taken) block_ = std::move(block);
  return is_taken;
}

void OwnMemory::Release::operator()(void* block) const {
  glFinish();  // what is being drawn may read it
  release_column(block, bytes);
}

bool Buffer::reserve(std::size_t bytes) {
  if (bytes <= capacity_) return false;
  // Geometric growth by 1/8 makes appending amortised O(1); what is written first is often all that will be.
  const std::size_t grown = std::max<std::size_t>(capacity_ == 0 ? bytes : bytes + bytes / 8, 256);
  OwnMemory memory;
  GlObject<BufferKind> larger(label_.c_str());
  const bool is_there = memory.put_under(larger.id(), grown);
  glBindBuffer(GL_COPY_WRITE_BUFFER, larger.id());
  if (!is_there) glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(grown), nullptr, GL_DYNAMIC_DRAW);
  if (capacity_ > 0) {
    glBindBuffer(GL_COPY_READ_BUFFER, object_.id());
    glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, static_cast<GLsizeiptr>(capacity_));
  }
  object_ = std::move(larger);
  memory_ = std::move(memory);
  capacity_ = grown;
  return true;
}

void Buffer::write(std::size_t offset, const void* data, std::size_t bytes) {
  glBindBuffer(GL_COPY_WRITE_BUFFER, object_.id());
  glBufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes), data);
}

void Buffer::read(std::size_t offset, void* data, std::size_t bytes) const {
  glBindBuffer(GL_COPY_READ_BUFFER, object_.id());
  glGetBufferSubData(GL_COPY_READ_BUFFER, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes), data);
}

void* Buffer::map(std::size_t offset, std::size_t bytes) {
  glBindBuffer(GL_COPY_WRITE_BUFFER, object_.id());
  return glMapBufferRange(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes),
                          GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_RANGE_BIT);
}

bool Buffer::unmap() {
  glBindBuffer(GL_COPY_WRITE_BUFFER, object_.id());  // another may have been bound meanwhile
  return glUnmapBuffer(GL_COPY_WRITE_BUFFER) == GL_TRUE;
}

}  // namespace ryosen
