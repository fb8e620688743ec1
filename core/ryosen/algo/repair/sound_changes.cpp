#include "ryosen/algo/repair/sound_changes.h"

#include <algorithm>
#include <map>
#include <utility>

#include "ryosen/algo/repair/detach_nonmanifold.h"
#include "ryosen/analysis/neighbourhood.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/collapse_edge.h"
#include "ryosen/ops/delete.h"
#include "ryosen/ops/rules/face_lists.h"

namespace ryosen {

namespace {

bool makes_flat(const Mesh& m, Halfedge h) {
  const Vertex goes = m.from(h), stays = m.to(h);
  const auto place = [&](Vertex v) { return m.position(v == goes ? stays : v); };
  for (Face f : faces_around(m, goes)) {
    if (!f) continue;
    const bool vanishes = (f == m.face(h) || f == m.face(twin(h))) && corner_count(m, f) == 3;
    if (!vanishes && !is_flat(m, f) && is_flat_at(m, f, place)) return true;
  }
  return false;
}

bool makes_hanging_pair(const Mesh& m, Halfedge h) {
  for (Halfedge side : {h, twin(h)})
    if (const Face f = m.face(side); f && corner_count(m, f) == 4 && equal_face(m, f)) return true;
  return false;
}

using PointPair = std::pair<Vertex, Vertex>;

// The edges of the faces as pairs of points, and the points.
struct Rim {
  std::vector<PointPair> edges;
  std::vector<Vertex> points;
};

Rim rim_of(Neighbourhood& around, const std::vector<Face>& faces) {
  Rim rim;
  for (Face f : faces)
    for (Halfedge h : halfedges_around(around.mesh(), f)) {
      rim.edges.push_back(std::minmax({around.point(around.mesh().from(h)), around.point(around.mesh().to(h))}));
      rim.points.push_back(around.point(around.mesh().from(h)));
    }
  sort_unique(rim.edges);
  sort_unique(rim.points);
  return rim;
}

// Keeps those that are as asked, or that are not.
void keep_nonmanifold(Neighbourhood& around, std::vector<Vertex>& points, bool are_nonmanifold) {
  std::erase_if(points,
                [&](Vertex p) { return !around.mesh().is_alive(p) || is_nonmanifold(around, p) != are_nonmanifold; });
}

void keep_misoriented(Neighbourhood& around, std::vector<PointPair>& edges, bool are_misoriented) {
  std::erase_if(edges, [&](const PointPair& edge) {
    if (!around.mesh().is_alive(edge.first) || !around.mesh().is_alive(edge.second)) return true;
    const StarEdge* const found = around.star(edge.first).edge_to(edge.second);
    return (found && found->faces.is_misoriented()) != are_misoriented;
  });
}

// Whether without the deleted faces an edge has only two triangles on the same three points left.
bool has_only_a_pair_left(Neighbourhood& around, Halfedge h, const std::vector<Face>& doomed) {
  if (!around.edge(h).is_nonmanifold()) return false;
  std::vector<Face> at_edge;
  std::vector<Vertex> points, others;
  around.faces_at(h, at_edge);
  std::erase_if(at_edge, [&](Face g) { return std::binary_search(doomed.begin(), doomed.end(), g); });
  if (at_edge.size() != 2 || corner_count(around.mesh(), at_edge[0]) != 3) return false;
  points_of_face(around, at_edge[0], points);
  points_of_face(around, at_edge[1], others);
  std::sort(points.begin(), points.end());
  std::sort(others.begin(), others.end());
  return points == others;
}

}  // namespace

bool collapses_soundly(const Mesh& m, Halfedge h) {
  const CollapseEdge op{h, CollapseEdge::Place::end};
  return !makes_flat(m, h) && !makes_hanging_pair(m, h) && op.is_legal(m) && op.directed(m) == h;
}

std::size_t delete_soundly(Edit& edit, std::vector<Face> faces, bool may_leave_pairs) {
  const Mesh& m = edit.mesh();
  Neighbourhood before(m);
  sort_unique(faces);
  const std::vector<Face> doomed = faces;
  std::map<PointPair, bool> known;  // by edge: whether a face must stay there
  const auto must_hold_a_pair_apart = [&](Halfedge h) -> bool& {
    const auto [place, is_new] =
        known.try_emplace(std::minmax({before.point(m.from(h)), before.point(m.to(h))}), false);
    if (is_new) place->second = has_only_a_pair_left(before, h, doomed);
    return place->second;
  };
  std::erase_if(faces, [&](Face f) {
    if (may_leave_pairs) return false;
    const auto around = halfedges_around(m, f);
    const bool stays = std::any_of(around.begin(), around.end(), must_hold_a_pair_apart);
    if (stays)
      for (Halfedge h : around) must_hold_a_pair_apart(h) = false;
    return stays;
  });
  if (faces.empty()) return 0;
  const std::size_t count = faces.size();
  Rim rim = rim_of(before, faces);
  const std::vector<Vertex> points = rim.points;
  keep_nonmanifold(before, rim.points, false);
  keep_misoriented(before, rim.edges, false);
  Sheets sheets(edit);
  delete_elements(edit, sheets, {std::move(faces), {}, {}});
  for (Vertex p : points)  // one that was non-manifold may have several fans at a vertex now
    if (m.is_alive(p)) separate_fans_at(sheets, p);
  Neighbourhood after(m);
  keep_nonmanifold(after, rim.points, true);
  keep_misoriented(after, rim.edges, true);
  std::vector<Vertex> ends;
  for (const auto& [a, b] : rim.edges) ends.insert(ends.end(), {a, b});
  detach_points(edit, std::move(rim.points), std::move(ends));
  return count;
}

}  // namespace ryosen
