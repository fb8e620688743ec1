#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/mesh/circulate.h"
#include "core/mesh/copies.h"
#include "core/ops/collapse_edge.h"
#include "core/ops/rules/face_lists.h"
#include "core/ops/rules/local_facts.h"
#include "core/ops/rules/plain_check.h"

namespace ryosen {

namespace {

// Checks one collapse: `h` goes from the removed to the remaining vertex; the removed one has no copies.
class CollapseJudge {
 public:
  CollapseJudge(const Mesh& mesh, Halfedge h, LocalFacts& known)
      : m_(mesh), known_(known), h_(h), gone_(mesh.from(h)), kept_(mesh.to(h)) {
    for (Halfedge side : {h_, twin(h_)})
      if (is_plain_triangle(side)) apexes_[apex_count_++] = m_.to(m_.next(side));
    find_smaller_star();
  }

  Verdict judge() {
    check_wire();
    check_inner_edge();
    check_closed_cuts();
    check_apexes();
    check_holes();
    check_common_neighbours();
    check_common_faces();
    check_loops();
    if (verdict_.legal()) check_duplicates();
    return std::move(verdict_);
  }

 private:
  // Of the two ends the one where less begins, so that what both share is found from there at little cost.
  void find_smaller_star() {
    std::vector<Halfedge> at_gone, at_kept;
    Halfedge g = h_, k = twin(h_);
    Vertex copy = kept_;
    for (;;) {
      at_gone.push_back(g);
      at_kept.push_back(k);
      g = m_.counter_clockwise(g);
      k = m_.counter_clockwise(k);
      if (g == h_) {
        smaller_ = std::move(at_gone);
        beyond_ = kept_;
        return;
      }
      if (k != (copy == kept_ ? twin(h_) : m_.halfedge(copy))) continue;
      do copy = m_.next_copy(copy);
      while (m_.is_isolated(copy));
      if (copy == kept_) break;
      k = m_.halfedge(copy);
    }
    smaller_ = std::move(at_kept);
    beyond_ = gone_;
  }

  // Whether the two ends have a neighbour in common that may be in the way: no if not, else perhaps.
  bool may_share_neighbours() const {
    return std::any_of(smaller_.begin(), smaller_.end(), [&](Halfedge k) {
      const Vertex v = m_.to(k);
      if (same_point(m_, v, beyond_)) return false;
      // Another copy of it may be a neighbour of the removed end.
      const bool is_only = beyond_ == kept_ || !has_copies(m_, v);
      if (is_only && (is_apex(v) || is_tip_of_three_edge_hole(v))) return false;
      return are_joined(m_, v, beyond_);
    });
  }

  bool may_share_faces() const {
    return std::any_of(smaller_.begin(), smaller_.end(), [&](Halfedge k) {
      return !m_.is_outside(k) && !is_at_edge(m_.face(k)) && reaches_beyond(m_.face(k));
    });
  }

  // Whether the other end is a corner of the face.
  bool reaches_beyond(Face f) const { return touches(m_, f, beyond_); }

  // Only the loops of a face at both ends change otherwise than in the number of a vertex.
  bool may_break_loops() const {
    return std::any_of(smaller_.begin(), smaller_.end(), [&](Halfedge k) {
      if (m_.is_outside(k) || is_plain_triangle(k)) return false;
      const Face f = m_.face(k);
      return (is_at_edge(f) || reaches_beyond(f)) && !known_.is_one_simple_loop(m_, f);
    });
  }

  // Where the ends share no neighbours but the apexes, two faces become one on the same points only if a triangle joins
  // one end to both apexes, or has more than three corners.
  bool may_make_duplicates() const {
    if (!may_make_triangles_equal()) return false;
    // Such a face shares its corners beside the end with another one, which has the other end.
    return std::any_of(smaller_.begin(), smaller_.end(), [&](Halfedge k) {
      if (m_.is_outside(k) || is_dropped(k)) return false;
      const std::uint32_t beside[] = {m_.to(k).index, m_.from(m_.prev(k)).index};
      const Vertex ends[] = {gone_, kept_};
      const auto is_end = [&](std::uint32_t v) {
        return same_point(m_, Vertex(v), ends[0]) || same_point(m_, Vertex(v), ends[1]);
      };
      if (is_end(beside[0]) && is_end(beside[1])) return true;
      const Vertex corner = is_end(beside[0])   ? Vertex(beside[1])
                            : is_end(beside[1]) ? Vertex(beside[0])
                                                : loneliest_point(m_, beside);
      const auto has = [&](Face g, std::uint32_t v) { return is_end(v) || touches(m_, g, Vertex(v)); };
      return any_of_copies(m_, corner, [&](Vertex copy) {
        for (Face g : faces_around(m_, copy))
          if (g && g != m_.face(k) && are_of_similar_size(m_.face(k), g) && reaches_beyond(g) && has(g, beside[0]) &&
              has(g, beside[1]))
            return true;
        return false;
      });
    });
  }

