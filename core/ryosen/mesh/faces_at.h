// Faces at a point, around each of its copies.
#pragma once

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"

namespace ryosen {

// Whether any face at the point of v is so; looks no further then. A face that visits the point several times is asked
// about as often.
template <class Is>
bool any_of_faces_at(const Mesh& mesh, Vertex v, Is is) {
  return any_of_copies(mesh, v, [&](Vertex copy) {
    for (Face f : faces_around(mesh, copy))
      if (f && is(f)) return true;
    return false;
  });
}

// Visits those faces, v's own first.
template <class Visit>
void for_each_face_at(const Mesh& mesh, Vertex v, Visit visit) {
  for_each_copy(mesh, v, [&](Vertex copy) {
    for (Face f : faces_around(mesh, copy))
      if (f) visit(f);
  });
}

}  // namespace ryosen
