#include "core/ops/euler/unite_series.h"

#include <array>

#include "core/mesh/circulate.h"
#include "core/mesh/copies.h"
#include "core/ops/euler/unite_edge.h"
#include "core/ops/rules/face_lists.h"
#include "core/ops/rules/surgery.h"

namespace ryosen {

std::uint32_t UniteSeries::corner_count(Face f) {
  bool is_new = false;
  const std::uint32_t count = known_.corner_count(mesh(), f, &is_new);
  if (is_new) looks_ += count;
  return count;
}

// A simple loop keeps being one. Only a face of one corner less at both neighbours may lie on the points that are left.
UniteSeries::Answer UniteSeries::answer_of_face(Face f, Face beyond, Vertex a, Vertex b) {
  if (!known_.is_one_simple_loop(mesh(), f)) return Answer::unsure;
  const std::uint32_t corners = corner_count(f);
  if (corners == 3) return Answer::no;
  const std::array<std::uint32_t, 2> both{a.index, b.index};
  const bool is_unsure = any_of_copies(mesh(), loneliest_point(mesh(), both), [&](Vertex copy) {
    for (const Face other : faces_around(mesh(), copy)) {
      ++looks_;
      if (other && other != f && other != beyond && corner_count(other) + 1 == corners) return true;
    }
    return false;
  });
  return is_unsure ? Answer::unsure : Answer::yes;
}

UniteSeries::Answer UniteSeries::answer_of(Vertex v) {
  const Mesh& m = mesh();
  if (has_copies(m, v) || !has_two_edges(m, v)) return Answer::no;
  const Halfedge out = m.halfedge(v), other = m.counter_clockwise(out);
  const Vertex a = m.to(out), b = m.to(other);
  if (any_sheet_between(m, a, b)) return Answer::no;
  Answer answer = Answer::yes;
  const Face f = m.face(out), g = m.face(other);
  for (const auto& [face, beyond] : {std::pair{f, g}, std::pair{g, f}}) {
    if (!face) continue;
    const Answer own = answer_of_face(face, beyond, a, b);
    if (own == Answer::no) return own;
    if (own == Answer::unsure) answer = own;
  }
  return answer;
}

bool UniteSeries::unite(Vertex v) {
  const Answer answer = answer_of(v);
  const UniteEdge op{v};
  if (answer == Answer::no || (answer == Answer::unsure && !op.check(mesh()).legal())) return false;
  const OpEffect effect = op.apply(edit_);
  for (const Face f : effect.changed) {
    if (answer == Answer::yes)
      known_.lost_corner(f);
    else
      known_.forget(f);
  }
  return true;
}

}  // namespace ryosen
