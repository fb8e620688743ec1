#include "ryosen/analysis/equal_faces.h"

#include <algorithm>
#include <utility>

#include "ryosen/base/interruption.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/faces_at.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen {

namespace {

// Quick rejection by links only. A triangle on the same three points is the neighbour across all three edges. A quad on
// the same four points shares an edge with this one at each corner. Both assume at most one edge per pair of points, so
// not with copies.
bool may_have_equal_face(const Mesh& mesh, Face f) {
  if (mesh.has_rings(f)) return true;
  const Halfedge a = mesh.halfedge(f), b = mesh.next(a), c = mesh.next(b), d = mesh.next(c);
  const bool is_triangle = d == a;
  if (!is_triangle && mesh.next(d) != a) return true;
  if (is_triangle && !mesh.has_copies()) {
    const Face across = mesh.face(twin(a));
    return across && across == mesh.face(twin(b)) && across == mesh.face(twin(c));
  }
  for (Halfedge h : {a, b, c, d})
    if (has_copies(mesh, mesh.from(h))) return true;
  const Face fa = mesh.face(twin(a)), fb = mesh.face(twin(b)), fc = mesh.face(twin(c));
  if (is_triangle) return fa && fa == fb && fb == fc;
  const Face fd = mesh.face(twin(d));
  const auto is_shared = [](Face x, Face y) { return x && x == y; };
  return is_shared(fa, fb) || is_shared(fa, fc) || is_shared(fd, fb) || is_shared(fd, fc);
}

// Iterates over the outgoing halfedges of all copies of a point.
class PointWalk {
 public:
  PointWalk(const Mesh& mesh, Vertex v)
      : mesh_(&mesh), first_copy_(v), copy_(v), first_(mesh.halfedge(v)), h_(first_) {}
  // False past the last one.
  bool step() {
    if (first_) {
      h_ = mesh_->counter_clockwise(h_);
      if (h_ != first_) return true;
    }
    copy_ = mesh_->next_copy(copy_);
    first_ = h_ = mesh_->halfedge(copy_);
    return copy_ != first_copy_;
  }

 private:
  const Mesh* mesh_;
  Vertex first_copy_, copy_;
  Halfedge first_, h_;
};

// The corner whose point has the lowest valence. All are counted in lockstep, so a point of high valence costs nothing.
Vertex lowest_valence_corner(const Mesh& mesh, Face f) {
  std::vector<std::pair<Vertex, PointWalk>> walks;
  for (Vertex v : vertices_around(mesh, f)) walks.emplace_back(v, PointWalk(mesh, v));
  for (;;)
    for (auto& [v, walk] : walks)
      if (!walk.step()) return v;
}

bool has_corner_count(const Mesh& mesh, Face f, std::size_t expected) {
  std::size_t n = 0;
  for ([[maybe_unused]] Halfedge h : halfedges_around(mesh, f))
    if (++n > expected) return false;
  return n == expected;
}

// A face with an order-independent hash of its point set.
struct KeyedFace {
  std::uint64_t key;
  std::uint32_t face;
  friend bool operator<(const KeyedFace& a, const KeyedFace& b) {
    return a.key != b.key ? a.key < b.key : a.face < b.face;
  }
};

std::uint64_t mix(std::uint64_t x) {
  x = (x + 0x9e3779b97f4a7c15ull) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 29)) * 0x94d049bb133111ebull;
  return x ^ (x >> 32);
}

std::vector<KeyedFace> keyed_faces(Neighbourhood& around) {
  const Mesh& mesh = around.mesh();
  std::vector<KeyedFace> keyed;
  for (const Face f : live_faces(mesh)) {
    stop_if_interrupted(f.index);
    if (!may_have_equal_face(mesh, f)) continue;
    KeyedFace entry{0, f.index};
    for (Vertex v : vertices_around(mesh, f)) entry.key += mix(around.point(v).index);
    keyed.push_back(entry);
  }
  std::sort(keyed.begin(), keyed.end());
  return keyed;
}

// Resolves hash collisions within a group of equal keys. Adds all but the first face of each point set.
void find_in_group(Neighbourhood& around, const KeyedFace* begin, const KeyedFace* end,
                   std::vector<std::uint32_t>& found) {
  std::vector<std::pair<std::vector<Vertex>, std::uint32_t>> sets;
  for (const KeyedFace* i = begin; i < end; ++i) {
    stop_if_interrupted();
    sets.emplace_back();
    sets.back().second = i->face;
    points_of_face(around, Face(i->face), sets.back().first);
    std::sort(sets.back().first.begin(), sets.back().first.end());
  }
  std::sort(sets.begin(), sets.end());
  for (std::size_t i = 1; i < sets.size(); ++i)
    if (sets[i].first == sets[i - 1].first) found.push_back(sets[i].second);
}

}  // namespace

bool has_lower_equal_face(Neighbourhood& around, Face f) {
  const Mesh& mesh = around.mesh();
  if (!may_have_equal_face(mesh, f)) return false;
  std::vector<Vertex> mine, theirs;
  points_of_face(around, f, mine);
  std::sort(mine.begin(), mine.end());
  return any_of_faces_at(mesh, lowest_valence_corner(mesh, f), [&](Face g) {
    if (g >= f || !has_corner_count(mesh, g, mine.size())) return false;
    points_of_face(around, g, theirs);
    std::sort(theirs.begin(), theirs.end());
    return mine == theirs;
  });
}

std::vector<std::uint32_t> find_duplicate_faces(Neighbourhood& around) {
  const std::vector<KeyedFace> keyed = keyed_faces(around);
  std::vector<std::uint32_t> found;
  for (std::size_t begin = 0; begin < keyed.size();) {
    std::size_t end = begin + 1;
    while (end < keyed.size() && keyed[end].key == keyed[begin].key) ++end;
    if (end - begin > 1) find_in_group(around, keyed.data() + begin, keyed.data() + end, found);
    begin = end;
  }
  std::sort(found.begin(), found.end());
  return found;
}

Face hanging_partner(Neighbourhood& around, Face f) {
  const Mesh& mesh = around.mesh();
  if (!may_have_equal_face(mesh, f)) return Face();
  const Halfedge a = mesh.halfedge(f), b = mesh.next(a), c = mesh.next(b);
  if (mesh.next(c) != a || mesh.has_rings(f)) return Face();
  // A triangle that shares two edges shares all three points; across() is none at edges with a third face.
  Face candidates[3];
  for (int i = 0; Halfedge h : {a, b, c}) {
    const Halfedge other = around.across(h);
    if (other && is_triangle(mesh, other) && !mesh.has_rings(mesh.face(other)) &&
        around.point(mesh.from(other)) == around.point(mesh.to(h)))
      candidates[i] = mesh.face(other);
    ++i;
  }
  const Face g = candidates[0] == candidates[1] || candidates[0] == candidates[2] ? candidates[0] : candidates[1];
  return g && (candidates[0] == candidates[1] || g == candidates[2]) && g < f ? g : Face();
}

bool closes_hanging_pair(Neighbourhood& around, Face f) { return static_cast<bool>(hanging_partner(around, f)); }

}  // namespace ryosen
