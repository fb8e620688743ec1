// The faces of a mesh of triangles and the pairs of them that meet, before and after a step of a simplification.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <vector>

#include "ryosen/analysis/self_intersections.h"
#include "ryosen/indexed/indexed.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen::test {

struct MetFaces {
  std::map<Face, std::array<std::uint32_t, 3>> corners;  // points
  std::set<FacePair> pairs;
};

// By asking each pair of triangles; face i of the list has the name names[i].
MetFaces met_faces(const IndexedMesh& list, std::span<const Face> names);
// The same of the live faces of a mesh.
MetFaces met_faces(const Mesh& mesh);
// The same by the search of the program, for larger meshes.
MetFaces searched_faces(const Mesh& mesh);

// For each face that goes, those that stay and had a side in common with it.
std::map<Face, std::set<Face>> heirs_by_sides(const MetFaces& before, const MetFaces& after);
// The pairs that meet after a collapse and come from none that met before it: a face comes from itself, and from one
// that goes and had a side in common with it.
std::vector<FacePair> pairs_from_nowhere(const MetFaces& before, const MetFaces& after);

}  // namespace ryosen::test
