#include "ryosen/ops/rules/weld_judge.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/faces_at.h"
#include "ryosen/ops/op.h"
#include "ryosen/ops/rules/face_lists.h"

namespace ryosen {

namespace {

using Points = std::vector<std::uint32_t>;
using Ends = std::pair<Vertex, Vertex>;

class WeldJudge {
 public:
  WeldJudge(const Mesh& m, const WeldPairs& pairs, Verdict& verdict) : m_(m), verdict_(verdict) {
    for (const auto& [goes, stays] : pairs) {
      becomes_[goes] = stays;
      const std::uint32_t both[] = {goes.index, stays.index};
      const Vertex smaller = loneliest_point(m, both);
      stars_.push_back({smaller, smaller == goes ? stays : goes});
    }
  }

  bool has_common_face() const {
    return std::any_of(stars_.begin(), stars_.end(), [&](const Star& s) { return has_common_face(s); });
  }

  void judge() {
    for (const Star& star : stars_) walk(star);
    for (Face f : torn_)
      for (const auto& [goes, stays] : becomes_) verdict_.refuse(Rule::common_face, {f, goes, stays});
    for (const Ends& ends : edges_) check_edge(ends);
    if (verdict_.legal()) check_duplicates();
  }
  std::uint64_t looks() const { return looks_; }

 private:
  struct Star {
    Vertex point, other;
  };
  // All edges that come to lie between the same two points.
  struct Joined {
    std::size_t pairs = 0;  // of points before
    std::vector<Edge> edges;
    std::uint32_t forward = 0, backward = 0;
    bool has_wire = false;
  };

  Vertex after(Vertex p) const {
    const auto found = becomes_.find(p);
    return found == becomes_.end() ? p : found->second;
  }
  // The points that become this one.
  std::vector<Vertex> before(Vertex p) const {
    std::vector<Vertex> all{p};
    for (const auto& [goes, stays] : becomes_)
      if (stays == p) all.push_back(goes);
    return all;
  }
  Points points_before(Face f) const { return point_set(loops_of(m_, f).corners); }
  Points points_after(Face f) const {
    Points points = loops_of(m_, f).corners;
    for (std::uint32_t& p : points) p = after(Vertex(p)).index;
    return point_set(points);
  }

  bool has_common_face(const Star& star) const {
    return any_of_faces_at(m_, star.point, [&](Face f) { return touches(m_, f, star.other); });
  }

  // Whatever two merged points share is found from either of them.
  void walk(const Star& star) {
    std::set<Face> around;
    for_each_copy(m_, star.point, [&](Vertex copy) {
      for (Halfedge h : outgoing(m_, copy)) {
        ++looks_;
        Ends ends{after(star.point), after(point(m_, m_.to(h)))};
        // Between two merged points it is the same from both ends.
        if (before(ends.second).size() > 1 && ends.second < ends.first) std::swap(ends.first, ends.second);
        edges_.insert(ends);
        const Face f = m_.face(h);
        if (f && around.insert(f).second && touches(m_, f, star.other)) torn_.insert(f);
      }
    });
    faces_.merge(around);
  }

  Joined joined(const Ends& ends) const {
    Joined all;
    for (const Vertex p : before(ends.first))
      for (const Vertex q : before(ends.second)) {
        const std::vector<Halfedge> sheets = p == q ? std::vector<Halfedge>() : sheets_between(m_, p, q);
        all.pairs += !sheets.empty();
        for (const Halfedge h : sheets) {
          all.edges.push_back(edge(h));
          all.forward += !m_.is_outside(h);
          all.backward += !m_.is_outside(twin(h));
          all.has_wire |= m_.is_wire(edge(h));
        }
      }
    return all;
  }

  // Edges that become coincident must be the two sides of a gap; no wire may join two points that are merged.
  void check_edge(const Ends& ends) {
    if (ends.first == ends.second) return check_shrinking(ends.first);
    Joined all = joined(ends);
    if (all.pairs < 2 || (!all.has_wire && all.forward == 1 && all.backward == 1)) return;
    std::sort(all.edges.begin(), all.edges.end());
    verdict_.reasons.push_back({Rule::common_neighbour, {ends.second}});
    for (Edge e : all.edges) verdict_.reasons.back().witnesses.push_back(e);
  }

  void check_shrinking(Vertex stays) {
    std::vector<Vertex> both = before(stays);
    std::sort(both.begin(), both.end());
    const Edge between = edge(sheets_between(m_, both[0], both[1]).front());
    if (m_.is_wire(between)) verdict_.refuse(Rule::edge_exists, {between});
  }

  // The faces on these points after the weld, ascending: each merged point is one of its two before.
  std::vector<Face> faces_that_become(const Points& points) const {
    std::vector<Points> choices{points};
    for (const auto& [goes, stays] : becomes_) {
      if (!std::binary_search(points.begin(), points.end(), stays.index)) continue;
      for (std::size_t i = choices.size(); i-- > 0;) {
        Points other = choices[i];
        std::replace(other.begin(), other.end(), stays.index, goes.index);
        choices.push_back(std::move(other));
      }
    }
    std::vector<Face> faces;
    for (Points& choice : choices) {
      std::sort(choice.begin(), choice.end());
      const auto found = faces_on(m_, choice, {}, std::numeric_limits<std::size_t>::max());
      faces.insert(faces.end(), found.begin(), found.end());
    }
    std::sort(faces.begin(), faces.end());
    return faces;
  }

  void check_duplicates() {
    std::set<Points> on;
    for (Face f : faces_) {
      Points points = points_after(f);
      looks_ += points.size();
      on.insert(std::move(points));
    }
    for (const Points& points : on) {
      const std::vector<Face> faces = faces_that_become(points);
      for (std::size_t i = 1; i < faces.size(); ++i)
        if (points_before(faces[i]) != points_before(faces[0]))
          verdict_.refuse(Rule::duplicate_face, {faces[0], faces[i]});
    }
  }

  const Mesh& m_;
  Verdict& verdict_;
  std::map<Vertex, Vertex> becomes_;
  std::vector<Star> stars_;
  std::set<Face> faces_, torn_;  // around the smaller points; of these, those with both points of a pair
  std::set<Ends> edges_;         // after the weld
  std::uint64_t looks_ = 0;
};

}  // namespace

void judge_weld(const Mesh& mesh, const WeldPairs& pairs, Verdict& verdict, std::uint64_t* looks) {
  WeldJudge judge(mesh, pairs, verdict);
  judge.judge();
  if (looks) *looks += judge.looks();
}

std::optional<Rule> first_rule_of_weld(const Mesh& mesh, const WeldPairs& pairs) {
  Verdict verdict;
  WeldJudge judge(mesh, pairs, verdict);
  if (judge.has_common_face()) return Rule::common_face;
  judge.judge();
  return first_rule_of(verdict);
}

bool have_common_face(const Mesh& mesh, const WeldPairs::value_type& pair) {
  Verdict unused;
  return WeldJudge(mesh, {pair}, unused).has_common_face();
}

}  // namespace ryosen
