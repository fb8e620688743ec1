// Ranges of vertices drawn with one multi-draw call.
#pragma once

#include <cstdint>
#include <vector>

#include "render/gl/api.h"

namespace ryosen {

class VertexRuns {
 public:
  // Appends vertices, extending the last range if adjacent to it.
  void add(std::uint32_t first, std::uint32_t count) {
    const auto start = static_cast<GLint>(first);
    if (!first_.empty() && first_.back() + count_.back() == start) {
      count_.back() += static_cast<GLsizei>(count);
    } else {
      first_.push_back(start);
      count_.push_back(static_cast<GLsizei>(count));
    }
  }
  bool empty() const { return first_.empty(); }
  // Draws the ranges in order, as triangles.
  void draw() const {
    glMultiDrawArrays(GL_TRIANGLES, first_.data(), count_.data(), static_cast<GLsizei>(first_.size()));
  }

 private:
  std::vector<GLint> first_;
  std::vector<GLsizei> count_;
};

}  // namespace ryosen
