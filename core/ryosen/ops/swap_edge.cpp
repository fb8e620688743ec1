#include "ryosen/ops/swap_edge.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/face_polygon.h"
#include "ryosen/ops/parameters/member_values.h"
#include "ryosen/ops/rules/corner_values.h"
#include "ryosen/ops/rules/face_geometry.h"
#include "ryosen/ops/rules/face_lists.h"
#include "ryosen/ops/rules/local_facts.h"
#include "ryosen/ops/rules/plain_check.h"

namespace ryosen {

namespace {

using namespace parameters;

constexpr OpParameter swap_parameters[] = {
    with_words(
        {"edge", "Edge", "稜線", "the edge that is turned", "回す稜線"},
        missing(required(edge<&SwapEdge::halfedge>("A-B")), "an edge A-B is missing", "稜線 A-B の指定がありません")),
    with_words({"back", "Backwards", "逆向き", "whether it is turned the other way", "反対の向きに回す"},
               optional(word<&SwapEdge::back, true>("back")))};

}  // namespace

constinit const OpInfo SwapEdge::info{.id = "swap",
                                      .name_en = "Swap edge",
                                      .name_ja = "稜線交換",
                                      .line = {.lists = {swap_parameters}},
                                      .help_en = "rotates the edge by one corner within its two faces",
                                      .help_ja = "稜線を両側の面の中で一角ぶん回す",
                                      .key = 'S',
                                      .target = OpTargetKind::edge,
                                      .group = OpGroup::orient,
                                      .aliases = "flip",
                                      .topology = Topology::kept};

namespace {

// One side of the swap: the face at `side` loses the vertex `loses` and gains `gains`, the end of the new edge in the
// other face.
struct Turn {
  Halfedge side;
  Halfedge lost_corner;
  Vertex loses, gains;
};

std::pair<Turn, Turn> turns(const Mesh& m, Halfedge h, bool back) {
  const Halfedge o = twin(h);
  if (back) return {{h, h, m.from(h), m.from(m.prev(o))}, {o, o, m.from(o), m.from(m.prev(h))}};
  return {{h, m.next(h), m.to(h), m.to(m.next(o))}, {o, m.next(o), m.to(o), m.to(m.next(h))}};
}

using Points = std::vector<std::uint32_t>;  // sorted set

Points points_after(const Mesh& m, const Turn& turn) {
  Points points;
  for (Halfedge corner : halfedges_around(m, m.face(turn.side)))
    points.push_back(point(m, m.from(corner) == turn.loses ? turn.gains : m.from(corner)).index);
  return point_set(points);
}

// Whether the face at h has exactly these points. With bridges it has more corners than points.
bool is_on(const Mesh& m, Halfedge h, const Points& points) {
  std::size_t count = 0;
  const auto is_in_all = [&](const auto& vertices) {
    for (Vertex v : vertices) {
      if (!std::binary_search(points.begin(), points.end(), point(m, v).index)) return false;
      ++count;
    }
    return count >= points.size() && point_set(loops_of(m, m.face(h)).corners) == points;
  };
  if (m.has_rings()) return is_in_all(vertices_around(m, m.face(h)));
  return is_in_all(CycleRange<detail::next, detail::from>(m, h));
}

// Another face with exactly these points: of several the last one in the one-ring of `around` and its copies.
Face find_face_on(const Mesh& m, const Points& points, Vertex around, std::span<const Face> except) {
  const std::vector<Face> equal = faces_on(m, points, except, 2);
  if (equal.size() < 2) return equal.empty() ? Face() : equal[0];
  Face found;
  const auto is_excluded = [&](Face f) { return std::find(except.begin(), except.end(), f) != except.end(); };
  for_each_copy(m, around, [&](Vertex copy) {
    for (Halfedge h : outgoing(m, copy)) {
      const Face f = m.face(h);
      if (f && !is_excluded(f) && is_on(m, h, points)) found = f;
    }
  });
  return found;
}

// The lists of a face with rings or a bridge must still split into simple loops.
void check_inner_loops(const Mesh& m, const Turn& turn, Verdict& verdict) {
  const Face f = m.face(turn.side);
  if (is_one_simple_loop(m, f)) return;
  CornerLoops after;
  for_each_loop(m, f, [&](Halfedge start) {
    std::vector<std::uint32_t> points;
    for (Halfedge corner : loop(m, start))
      points.push_back(point(m, corner == turn.lost_corner ? turn.gains : m.from(corner)).index);
    after.add(points);
  });
  if (!take_out_bridges(after)) verdict.refuse(Rule::loop, {f});
}

void check_side(const Mesh& m, const Turn& turn, const Turn& other, Verdict& verdict) {
  for (Halfedge corner : halfedges_around(m, m.face(turn.side))) {
    const Vertex v = m.from(corner);
    if (v != turn.loses && same_point(m, v, turn.gains)) verdict.refuse(Rule::corner_twice, {m.face(turn.side), v});
  }
  check_inner_loops(m, turn, verdict);
  const Face f = m.face(turn.side), g = m.face(other.side);
  const Face at_edge[] = {f, g};
  if (const Face twin_face = find_face_on(m, points_after(m, turn), turn.gains, at_edge))
    verdict.refuse(Rule::duplicate_face, {std::min(f, twin_face), std::max(f, twin_face)});
  if (const Face old_twin = find_face_on(m, point_set(loops_of(m, f).corners), turn.loses, {at_edge, 1}))
    verdict.refuse(Rule::loses_duplicate, {f, old_twin});
}

bool is_plainly_legal(const Mesh& m, Halfedge h, bool back, LocalFacts& known) {
  const Halfedge o = twin(h);
  if (m.is_outside(h) || m.is_outside(o) || m.face(h) == m.face(o) || is_cut_on_points(m, h)) return false;
  const auto [left, right] = turns(m, h, back);
  if (same_point(m, left.gains, right.gains) || are_joined(m, left.gains, right.gains)) return false;
  // Each side keeps the end that the other one loses.
  const Face f = m.face(h), g = m.face(o);
  return changes_plainly(m, {f, g, left.loses, right.loses, left.gains}, known) &&
         changes_plainly(m, {g, f, right.loses, left.loses, right.gains}, known);
}

}  // namespace

Verdict SwapEdge::check(const Mesh& m) const {
  if (m.exists(halfedge) && m.is_alive(halfedge) && quick_swap(m, halfedge) == QuickAnswer::legal) return {};
  return judge(m);
}

Verdict SwapEdge::check(const Mesh& m, LocalFacts& known) const {
  const bool is_plain = is_there(m, halfedge) && quick_swap(m, halfedge) != QuickAnswer::legal &&
                        is_plainly_legal(m, halfedge, back, known);
  return is_plain ? Verdict() : check(m);
}

bool SwapEdge::is_legal(const Mesh& m) const {
  if (!m.exists(halfedge) || !m.is_alive(halfedge)) return false;
  const QuickAnswer answer = quick_swap(m, halfedge);
  return answer == QuickAnswer::legal || (answer == QuickAnswer::unknown && judge(m).legal());
}

Verdict SwapEdge::judge(const Mesh& m) const {
  Verdict verdict;
  const Halfedge h = halfedge, o = twin(h);
  if (is_gone(m, h, verdict)) return verdict;
  if (is_cut_on_points(m, h)) return refused_by(Rule::copies, {point(m, m.from(h)), point(m, m.to(h))});
  if (m.is_outside(h) || m.is_outside(o)) return refused_by(Rule::boundary, {edge(h)});
  const auto [left, right] = turns(m, h, back);
  // With the same face or the same opposite vertex on both sides there is no other edge to swap to.
  if (m.face(h) == m.face(o) || same_point(m, left.gains, right.gains))
    return refused_by(Rule::corner_twice, {m.face(h), right.gains});
  const std::vector<Halfedge> existing = sheets_between(m, left.gains, right.gains);
  if (!existing.empty()) verdict.refuse(Rule::edge_exists, {edge(existing.front())});
  check_side(m, left, right, verdict);
  check_side(m, right, left, verdict);
  return verdict;
}

std::vector<Reason> SwapEdge::warnings(const Mesh& m) const {
  std::vector<Reason> found;
  if (is_seam(m, halfedge)) found.push_back({Rule::seam, {edge(halfedge)}});
  ShapeDoubts shape;
  const auto [left, right] = turns(m, halfedge, back);
  // The normal of each new face must agree with both old ones.
  for (const Turn& turn : {left, right}) {
    FacePolygon polygon(m, m.face(turn.side));
    polygon.move(turn.lost_corner, m.position(turn.gains));
    const FaceGeometry after(polygon.keyhole_walk());
    bool turns_face = false;
    for (Halfedge side : {halfedge, twin(halfedge)}) {
      polygon.read(m, m.face(side));
      turns_face |= FaceGeometry(polygon.keyhole_walk()).turns_against(after);
    }
    if (after.is_degenerate())
      shape.degenerate.push_back(m.face(turn.side));
    else if (turns_face)
      shape.turned.push_back(m.face(turn.side));
  }
  shape.add_to(found);
  return found;
}

namespace {

// What the swap does to the face at one half of the edge; the other half is symmetric.
//
//   forward, left of h:   p -> (next of the twin) -> h -> next(next(h))        next(h) moves to the other face
//   back, left of h:      prev(p) -> h -> (prev of the twin) -> next(h)        p = prev(h) moves
struct SwapSide {
  Halfedge half, lost, gained, at_old_origin;
  Vertex old_origin, new_origin;
  Face face;
  std::array<Halfedge, 4> chain;  // part of the face's resulting loop

