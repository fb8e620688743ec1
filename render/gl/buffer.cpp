#include "render/gl/buffer.h"

#include <algorithm>

namespace ryosen {

bool Buffer::reserve(std::size_t bytes) {
  if (bytes <= capacity_) return false;
  // Geometric growth by 1/8 makes appending amortised O(1).
  const std::size_t grown = std::max<std::size_t>(bytes + bytes / 8, 256);
  GlObject<BufferKind> larger(label_.c_str());
  glBindBuffer(GL_COPY_WRITE_BUFFER, larger.id());
  glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(grown), nullptr, GL_DYNAMIC_DRAW);
  if (capacity_ > 0) {
    glBindBuffer(GL_COPY_READ_BUFFER, object_.id());
    glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, static_cast<GLsizeiptr>(capacity_));
  }
  object_ = std::move(larger);
  capacity_ = grown;
  return true;
}

void Buffer::write(std::size_t offset, const void* data, std::size_t bytes) {
  glBindBuffer(GL_COPY_WRITE_BUFFER, object_.id());
  glBufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes), data);
}

}  // namespace ryosen
