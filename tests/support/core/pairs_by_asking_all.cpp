#include "tests/support/core/pairs_by_asking_all.h"

#include "ryosen/geometry/predicates.h"
#include "ryosen/geometry/triangles_meet.h"

namespace ryosen::test {

std::vector<FacePair> pairs_by_asking_all(const IndexedMesh& mesh) {
  std::vector<NumberedTriangle> triangles(mesh.face_count());
  for (std::size_t f = 0; f < triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      triangles[f].numbers[k] = mesh.face(f)[k];
      triangles[f].places[k] = mesh.positions[mesh.face(f)[k]];
    }
  const auto is_flat = [&](std::size_t f) { return are_collinear(triangles[f].places); };
  std::vector<FacePair> pairs;
  for (std::size_t f = 0; f < triangles.size(); ++f)
    for (std::size_t g = f + 1; g < triangles.size(); ++g)
      if (!is_flat(f) && !is_flat(g) && meet_elsewhere(triangles[f], triangles[g])) pairs.push_back({Face(f), Face(g)});
  return pairs;
}

}  // namespace ryosen::test
