#include "render/gl/buffer.h"

#include <algorithm>

namespace ryosen {

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
