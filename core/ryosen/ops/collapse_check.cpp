#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/rings.h"
#include "ryosen/ops/collapse_edge.h"
#include "ryosen/ops/rules/collapse_place.h"
#include "ryosen/ops/rules/face_lists.h"
#include "ryosen/ops/rules/plain_check.h"

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

// Refuses a collapse that gives two faces the same points; nothing else may be in the way of it.
void check_duplicates(const CollapsePlace& place, Verdict& verdict) {
  if (place.may_make_duplicates()) DuplicateSearch(place, verdict).search();
}

// Checks one collapse: `h` goes from the removed to the remaining vertex; the removed one has no copies.
class CollapseJudge {
 public:
  CollapseJudge(const Mesh& mesh, Halfedge h, LocalFacts& known)
      : place_(mesh, h), m_(mesh), known_(known), h_(h), gone_(place_.gone), kept_(place_.kept) {}

  Verdict judge() {
    check_wire();
    check_other_wires();
    check_inner_edge();
    check_closed_cuts();
    check_apexes();
    check_holes();
    check_common_neighbours();
    check_common_faces();
    check_loops();
    if (verdict_.legal()) check_duplicates(place_, verdict_);
    return std::move(verdict_);
  }

  // The first reason's rule, found without naming all that stands in the way.
  std::optional<Rule> first_rule() {
    using Check = void (CollapseJudge::*)();
    for (const Check check :
         {&CollapseJudge::check_wire, &CollapseJudge::check_other_wires, &CollapseJudge::check_inner_edge,
          &CollapseJudge::check_closed_cuts, &CollapseJudge::check_apexes, &CollapseJudge::check_holes}) {
      (this->*check)();
      if (!verdict_.legal()) return verdict_.reasons[0].rule;
    }
    if (place_.surely_share_a_neighbour()) return Rule::common_neighbour;
    check_common_neighbours();
    if (verdict_.legal() && place_.may_share_faces()) return Rule::common_face;
    if (verdict_.legal()) check_loops();
    if (verdict_.legal()) check_duplicates(place_, verdict_);
    return first_rule_of(verdict_);
  }

 private:
  bool has_fans_on_point(Vertex v) const {
    return any_of_copies(m_, v, [&](Vertex copy) { return count_fans(m_, copy) > 0; });
  }

  // Refuses if two fans would meet at one point, or if an isolated edge would leave an isolated vertex.
  void check_wire() {
    if (!m_.is_wire(edge(h_))) return;
    if (count_fans(m_, gone_) > 0 && has_fans_on_point(kept_)) verdict_.refuse(Rule::joins_fans, {gone_, kept_});
    if (m_.next(h_) == twin(h_) && m_.prev(h_) == twin(h_)) verdict_.refuse(Rule::lone_edge, {edge(h_)});
  }

  // Another wire between the two points would begin and end at one.
  void check_other_wires() {
    if (!place_.has_other_wire()) return;
    for (Halfedge g : outgoing(m_, gone_))
      if (g != h_ && m_.is_wire(edge(g)) && same_point(m_, m_.to(g), kept_))
        verdict_.refuse(Rule::edge_exists, {edge(g)});
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
      if (!is_triangle_side(m_, side)) continue;
      if (m_.is_outside(twin(m_.next(side))) && m_.is_outside(twin(m_.prev(side))))
        verdict_.refuse(Rule::isolated_apex, {m_.to(m_.next(side)), m_.face(side)});
    }
    if (place_.apex_count == 2 && place_.apexes[0] == place_.apexes[1])
      verdict_.refuse(Rule::vanishes, {place_.apexes[0], m_.face(h_), m_.face(twin(h_))});
  }

  void check_holes() {
    for (Halfedge side : {h_, twin(h_)})
      if (m_.is_outside(side) && is_triangle(m_, side))
        verdict_.refuse(Rule::closes_hole, {m_.to(m_.next(side)), edge(m_.next(side)), edge(m_.prev(side))});
  }

  // Common neighbours of the removed vertex and of any copy of the remaining point.
  void check_common_neighbours() {
    if (!place_.may_share_neighbours()) return;
    for (Halfedge g : outgoing(m_, gone_)) {
      const Vertex x = m_.to(g);
      if (x == kept_ || place_.is_apex(x) || place_.is_tip_of_three_edge_hole(x)) continue;
      const std::vector<Halfedge> sheets = sheets_between(m_, kept_, x);
      if (!sheets.empty())
        verdict_.refuse(Rule::common_neighbour, {x, edge(g), edge(*std::min_element(sheets.begin(), sheets.end()))});
    }
  }

  void check_common_faces() {
    if (!place_.may_share_faces()) return;
    for (Halfedge g : outgoing(m_, gone_)) {
      if (m_.is_outside(g) || place_.is_at_edge(m_.face(g))) continue;
      for (Halfedge corner : halfedges_around(m_, m_.face(g)))
        if (same_point(m_, m_.from(corner), kept_)) verdict_.refuse(Rule::common_face, {m_.face(g)});
    }
  }

  // A face with rings or bridges must still split into simple loops.
  void check_loops() {
    if (!place_.may_break_loops(known_)) return;
    std::vector<Face> looked_at;
    for (Halfedge g : outgoing(m_, gone_)) {
      const Face f = m_.face(g);
      if (!f || std::find(looked_at.begin(), looked_at.end(), f) != looked_at.end() || known_.is_one_simple_loop(m_, f))
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

  const CollapsePlace place_;
  const Mesh& m_;
  LocalFacts& known_;
  const Halfedge h_;
  const Vertex gone_, kept_;
  Verdict verdict_;
};

}  // namespace

Halfedge CollapseEdge::directed(const Mesh& mesh) const {
  LocalFacts known;
  return directed(mesh, known);
}

Halfedge CollapseEdge::directed(const Mesh& mesh, LocalFacts& known) const {
  return known.has_several_fans(mesh, mesh.from(halfedge)) ? twin(halfedge) : halfedge;
}

Verdict CollapseEdge::judge(const Mesh& mesh, LocalFacts& known) const {
  Verdict verdict;
  if (is_gone(mesh, halfedge, verdict)) return verdict;
  const Vertex a = mesh.from(halfedge), b = mesh.to(halfedge);
  const bool goes_to_a = known.has_several_fans(mesh, a);
  if (goes_to_a && known.has_several_fans(mesh, b)) return refused_by(Rule::copies, {point(mesh, a), point(mesh, b)});
  return CollapseJudge(mesh, goes_to_a ? twin(halfedge) : halfedge, known).judge();
}

std::optional<Rule> CollapseEdge::broken_rule(const Mesh& mesh, LocalFacts& known) const {
  if (!is_there(mesh, halfedge)) return Rule::deleted;
  if (quick_collapse(mesh, halfedge) == QuickAnswer::legal) return std::nullopt;
  const Halfedge h = directed(mesh, known);
  if (known.has_several_fans(mesh, mesh.from(h))) return Rule::copies;
  return CollapseJudge(mesh, h, known).first_rule();
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
