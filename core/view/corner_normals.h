// Normals with which a surface of faces looks smooth: one per corner, of the faces that go over into each other there.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/analysis/neighbourhood.h"
#include "core/mesh/touched.h"
#include "core/pick/surface_triangles.h"

namespace ryosen {

// The normal of a corner is the sum of those of the faces around its vertex, each weighted by the face's angle there. It
// goes on from face to face as far as an edge joins them that is no crease (core/highlights/creases.h). So corners at a
// crease, at a boundary, and at the copies of a point, where the surface is not manifold or not oriented alike, go by
// their own side. A face that has no normal adds nothing.
class CornerNormals {
 public:
  // O(corners), and their logarithm for faces that are no triangles.
  CornerNormals(const Mesh& mesh, const SurfaceTriangles& triangles);

  // Follows an edit behind the triangles, not where everything was touched. Returns the slots of triangles whose normals
  // may be other ones, all of a face or none. Costs what was touched and the faces around it.
  std::vector<std::uint32_t> update(const Mesh& mesh, const SurfaceTriangles& triangles,
                                    const TouchedElements& touched);

  // By slot of the triangles, one per corner, as of packed_normal.h; no_normal where no face around has one. What stands
  // in unused slots means nothing.
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

  std::vector<std::array<std::uint32_t, 3>> packed_;
  // Scratch: the corners around one vertex, in order; those of polygons that wait for finish().
  std::vector<Corner> corners_;
  std::vector<PolygonCorner> waiting_;
};

}  // namespace ryosen