  // Whether two faces may have the same number of points afterwards: with bridges there are up to twice as many corners.
  bool are_of_similar_size(Face f, Face g) const {
    const auto of_f = halfedges_around(m_, f), of_g = halfedges_around(m_, g);
    auto at_f = of_f.begin(), at_g = of_g.begin();
    std::size_t fewer = 0, more = 0;
    for (; at_f != of_f.end() && at_g != of_g.end(); ++at_f, ++at_g) ++fewer;
    auto& at = at_f == of_f.end() ? at_g : at_f;
    const auto end = at_f == of_f.end() ? of_g.end() : of_f.end();
    for (; at != end && more <= fewer + 2; ++at) ++more;
    return more <= fewer + 2;
  }

  bool may_make_triangles_equal() const {
    const auto is_at_apex = [&](Vertex v) {
      return apex_count_ == 2 && (same_point(m_, v, apexes_[0]) || same_point(m_, v, apexes_[1]));
    };
    return std::any_of(smaller_.begin(), smaller_.end(), [&](Halfedge k) {
      if (m_.is_outside(k) || is_dropped(k)) return false;
      return !is_plain_triangle(k) || (is_at_apex(m_.to(k)) && is_at_apex(m_.from(m_.prev(k))));
    });
  }

  bool is_apex(Vertex v) const { return std::find(apexes_, apexes_ + apex_count_, v) != apexes_ + apex_count_; }
  bool is_at_edge(Face f) const { return f == m_.face(h_) || f == m_.face(twin(h_)); }
  // A face with three corners and no rings.
  bool is_plain_triangle(Halfedge side) const {
    return !m_.is_outside(side) && is_triangle(m_, side) && !m_.has_rings(m_.face(side));
  }
  bool is_dropped(Halfedge corner) const { return is_at_edge(m_.face(corner)) && is_plain_triangle(corner); }

  bool has_fans_on_point(Vertex v) const {
    bool found = false;
    for_each_copy(m_, v, [&](Vertex copy) { found |= count_fans(m_, copy) > 0; });
    return found;
  }

  // Refuses if two fans would meet at one point, or if an isolated edge would leave an isolated vertex.
  void check_wire() {
    if (!m_.is_wire(edge(h_))) return;
    if (count_fans(m_, gone_) > 0 && has_fans_on_point(kept_)) verdict_.refuse(Rule::joins_fans, {gone_, kept_});
    if (m_.next(h_) == twin(h_) && m_.prev(h_) == twin(h_)) verdict_.refuse(Rule::lone_edge, {edge(h_)});
  }

  void check_inner_edge() {
    if (m_.is_outside(h_) || m_.is_outside(twin(h_))) return;
    if (m_.is_boundary(gone_) && m_.is_boundary(kept_)) verdict_.refuse(Rule::inner_edge, {gone_, kept_});
  }

  // Two faces can share a halfedge pair at an edge that is non-manifold on points only at a vertex without a gap
  // (Sheets::is_closed_cut); the boundary at the removed vertex would open it.
  void check_closed_cuts() {
    if (!m_.has_copies() || !m_.is_boundary(gone_) || m_.is_boundary(kept_)) return;
    for (Halfedge k : outgoing(m_, kept_))
      if (is_cut_on_points(m_, k)) verdict_.refuse(Rule::copies, {edge(k)});
  }

  void check_apexes() {
    for (Halfedge side : {h_, twin(h_)}) {
      if (!is_plain_triangle(side)) continue;
      if (m_.is_outside(twin(m_.next(side))) && m_.is_outside(twin(m_.prev(side))))
        verdict_.refuse(Rule::isolated_apex, {m_.to(m_.next(side)), m_.face(side)});
    }
    if (apex_count_ == 2 && apexes_[0] == apexes_[1])
      verdict_.refuse(Rule::vanishes, {apexes_[0], m_.face(h_), m_.face(twin(h_))});
  }

  bool is_tip_of_three_edge_hole(Vertex v) const {
    for (Halfedge side : {h_, twin(h_)})
      if (m_.is_outside(side) && is_triangle(m_, side) && m_.to(m_.next(side)) == v) return true;
    return false;
  }

  void check_holes() {
    for (Halfedge side : {h_, twin(h_)})
      if (m_.is_outside(side) && is_triangle(m_, side))
        verdict_.refuse(Rule::closes_hole, {m_.to(m_.next(side)), edge(m_.next(side)), edge(m_.prev(side))});
  }

  // Common neighbours of the removed vertex and of any copy of the remaining point.
  void check_common_neighbours() {
    if (!may_share_neighbours()) return;
    for (Halfedge g : outgoing(m_, gone_)) {
      const Vertex x = m_.to(g);
      if (x == kept_ || is_apex(x) || is_tip_of_three_edge_hole(x)) continue;
      const std::vector<Halfedge> sheets = sheets_between(m_, kept_, x);
      if (!sheets.empty())
        verdict_.refuse(Rule::common_neighbour, {x, edge(g), edge(*std::min_element(sheets.begin(), sheets.end()))});
    }
  }

