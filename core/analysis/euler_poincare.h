// The terms of V - E + F + B - H = 2(S - G), as the kernel counts them.
#pragma once

#include <cstdint>

#include "core/mesh/mesh.h"

namespace ryosen {

// Every copy of a point and every cut edge counts for itself, so the sum holds whatever was read.
struct EulerPoincare {
  std::int64_t vertices = 0;    // V
  std::int64_t edges = 0;       // E
  std::int64_t faces = 0;       // F
  std::int64_t boundaries = 0;  // B: cycles of `next` outside the faces; an isolated vertex is one
  std::int64_t rings = 0;       // H: inner loops of faces
  std::int64_t components = 0;  // S: parts joined by edges; an isolated vertex is one
  std::int64_t genus = 0;       // G: handles of all components together

  std::int64_t left() const { return vertices - edges + faces + boundaries - rings; }
  std::int64_t right() const { return 2 * (components - genus); }
  friend bool operator==(const EulerPoincare&, const EulerPoincare&) = default;
};

// O(edges).
EulerPoincare euler_poincare(const Mesh& mesh);

}  // namespace ryosen
