// The normals that a file gives for the corners of its faces, as long as the surface there is that of the file.
#pragma once

#include <cstdint>
#include <vector>

#include "ryosen/mesh/mesh.h"
#include "ryosen/mesh/touched.h"

namespace ryosen {

class FileNormals {
 public:
  // Whether the file has any.
  static bool are_in(const Mesh& mesh);

  // Valid until the mesh changes.
  class Reader {
   public:
    Reader(const FileNormals& normals, const Mesh& mesh);
    // That of the corner at which an outgoing halfedge leaves, as of packed_normal.h; no_normal where the file gives
    // none, and at vertices that an edit has reached. O(1).
    std::uint32_t at(Vertex from, Halfedge h) const;

   private:
    const FileNormals* normals_;
    const AttributeColumn *indices_ = nullptr, *pool_ = nullptr;
  };

  // After an edit, its undo or redo: what it touched, and the corners of the faces that it touched, go by the surface
  // from now on. Costs what was touched; nothing where the mesh has no normals.
  void follow(const Mesh& mesh, const TouchedElements& touched);
  // As after an edit of everything.
  void end() { all_edited_ = true; }

 private:
  bool all_edited_ = false;
  std::vector<bool> edited_;  // by vertex; further ones are not
};

}  // namespace ryosen
