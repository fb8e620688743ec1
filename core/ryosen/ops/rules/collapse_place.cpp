#include "ryosen/ops/rules/collapse_place.h"

#include <algorithm>

#include "ryosen/mesh/faces_at.h"

namespace ryosen {

namespace {

// Whether two faces may have the same number of points after a collapse: with bridges there are up to twice as many
// corners.
bool are_of_similar_size(const Mesh& mesh, Face f, Face g) {
  const auto of_f = halfedges_around(mesh, f), of_g = halfedges_around(mesh, g);
  auto at_f = of_f.begin(), at_g = of_g.begin();
  std::size_t fewer = 0, more = 0;
  for (; at_f != of_f.end() && at_g != of_g.end(); ++at_f, ++at_g) ++fewer;
  auto& at = at_f == of_f.end() ? at_g : at_f;
  for (; at != of_f.end() && more <= fewer + 2; ++at) ++more;
  return more <= fewer + 2;
}

}  // namespace

CollapsePlace::CollapsePlace(const Mesh& given, Halfedge edge_half)
    : mesh(given), h(edge_half), gone(given.from(edge_half)), kept(given.to(edge_half)) {
  for (Halfedge side : {h, twin(h)})
    if (is_triangle_side(mesh, side)) apexes[apex_count++] = mesh.to(mesh.next(side));
  find_smaller_star();
}

// Of the two ends the one where less begins, so that what both share is found from there at little cost.
void CollapsePlace::find_smaller_star() {
  std::vector<Halfedge> at_gone, at_kept;
  Halfedge g = h, k = twin(h);
  Vertex copy = kept;
  for (;;) {
    at_gone.push_back(g);
    at_kept.push_back(k);
    g = mesh.counter_clockwise(g);
    k = mesh.counter_clockwise(k);
    if (g == h) {
      smaller_ = std::move(at_gone);
      beyond_ = kept;
      return;
    }
    if (k != (copy == kept ? twin(h) : mesh.halfedge(copy))) continue;
    do copy = mesh.next_copy(copy);
    while (mesh.is_isolated(copy));
    if (copy == kept) break;
    k = mesh.halfedge(copy);
  }
  smaller_ = std::move(at_kept);
  beyond_ = gone;
}

bool CollapsePlace::is_apex(Vertex v) const {
  const auto end = apexes.begin() + static_cast<std::ptrdiff_t>(apex_count);
  return std::find(apexes.begin(), end, v) != end;
}

bool CollapsePlace::is_tip_of_three_edge_hole(Vertex v) const {
  for (Halfedge side : {h, twin(h)})
    if (mesh.is_outside(side) && is_triangle(mesh, side) && mesh.to(mesh.next(side)) == v) return true;
  return false;
}

bool CollapsePlace::reaches_beyond(Face f) const { return touches(mesh, f, beyond_); }

CollapsePlace::Shares CollapsePlace::shares_neighbour(Halfedge k) const {
  const Vertex v = mesh.to(k);
  if (same_point(mesh, v, beyond_)) return Shares::no;
  // Another copy of it may be a neighbour of the removed end.
  const bool is_only = beyond_ == kept || !has_copies(mesh, v), is_at_side = is_apex(v) || is_tip_of_three_edge_hole(v);
  if ((is_only && is_at_side) || !are_joined(mesh, v, beyond_)) return Shares::no;
  return is_only ? Shares::surely : Shares::perhaps;
}

bool CollapsePlace::may_share_neighbours() const {
  return std::any_of(smaller_.begin(), smaller_.end(), [&](Halfedge k) { return shares_neighbour(k) != Shares::no; });
}

bool CollapsePlace::surely_share_a_neighbour() const {
  return std::any_of(smaller_.begin(), smaller_.end(),
                     [&](Halfedge k) { return shares_neighbour(k) == Shares::surely; });
}

bool CollapsePlace::has_other_wire() const {
  return std::any_of(smaller_.begin(), smaller_.end(), [&](Halfedge k) {
    return edge(k) != edge(h) && mesh.is_wire(edge(k)) && same_point(mesh, mesh.to(k), beyond_);
  });
}

bool CollapsePlace::may_share_faces() const {
  return std::any_of(smaller_.begin(), smaller_.end(), [&](Halfedge k) {
    return !mesh.is_outside(k) && !is_at_edge(mesh.face(k)) && reaches_beyond(mesh.face(k));
  });
}

// Only the loops of a face at both ends change otherwise than in the number of a vertex.
bool CollapsePlace::may_break_loops(LocalFacts& known) const {
  return std::any_of(smaller_.begin(), smaller_.end(), [&](Halfedge k) {
    if (mesh.is_outside(k) || is_triangle_side(mesh, k)) return false;
    const Face f = mesh.face(k);
    return (is_at_edge(f) || reaches_beyond(f)) && !known.is_one_simple_loop(mesh, f);
  });
}

bool CollapsePlace::may_make_duplicates() const {
  return may_make_triangles_equal() &&
         std::any_of(smaller_.begin(), smaller_.end(), [&](Halfedge k) { return may_equal_another(k); });
}

// Two faces become one on the same points only if a triangle joins one end to both apexes, or has more than three
// corners.
bool CollapsePlace::may_make_triangles_equal() const {
  const auto is_at_apex = [&](Vertex v) {
    return apex_count == 2 && (same_point(mesh, v, apexes[0]) || same_point(mesh, v, apexes[1]));
  };
  return std::any_of(smaller_.begin(), smaller_.end(), [&](Halfedge k) {
    if (mesh.is_outside(k) || is_dropped(k)) return false;
    return !is_triangle_side(mesh, k) || (is_at_apex(mesh.to(k)) && is_at_apex(mesh.from(mesh.prev(k))));
  });
}

// Such a face shares the corners beside its end with another one, which has the other end.
bool CollapsePlace::may_equal_another(Halfedge corner) const {
  if (mesh.is_outside(corner) || is_dropped(corner)) return false;
  const Face f = mesh.face(corner);
  const std::uint32_t beside[] = {mesh.to(corner).index, mesh.from(mesh.prev(corner)).index};
  const auto is_end = [&](std::uint32_t v) {
    return same_point(mesh, Vertex(v), gone) || same_point(mesh, Vertex(v), kept);
  };
  if (is_end(beside[0]) && is_end(beside[1])) return true;
  const Vertex common = is_end(beside[0])   ? Vertex(beside[1])
                        : is_end(beside[1]) ? Vertex(beside[0])
                                            : loneliest_point(mesh, beside);
  const auto has = [&](Face g, std::uint32_t v) { return is_end(v) || touches(mesh, g, Vertex(v)); };
  return any_of_faces_at(mesh, common, [&](Face g) {
    return g != f && are_of_similar_size(mesh, f, g) && reaches_beyond(g) && has(g, beside[0]) && has(g, beside[1]);
  });
}

}  // namespace ryosen
