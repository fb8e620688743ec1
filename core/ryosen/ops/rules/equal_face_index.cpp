#include "ryosen/ops/rules/equal_face_index.h"

#include <algorithm>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/rules/face_lists.h"

namespace ryosen {

void EqualFaceIndex::read_faces_at(Vertex p) {
  read_.insert(p);
  for_each_copy(mesh_, p, [&](Vertex copy) {
    if (mesh_.is_isolated(copy)) return;
    for (const Face f : faces_around(mesh_, copy))
      if (f && known_.insert(f).second) ++count_[point_set(loops_of(mesh_, f).corners)];
  });
}

// All faces on the same points are known where one of these has been read.
bool EqualFaceIndex::has_equal(Face f) {
  const std::vector<std::uint32_t> points = point_set(loops_of(mesh_, f).corners);
  const bool is_read =
      std::any_of(points.begin(), points.end(), [&](std::uint32_t p) { return read_.contains(Vertex(p)); });
  if (!is_read) read_faces_at(point(mesh_, loneliest_point(mesh_, points)));
  return count_[points] > 1;
}

}  // namespace ryosen
