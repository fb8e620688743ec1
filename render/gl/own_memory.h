// Memory of this process that a buffer of the driver lies in.
#pragma once

#include <cstddef>
#include <utility>

#include "render/gl/api.h"

namespace ryosen {

// A driver that draws with the processor takes a buffer's memory page by page and clears it; here the pages are large
// ones, and nothing is cleared. It ends behind the buffer, and in its context.
class OwnMemory {
 public:
  OwnMemory() = default;
  ~OwnMemory() { release(); }
  OwnMemory(OwnMemory&& other) noexcept
      : block_(std::exchange(other.block_, nullptr)), bytes_(std::exchange(other.bytes_, 0)) {}
  OwnMemory& operator=(OwnMemory&& other) noexcept {
    if (this == &other) return *this;
    release();
    block_ = std::exchange(other.block_, nullptr);
    bytes_ = std::exchange(other.bytes_, 0);
    return *this;
  }

  // Gives a new buffer this size; false where the driver does not take such memory, or a small buffer does not need it.
  bool put_under(GLuint buffer, std::size_t bytes);

 private:
  void release();

  void* block_ = nullptr;
  std::size_t bytes_ = 0;
};

}  // namespace ryosen
