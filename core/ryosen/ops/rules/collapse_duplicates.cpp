#include <algorithm>

#include "ryosen/mesh/rings.h"
#include "ryosen/ops/rules/collapse_place.h"
#include "ryosen/ops/rules/face_lists.h"

namespace ryosen {

namespace {

class DuplicateSearch {
 public:
  DuplicateSearch(const CollapsePlace& place, Verdict& verdict)
      : place_(place), m_(place.mesh), gone_(place.gone), kept_(place.kept), verdict_(verdict) {}

  // Compares each face of the removed vertex with those of the remaining point that have the same hash. A face with
  // bridges is considered once.
  void search() {
    struct Candidate {
      std::uint64_t key;
      std::size_t order;
      Face face;
      bool operator<(const Candidate& other) const { return key != other.key ? key < other.key : order < other.order; }
    };
    std::vector<Candidate> candidates;
    for_each_copy(m_, kept_, [&](Vertex copy) {
      for (Halfedge k : outgoing(m_, copy))
        if (is_considered(k)) candidates.push_back({key_after(m_.face(k)), candidates.size(), m_.face(k)});
    });
    std::sort(candidates.begin(), candidates.end());
    for (Halfedge g : outgoing(m_, gone_)) {
      if (!is_considered(g)) continue;
      const Candidate first{key_after(m_.face(g)), 0, Face()};
      for (auto c = std::lower_bound(candidates.begin(), candidates.end(), first);
           c != candidates.end() && c->key == first.key; ++c)
        compare(m_.face(g), c->face);
    }
  }

 private:
  bool is_considered(Halfedge corner) const {
    return !m_.is_outside(corner) && !is_bridge(m_, corner) && !place_.is_dropped(corner);
  }

  // The points of a face before and after the collapse.
  std::vector<std::uint32_t> points_after(Face f) const {
    std::vector<std::uint32_t> points;
    for (Vertex v : vertices_around(m_, f)) points.push_back(point(m_, v == gone_ ? kept_ : v).index);
    return point_set(points);
  }
  std::vector<std::uint32_t> points_before(Face f) const { return point_set(loops_of(m_, f).corners); }

  // An order-independent hash of the points of a face after the collapse. Only the faces at the edge contain both ends
  // (checked before). Of the corners at a vertex with bridges exactly one does not start a bridge.
  std::uint64_t key_after(Face f) const {
    const auto mixed = [](Vertex p) {
      std::uint64_t x = (p.index + 1) * 0x9e3779b97f4a7c15ull;
      x = (x ^ (x >> 29)) * 0xbf58476d1ce4e5b9ull;
      return x ^ (x >> 32);
    };
    std::uint64_t key = 0;
    for (Halfedge corner : halfedges_around(m_, f)) {
      if (is_bridge(m_, corner)) continue;
      const Vertex v = m_.from(corner);
      ++key;
      if (v != gone_)
        key += mixed(point(m_, v));
      else if (place_.is_at_edge(f))
        --key;
      else
        key += mixed(point(m_, kept_));
    }
    return key;
  }

  void compare(Face f, Face g) {
    if (f == g) return;
    if (place_.is_at_edge(f) && place_.is_at_edge(g) && f < g) return;  // compare such a pair once
    if (points_after(f) == points_after(g) && points_before(f) != points_before(g))
      verdict_.refuse(Rule::duplicate_face, {std::min(f, g), std::max(f, g)});
  }

  const CollapsePlace& place_;
  const Mesh& m_;
  const Vertex gone_, kept_;
  Verdict& verdict_;
};

}  // namespace

void check_duplicates(const CollapsePlace& place, Verdict& verdict) {
  if (place.may_make_duplicates()) DuplicateSearch(place, verdict).search();
}

}  // namespace ryosen
