// Detach: gives a sheet its own points wherever it touches other faces.
//
//        a---b---c             a---b   b'---c
//        | f | g |      =>     | f |   |  g |       g is detached; b and d are shared with f
//        e---d---h             e---d   d'---h
//
// polygon list: in the named faces every point shared with other faces is replaced by a new one, the same in all of
//               them. A single face stands for its sheet (the faces connected to it through edges with exactly two
//               faces in opposite directions) if that touches others, else for itself.
// needs: the faces touch others.
// changes: V + the shared points, E + the shared edges on points; non-manifold edges may become manifold.
// inverse: weld, point by point, where it is legal.
#pragma once

#include <vector>

#include "ryosen/ops/op.h"

namespace ryosen {

struct Detach {
  std::vector<Face> faces;

  static const OpInfo info;

  static Detach at(const Mesh&, const OpTarget& target) { return {{target.face}}; }

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
  bool operator==(const Detach&) const = default;
};

}  // namespace ryosen