  void check_common_faces() {
    if (!may_share_faces()) return;
    for (Halfedge g : outgoing(m_, gone_)) {
      if (m_.is_outside(g) || is_at_edge(m_.face(g))) continue;
      for (Halfedge corner : halfedges_around(m_, m_.face(g)))
        if (same_point(m_, m_.from(corner), kept_)) verdict_.refuse(Rule::common_face, {m_.face(g)});
    }
  }

  // A face with rings or bridges must still split into simple loops.
  void check_loops() {
    if (!may_break_loops()) return;
    std::vector<Face> looked_at;
    for (Halfedge g : outgoing(m_, gone_)) {
      const Face f = m_.face(g);
      if (!f || std::find(looked_at.begin(), looked_at.end(), f) != looked_at.end() || is_one_simple_loop(m_, f))
        continue;
      looked_at.push_back(f);
      CornerLoops after;
      for_each_loop(m_, f, [&](Halfedge start) {
        std::vector<std::uint32_t> points;
        for (Halfedge h : loop(m_, start)) {
          const Vertex v = m_.from(h);
          const std::uint32_t p = point(m_, v == gone_ ? kept_ : v).index;
          if (points.empty() || points.back() != p) points.push_back(p);
        }
        if (points.size() > 1 && points.back() == points.front()) points.pop_back();
        after.add(points);
      });
      if (!take_out_bridges(after)) verdict_.refuse(Rule::loop, {f});
    }
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
      else if (is_at_edge(f))
        --key;
      else
        key += mixed(point(m_, kept_));
    }
    return key;
  }

  // Compares each face of the removed vertex with those of the remaining point that have the same hash. A face with
  // bridges is considered once.
  void check_duplicates() {
    if (!may_make_duplicates()) return;
    struct Candidate {
      std::uint64_t key;
      std::size_t order;
      Face face;
      bool operator<(const Candidate& other) const { return key != other.key ? key < other.key : order < other.order; }
    };
    std::vector<Candidate> candidates;
    for_each_copy(m_, kept_, [&](Vertex copy) {
      for (Halfedge k : outgoing(m_, copy))
        if (!m_.is_outside(k) && !is_bridge(m_, k) && !is_dropped(k))
          candidates.push_back({key_after(m_.face(k)), candidates.size(), m_.face(k)});
    });
    std::sort(candidates.begin(), candidates.end());
    for (Halfedge g : outgoing(m_, gone_)) {
      if (m_.is_outside(g) || is_bridge(m_, g) || is_dropped(g)) continue;
      const Candidate first{key_after(m_.face(g)), 0, Face()};
      for (auto c = std::lower_bound(candidates.begin(), candidates.end(), first);
           c != candidates.end() && c->key == first.key; ++c)
        compare(m_.face(g), c->face);
    }
  }

  void compare(Face f, Face g) {
    if (f == g) return;
    if (is_at_edge(f) && is_at_edge(g) && f < g) return;  // compare such a pair once
    if (points_after(f) == points_after(g) && points_before(f) != points_before(g))
      verdict_.refuse(Rule::duplicate_face, {std::min(f, g), std::max(f, g)});
  }

  const Mesh& m_;
  LocalFacts& known_;
  Halfedge h_;
  Vertex gone_, kept_;
  Vertex apexes_[2];
  int apex_count_ = 0;
  std::vector<Halfedge> smaller_;  // what begins at the end of lower valence, over all copies
  Vertex beyond_;                  // the other end
  Verdict verdict_;
};

}  // namespace

Halfedge CollapseEdge::directed(const Mesh& mesh) const {
  return has_several_fans(mesh, mesh.from(halfedge)) ? twin(halfedge) : halfedge;
}

Verdict CollapseEdge::judge(const Mesh& mesh, LocalFacts& known) const {
  Verdict verdict;
  if (is_gone(mesh, halfedge, verdict)) return verdict;
  const Vertex a = mesh.from(halfedge), b = mesh.to(halfedge);
  const bool goes_to_a = known.has_several_fans(mesh, a);
  if (goes_to_a && known.has_several_fans(mesh, b)) {
    verdict.refuse(Rule::copies, {point(mesh, a), point(mesh, b)});
    return verdict;
  }
  return CollapseJudge(mesh, goes_to_a ? twin(halfedge) : halfedge, known).judge();
}

Verdict CollapseEdge::check(const Mesh& mesh, LocalFacts& known) const {
  if (mesh.exists(halfedge) && mesh.is_alive(halfedge) && quick_collapse(mesh, halfedge) == QuickAnswer::legal)
    return {};
  return judge(mesh, known);
}

Verdict CollapseEdge::check(const Mesh& mesh) const {
  LocalFacts known;
  return check(mesh, known);
}

Verdict CollapseEdge::judge(const Mesh& mesh) const {
  LocalFacts known;
  return judge(mesh, known);
}

bool CollapseEdge::is_legal(const Mesh& mesh) const {
  if (!mesh.exists(halfedge) || !mesh.is_alive(halfedge)) return false;
  const QuickAnswer answer = quick_collapse(mesh, halfedge);
  return answer == QuickAnswer::legal || (answer == QuickAnswer::unknown && judge(mesh).legal());
}

}  // namespace ryosen
