// By how much the terms of V - E + F + B - H = 2(S - G) change, as the header of each operator states it.
#pragma once

#include <map>
#include <set>
#include <variant>
#include <vector>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/rings.h"
#include "ryosen/ops/rules/face_lists.h"
#include "ryosen/ops/rules/surgery.h"
#include "tests/support/core/kernel_lists.h"
#include "tests/support/core/proof.h"

namespace ryosen::test {

inline int triangles_at(const Mesh& m, Halfedge h) {
  int count = 0;
  for (Halfedge side : {h, twin(h)}) count += !m.is_outside(side) && is_triangle(m, side) && !m.has_rings(m.face(side));
  return count;
}

inline bool is_on_cycle(const Mesh& m, Halfedge start, Halfedge wanted) {
  for (Halfedge h : loop(m, start))
    if (h == wanted) return true;
  return false;
}

inline std::int64_t rings_of(const Mesh& m, Face f) {
  std::int64_t loops = -1;
  for_each_loop(m, f, [&](Halfedge) { ++loops; });
  return loops;
}

inline std::int64_t corners_of(const Mesh& m, Face f) { return static_cast<std::int64_t>(corner_count(m, f)); }

// The changes that an operator states; several where it names several cases, none where it states none in numbers.
struct Stated {
  const Mesh& m;

