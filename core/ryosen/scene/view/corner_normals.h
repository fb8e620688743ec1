// Normals with which a surface of faces looks smooth: one per corner, of the faces that go over into each other there.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "ryosen/analysis/neighbourhood.h"
#include "ryosen/analysis/surface_triangles.h"
#include "ryosen/mesh/journal.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// The normals that a file gives for the corners of its faces, as long as the surface there is that of the file.
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

// The normal of a corner is that of the file where it has one (FileNormals), else the sum of those of the faces around
// its vertex, each weighted by the face's angle there. It goes on from face to face as far as an edge joins them that
// bends by no more than an angle. So corners at a crease, at a boundary, and at the copies of a point, where the
// surface is not manifold or not oriented alike, go by their own side. A face that has no normal adds nothing.
class CornerNormals {
 public:
  // O(corners), and their logarithm for faces that are no triangles. `file_normals` must outlive this, and follow edits
  // before it; null: the file has none.
  CornerNormals(const Mesh& mesh, const SurfaceTriangles& triangles, double crease_deg = 30,
                const FileNormals* file_normals = nullptr);

  double crease_deg() const { return crease_deg_; }

  // Follows an edit behind the triangles, not where everything was touched. Returns the slots of triangles whose
  // normals may be other ones, all of a face or none. Costs what was touched and the faces around it.
  std::vector<std::uint32_t> update(const Mesh& mesh, const SurfaceTriangles& triangles,
                                    const TouchedElements& touched);

  // By slot of the triangles, one per corner, as of packed_normal.h; no_normal where no face around has one. What
  // stands in unused slots means nothing.
  std::span<const std::array<std::uint32_t, 3>> packed() const { return packed_; }

 private:
  struct Corner {
    Halfedge halfedge;  // outgoing
    Face face;          // none: a gap
    glm::dvec3 normal, weighted;
  };

  // A corner of a face of several triangles, which are found at once for all its corners.
  struct PolygonCorner {
    Face face;
    Vertex vertex;
    std::uint32_t normal;
  };

  void read(Neighbourhood& around, Vertex v);
  // Sets the corners at a vertex, those of polygons once finish() is called; calls visit(face) for each face there.
  template <class Visit>
  void set_around(Neighbourhood& around, const SurfaceTriangles& triangles, Vertex v, Visit visit);
  void set(const Mesh& mesh, const SurfaceTriangles& triangles, Face face, Vertex v, std::uint32_t normal);
  void finish(const Mesh& mesh, const SurfaceTriangles& triangles);

  double crease_deg_, crease_cosine_;
  const FileNormals* file_normals_;
  std::vector<std::array<std::uint32_t, 3>> packed_;
  std::optional<FileNormals::Reader> of_file_;  // while it reads
  // Scratch: the corners around one vertex, in order; those of polygons that wait for finish().
  std::vector<Corner> corners_;
  std::vector<PolygonCorner> waiting_;
};

}  // namespace ryosen
