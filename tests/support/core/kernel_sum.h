// The terms of V - E + F + B - H = 2(S - G) as the kernel's own elements give them: every copy of a point and every cut
// edge counts for itself. This is what operators say of themselves.
#pragma once

#include <cstdint>

#include "ryosen/mesh/mesh.h"

namespace ryosen::test {

struct KernelSum {
  std::int64_t vertices = 0;    // V
  std::int64_t edges = 0;       // E
  std::int64_t faces = 0;       // F
  std::int64_t boundaries = 0;  // B + W + I: cycles of `next` outside the faces; an isolated vertex is one
  std::int64_t rings = 0;       // H
  std::int64_t components = 0;  // S: parts joined by edges and faces; an isolated vertex is one
  std::int64_t genus = 0;       // G: from the other terms, so the sum holds where it is even

  std::int64_t left() const { return vertices - edges + faces + boundaries - rings; }
  std::int64_t right() const { return 2 * (components - genus); }
  friend bool operator==(const KernelSum&, const KernelSum&) = default;
};

KernelSum kernel_sum(const Mesh& mesh);

}  // namespace ryosen::test