  std::vector<Change> of(const CollapseEdge& op) const {
    const int k = triangles_at(m, op.halfedge);
    return {{.v = -1, .e = -1 - k, .f = -k}};
  }
  std::vector<Change> of(const SwapEdge&) const { return {{}}; }
  std::vector<Change> of(const SplitEdge& op) const {
    const int k = triangles_at(m, op.halfedge);
    if (is_cut_on_points(m, op.halfedge)) return {};
    return {{.v = 1, .e = 1 + k, .f = k}};
  }
  std::vector<Change> of(const Poke& op) const {
    const auto n = corners_of(m, op.face);
    return {{.v = 1, .e = n, .f = n - 1}};
  }
  // By the sides of the faces as pairs of vertices, on a mesh without copies.
  std::vector<Change> of(const Extrude& op) const {
    if (m.has_copies()) return {};
    const std::set<Face> named(op.faces.begin(), op.faces.end());
    std::map<Vertex, int> border_at;
    std::int64_t b = 0;
    for (Face f : named)
      for (Halfedge h : halfedges_around(m, f)) {
        if (m.face(twin(h)) && named.contains(m.face(twin(h)))) continue;
        ++b, ++border_at[m.from(h)], ++border_at[m.to(h)];
      }
    for (const auto& [v, edges] : border_at)
      if (edges != 2) return {};
    return {{.v = b, .e = 2 * b, .f = b}};
  }
  // Along open chains of a boundary, as it runs.
  std::vector<Change> of(const ExtrudeEdges& op) const {
    if (m.has_copies()) return {};
    std::set<Halfedge> named;
    std::map<Vertex, int> leaving, entering;
    for (Halfedge h : op.edges) {
      const Halfedge out = m.is_outside(h) ? h : twin(h);
      if (m.is_wire(edge(h)) || !m.is_outside(out)) return {};
      if (gaps_at(m, m.from(h)).size() != 1 || gaps_at(m, m.to(h)).size() != 1) return {};  // several fans
      if (!named.insert(out).second) continue;
      if (++leaving[m.from(out)] > 1 || ++entering[m.to(out)] > 1) return {};
    }
    const auto e = static_cast<std::int64_t>(named.size());
    const auto starts =
        std::count_if(leaving.begin(), leaving.end(), [&](const auto& at) { return !entering[at.first]; });
    // A part of them that closes has no start.
    for (const Halfedge first : named)
      for (Halfedge h = first; named.contains(h); h = next_of(named, h))
        if (next_of(named, h) == first) return {};
    return {{.v = e + starts, .e = 2 * e + starts, .f = e}};
  }
  Halfedge next_of(const std::set<Halfedge>& named, Halfedge h) const {
    const auto next = std::find_if(named.begin(), named.end(), [&](Halfedge n) { return m.from(n) == m.to(h); });
    return next == named.end() ? Halfedge() : *next;
  }
  std::vector<Change> of(const Triangulate& op) const {
    if (!op.face || bridges_of(loops_of(m, op.face)) > 0) return {};
    const auto n = corners_of(m, op.face), h = rings_of(m, op.face);
    return {{.e = n + 3 * h - 3, .f = n + 2 * h - 3, .h = -h}};
  }
  std::vector<Change> of(const VertexSplit& op) const {
    if (op.left && op.right) return {{.v = 1, .e = 3, .f = 2}};
    return {{.v = 1, .e = 2, .f = 1}};
  }
  std::vector<Change> of(const Fill&) const {
    if (m.has_copies()) return {};
    return {{.f = 1, .b = -1}};
  }
  std::vector<Change> of(const MakeVertex&) const { return {{.v = 1, .s = 1, .b = 1}}; }
  std::vector<Change> of(const RemoveVertex&) const { return {{.v = -1, .s = -1, .b = -1}}; }
  std::vector<Change> of(const MoveVertex&) const { return {{}}; }
  std::vector<Change> of(const MakeEdge& op) const {
    if (!op.into_a || !op.into_b) return {{.e = 1, .s = -1, .b = -1}};
    if (is_on_cycle(m, op.into_a, op.into_b)) return {{.e = 1, .b = 1}};
    return {{.e = 1, .s = -1, .b = -1}, {.e = 1, .g = 1, .b = -1}};
  }
  std::vector<Change> of(const DeleteEdge& op) const {
    if (!is_on_cycle(m, op.halfedge, twin(op.halfedge))) return {{.e = -1, .b = -1}};
    return {{.e = -1, .s = 1, .b = 1}, {.e = -1, .g = -1, .b = 1}};
  }
  std::vector<Change> of(const MakeLoop&) const { return {{.f = 1, .b = -1}}; }
  std::vector<Change> of(const DeleteLoop& op) const {
    const auto r = rings_of(m, op.face);
    std::vector<Change> cases;
    for (std::int64_t s = 0; s <= r; ++s) cases.push_back({.f = -1, .h = -r, .s = s, .g = s - r, .b = 1 + r});
    return cases;
  }
  std::vector<Change> of(const SeparateLoop&) const { return {{.e = 1, .f = 1}}; }
  std::vector<Change> of(const UniteLoop&) const { return {{.e = -1, .f = -1}}; }
  std::vector<Change> of(const SeparateEdge& op) const {
    if (is_cut_on_points(m, op.halfedge)) return {};
    return {{.v = 1, .e = 1}};
  }
  std::vector<Change> of(const UniteEdge&) const { return {{.v = -1, .e = -1}}; }
  std::vector<Change> of(const MakeRing&) const { return {{.e = -1, .h = 1}}; }
  std::vector<Change> of(const UniteRing&) const { return {{.e = 1, .h = -1}}; }
};

template <class Laws, class Op>
concept HasLawOf = requires(const Laws& laws, const Op& op) {
  laws.of(op);
};

// What the laws say of the operator; nothing where they have none for it.
template <class Laws>
auto law_of(const Laws& laws, const AnyOp& op) {
  using Law = decltype(laws.of(MakeLoop{}));
  return std::visit(
      [&]<class Op>(const Op& o) -> Law {
        if constexpr (HasLawOf<Laws, Op>) return laws.of(o);
        return {};
      },
      op);
}

// How many operators they have one for.
template <class Laws, class... Op>
constexpr std::size_t count_laws(const std::variant<Op...>*) {
  return (std::size_t{HasLawOf<Laws, Op>} + ...);
}
template <class Laws>
constexpr std::size_t law_count = count_laws<Laws>(static_cast<const AnyOp*>(nullptr));

}  // namespace ryosen::test