  SwapSide(const Mesh& m, Halfedge h, bool back)
      : half(h), at_old_origin(m.next(twin(h))), old_origin(m.from(h)), face(m.face(h)) {
    const Halfedge n = m.next(h), p = m.prev(h), o = twin(h);
    lost = back ? p : n;
    gained = back ? m.prev(o) : m.next(o);
    new_origin = back ? m.from(p) : m.to(gained);
    chain = back ? std::array{m.prev(p), h, gained, n} : std::array{p, gained, h, m.next(n)};
  }
};

void apply_side(Edit& edit, const SwapSide& s) {
  const Mesh& m = edit.mesh();
  for (std::size_t i = 0; i + 1 < s.chain.size(); ++i) edit.connect(s.chain[i], s.chain[i + 1]);
  edit.set_face(s.gained, s.face);
  edit.set_from(s.half, s.new_origin);
  // The gained corner replaces the lost one.
  if (!replace_start(edit, s.face, s.lost, s.half)) replace_start(edit, s.face, s.half, s.gained);
  if (m.halfedge(s.old_origin) == s.half) edit.set_halfedge(s.old_origin, s.at_old_origin);
}

// A corner gained by a face takes the values of the same vertex in the other face.
void turn_corner_values(Edit& edit, Halfedge h, bool back) {
  const Mesh& m = edit.mesh();
  const Halfedge o = twin(h), n = m.next(h), no = m.next(o);
  if (!back) {
    edit.derive(no, h, Derivation::copies);
    edit.derive(n, o, Derivation::copies);
  }
  edit.derive(h, back ? m.prev(h) : m.next(no), Derivation::copies);
  edit.derive(o, back ? m.prev(o) : m.next(n), Derivation::copies);
}

}  // namespace

OpEffect SwapEdge::apply(Edit& edit) const {
  const Mesh& m = edit.mesh();
  assert(check(m).legal());
  turn_corner_values(edit, halfedge, back);
  const SwapSide left(m, halfedge, back), right(m, twin(halfedge), back);
  apply_side(edit, left);
  apply_side(edit, right);
  return {.changed = {left.face, right.face}};
}

}  // namespace ryosen
