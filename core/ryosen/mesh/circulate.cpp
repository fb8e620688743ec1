#include "ryosen/mesh/circulate.h"

#include <string>

namespace ryosen {

BrokenMesh::BrokenMesh(Halfedge start)
    : std::runtime_error("the links from halfedge h" + std::to_string(start.index) + " do not close a cycle"),
      start_(start) {}

void detail::throw_broken_mesh(Halfedge start) { throw BrokenMesh(start); }

}  // namespace ryosen
