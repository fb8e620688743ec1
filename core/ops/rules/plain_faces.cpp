#include "core/ops/rules/plain_faces.h"

#include <vector>

#include "core/mesh/circulate.h"
#include "core/mesh/copies.h"
#include "core/ops/rules/face_lists.h"

namespace ryosen {

bool unite_plainly(const Mesh& m, Halfedge h, LocalFacts& known) {
  const Face f = m.face(h), g = m.face(twin(h));
  if (!f || !g || f == g || is_cut_on_points(m, h)) return false;
  for (Face face : {f, g})
    if (!known.is_one_simple_loop(m, face) || known.has_equal_face(m, face)) return false;
  const bool left_is_larger = known.corner_count(m, f) > known.corner_count(m, g);
  const Halfedge side = left_is_larger ? twin(h) : h;  // of the smaller face
  const Face larger = m.face(twin(side));
  std::vector<std::uint32_t> united{m.from(side).index, m.to(side).index};  // corners of both, as many as are looked at
  for (Halfedge corner = m.next(m.next(side)); corner != side; corner = m.next(corner)) {
    if (touches(m, larger, m.from(corner))) return false;
    united.push_back(m.from(corner).index);
  }
  const std::uint32_t corners_after = known.corner_count(m, f) + known.corner_count(m, g) - 2;
  return !any_of_copies(m, loneliest_point(m, united), [&](Vertex copy) {
    for (Face third : faces_around(m, copy))
      if (third && third != f && third != g && known.corner_count(m, third) >= corners_after) return true;
    return false;
  });
}

namespace {

// Whether another face may get the points that this one will have: it has the first few of them.
bool may_equal(const Mesh& m, Face other, const CornerChange& change, LocalFacts& known) {
  constexpr int few = 8;
  if (known.corner_count(m, other) < known.corner_count(m, change.face) || !touches(m, other, change.gains))
    return false;
  int asked = 0;
  for (Vertex v : vertices_around(m, change.face)) {
    if (v != change.loses && !touches(m, other, v)) return false;
    if (++asked == few) break;
  }
  return true;
}

}  // namespace

bool changes_plainly(const Mesh& m, const CornerChange& change, LocalFacts& known) {
  const Face f = change.face;
  if (!known.is_one_simple_loop(m, f) || known.has_equal_face(m, f) || touches(m, f, change.gains)) return false;
  const std::uint32_t both[] = {change.stays.index, change.gains.index};
  return !any_of_copies(m, loneliest_point(m, both), [&](Vertex copy) {
    for (Face other : faces_around(m, copy))
      if (other && other != f && other != change.beside && may_equal(m, other, change, known)) return true;
    return false;
  });
}

}  // namespace ryosen
