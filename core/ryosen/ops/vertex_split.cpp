#include "ryosen/ops/vertex_split.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "ryosen/base/sort_unique.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/parameters/member_values.h"
#include "ryosen/ops/rules/corner_values.h"
#include "ryosen/ops/rules/face_geometry.h"
#include "ryosen/ops/rules/face_lists.h"
#include "ryosen/ops/rules/surgery.h"
#include "ryosen/ops/rules/united_values.h"

namespace ryosen {

namespace {

// The part of a one-ring that moves to the new vertex.
struct Sector {
  std::vector<Halfedge> edges;  // outgoing from v, strictly between left and right, counter-clockwise
  std::vector<Face> faces;      // faces in it, each once
  std::size_t gaps = 0;         // inside it, not counting those at an open end
  bool reaches_gap = true;      // if left or right is none
};

// Collects the sector; reaches_gap: whether a missing end is at a gap.
Sector sector_of(const Mesh& m, Halfedge left, Halfedge right) {
  Sector sector;
  const Halfedge start = left ? left : right;
  if (left && right) {
    for (Halfedge h = m.counter_clockwise(left); h != right; h = m.counter_clockwise(h)) sector.edges.push_back(h);
  } else if (left) {
    for (Halfedge h = left; !m.is_outside(h);) {
      h = m.counter_clockwise(h);
      if (h == start) return sector.reaches_gap = false, sector;
      sector.edges.push_back(h);
    }
  } else {
    for (Halfedge h = right; !m.is_outside(twin(h));) {
      h = m.clockwise(h);
      if (h == start) return sector.reaches_gap = false, sector;
      sector.edges.push_back(h);
    }
    std::reverse(sector.edges.begin(), sector.edges.end());
  }
  const auto look_left_of = [&](Halfedge h) {
    if (m.is_outside(h))
      ++sector.gaps;
    else
      sector.faces.push_back(m.face(h));
  };
  if (left && (right || !sector.edges.empty())) look_left_of(left);
  for (Halfedge h : sector.edges)
    if (right || h != sector.edges.back()) look_left_of(h);
  sort_unique(sector.faces);
  return sector;
}

// Whether the two edges are connected around v without a gap between, in either direction.
bool are_in_one_fan(const Mesh& m, Halfedge a, Halfedge b) {
  for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
    for (Halfedge h = from; !m.is_outside(h);) {
      h = m.counter_clockwise(h);
      if (h == to) return true;
      if (h == from) break;
    }
  }
  return false;
}

bool is_taken(const Sector& sector, Halfedge left, Halfedge h) {
  return h == left || std::find(sector.edges.begin(), sector.edges.end(), h) != sector.edges.end();
}

// The corners of a loop after the split: `fresh` replaces v in the sector.
template <class Value, class At>
std::vector<Value> corners_after(const Mesh& mesh, Halfedge start, const Sector& sector, Halfedge left, Value fresh,
                                 At at) {
  std::vector<Value> corners;
  for (Halfedge h : loop(mesh, start)) corners.push_back(is_taken(sector, left, h) ? fresh : at(mesh.from(h)));
  return corners;
}

void check_faces(const Mesh& m, const Sector& sector, Halfedge left, Verdict& verdict) {
  const std::uint32_t fresh = m.vertex_slots();
  for (Face f : sector.faces) {
    CornerLoops after;
    for_each_loop(m, f, [&](Halfedge start) {
      after.add(corners_after(m, start, sector, left, fresh, [&](Vertex v) { return point(m, v).index; }));
    });
    const auto parts = take_out_bridges(after);
    if (!parts || parts->size() - after.ends.size() != bridges_of(loops_of(m, f)))
      verdict.refuse(Rule::loop, {f});
    else if (const Face other = face_on(m, point_set(loops_of(m, f).corners), sector.faces))
      verdict.refuse(Rule::loses_duplicate, {f, other});
  }
}

// Refuses a wire v-L (or v-R), and a cut edge that would get an additional face.
void check_end(const Mesh& m, Halfedge end, bool has_face, Verdict& verdict) {
  if (m.is_wire(edge(end)))
    verdict.refuse(Rule::wire, {edge(end)});
  else if (!has_face && is_cut_on_points(m, end))
    verdict.refuse(Rule::copies, {point(m, m.from(end)), point(m, m.to(end))});
}

using namespace parameters;

constexpr OpParameter vertex_split_parameters[] = {
    with_words({"vertex", "Vertex", "頂点", "the vertex that becomes an edge", "稜線にする頂点"},
               required(one_copy<&VertexSplit::vertex>("v"))),
    with_words({"left", "Left neighbour", "左の隣接頂点",
                "the neighbour at which the faces of the new end begin, counter-clockwise (- for none)",
                "新しい端点の面が始まる隣接頂点（反時計回り、ないときは -）"},
               required(element(OpValueKind::vertex, "L"), element(OpValueKind::edge, "v-L"),
                        element(OpValueKind::word, "-"))),
    with_words({"right", "Right neighbour", "右の隣接頂点",
                "the neighbour at which the faces of the new end stop (- for none)",
                "新しい端点の面が終わる隣接頂点（ないときは -）"},
               required(element(OpValueKind::vertex, "R"), element(OpValueKind::edge, "v-R"),
                        element(OpValueKind::word, "-"))),
    with_words({"at", "Position", "座標", "where the new end lies (on the way to its neighbours if it is left out)",
                "新しい端点の座標（省くと隣接頂点への途中）"},
               optional(position<&VertexSplit::target>()))};

// The outgoing halfedge named by an argument: by its end, or as an edge if several lead to one point. `-` gives none.
Halfedge read_end(const Mesh& mesh, Vertex v, ArgumentReader& in) {
  const std::string text = in.peek_text();
  if (in.word("-")) return Halfedge();
  if (text.find('-') != std::string::npos) {
    const Halfedge h = in.halfedge();
    if (in.failed() || mesh.from(h) == v) return h;
    if (mesh.to(h) == v) return twin(h);
    in.fail(NameError::never_existed, {"'" + text + "' does not end at " + name_of_copy(mesh, v),
                                       "「" + text + "」は " + name_of_copy(mesh, v) + " に接していません"});
    return Halfedge();
  }
  const Vertex end = in.vertex();
  if (in.failed()) return Halfedge();
  std::vector<Halfedge> found;
  if (!mesh.is_isolated(v))
    for (Halfedge h : outgoing(mesh, v))
      if (same_point(mesh, mesh.to(h), end)) found.push_back(h);
  if (found.size() == 1) return found[0];
  const std::string a = name_of_copy(mesh, v), b = name_of(mesh, end);
  if (found.empty()) {
    in.fail(NameError::never_existed, {"no edge joins " + a + " and " + b, a + " と " + b + " を結ぶ稜線はありません"});
    return Halfedge();
  }
  std::string list;
  for (Halfedge h : found) list += (list.empty() ? "" : ", ") + name_of(mesh, h);
  in.fail(NameError::ambiguous, {"several edges join " + a + " and " + b + "; name one of " + list,
                                 a + " と " + b + " を結ぶ稜線が複数あります。次から指定してください：" + list});
  return Halfedge();
}

std::string end_text(const Mesh& mesh, Vertex v, Halfedge end) {
  if (!end) return "-";
  if (!is_there(mesh, v) || !is_there(mesh, end)) return name_of(mesh, end);
  std::size_t same = 0;
  for (Halfedge h : outgoing(mesh, v)) same += same_point(mesh, mesh.to(h), mesh.to(end));
  return same == 1 ? name_of(mesh, mesh.to(end)) : name_of(mesh, end);
}

void read_ends(const Mesh& mesh, ArgumentReader& in, void* op) {
  VertexSplit& split = *static_cast<VertexSplit*>(op);
  split.left = read_end(mesh, split.vertex, in);
  if (!in.failed()) split.right = read_end(mesh, split.vertex, in);
  if (!in.at_end()) split.target = in.place();
  if (!in.failed() && !split.left && !split.right)
    in.fail(NameError::malformed,
            {"one of L and R must be a neighbour", "L と R の一方は隣接頂点でなければなりません"});
}

void print_ends(const Mesh& mesh, const void* op, std::string& line) {
  const VertexSplit& split = *static_cast<const VertexSplit*>(op);
  for (const Halfedge end : {split.left, split.right}) line += " " + end_text(mesh, split.vertex, end);
}

glm::dvec3 mean_of_ends(const Mesh& m, const std::vector<Halfedge>& edges) {
  glm::dvec3 mean{};
  for (Halfedge h : edges) mean += m.position(m.to(h)) / static_cast<double>(edges.size());
  return mean;
}

// With m at a given position.
ShapeDoubts shape_with(const Mesh& m, const VertexSplit& op, const Sector& sector, const glm::dvec3& place) {
  ShapeDoubts shape;
  std::vector<Halfedge> ends;
  for (Halfedge h : {op.left, op.right})
    if (h) ends.push_back(h);
  for (Face f : sector.faces) {
    FaceGeometry before, after;
    for (Halfedge h : loop(m, m.halfedge(f))) {
      before.add(m.position(m.from(h)));
      after.add(is_taken(sector, op.left, h) ? place : m.position(m.from(h)));
    }
    if (!before.is_degenerate()) shape.compare(before, after, f);
  }
  // Compare a new triangle with the faces on both sides of its edge.
  for (Halfedge end : ends) {
    const glm::dvec3 &v = m.position(op.vertex), &x = m.position(m.to(end));
    const FaceGeometry fresh{end == op.left ? std::vector{v, x, place} : std::vector{v, place, x}};
    if (fresh.is_degenerate()) shape.degenerate.push_back(edge(end));
    bool turned = false;
    for (Halfedge side : {end, twin(end)}) {
      if (m.is_outside(side)) continue;
      const FaceGeometry beside(places_along(m, m.halfedge(m.face(side))));
      turned = turned || (!beside.is_degenerate() && beside.turns_against(fresh));
    }
    if (turned) shape.turned.push_back(edge(end));
  }
  return shape;
}

// Inserts the new edges, after the old ones have been distributed to v and m.
//
//        v --left--> L         The new edge m -> L replaces v -> L in the sector; v -> L, L -> m, m -> v become a
//         <         /          triangle. At R the new edge R -> m replaces R -> v.
//           \      v
//              m
class Splitter {
 public:
  Splitter(Edit& edit, Vertex v, const glm::dvec3& place) : edit_(edit), m_(edit.mesh()) {
    fresh_ = edit.add_vertex(place);
    const Vertex halves[] = {v, fresh_};
    edit.divide<Vertex>(v, halves, [] { return std::vector<double>{1, 1}; });
    for_each_copy(m_, v, [&](Vertex copy) { edit.derive(copy, v, Derivation::copies); });
    between_ = edit.add_edge(v, fresh_);
    edit.fresh(edge(between_));
    effect_.created = {fresh_, edge(between_)};
  }

  Vertex fresh() const { return fresh_; }
  Halfedge between() const { return between_; }  // v -> m
  Halfedge beside_left() const { return beside_left_; }
  const OpEffect& effect() const { return effect_; }

  void open_left(Halfedge left) {
    beside_left_ = edit_.add_edge(fresh_, m_.to(left));
    const Halfedge after = m_.next(left), beyond = twin(left), beyond_v = m_.next(beyond);
    add_triangle({left, twin(beside_left_), twin(between_)}, left, beside_left_,
                 {first_inside(beyond_v, left), first_inside(after, beyond), first_inside(left, beyond_v)});
  }

  void open_right(Halfedge right) {
    const Halfedge out = edit_.add_edge(fresh_, m_.to(right)), part = twin(right);
    const Halfedge part_v = m_.next(part), beyond_end = m_.next(right);
    add_triangle({between_, out, part}, part, twin(out),
                 {first_inside(right, part_v), first_inside(part_v, right), first_inside(part, beyond_end)});
  }

  // Links the boundary halfedge h just before `gap`.
  void lead_past(Halfedge h, Halfedge gap) {
    edit_.connect(m_.prev(gap), h);
    edit_.connect(h, gap);
  }

 private:
  Halfedge first_inside(Halfedge a, Halfedge b) const { return m_.is_outside(a) ? b : a; }

  // `fresh` replaces `old` in the sector; `old` becomes a side of the new triangle, whose corners copy their values
  // from the corners `like`.
  void add_triangle(std::array<Halfedge, 3> sides, Halfedge old, Halfedge fresh, std::array<Halfedge, 3> like) {
    const Face part = m_.face(old), beside = part ? part : m_.face(twin(old));
    if (part) edit_.derive(fresh, old, Derivation::copies);
    for (const bool is_old : {false, true})
      for (std::size_t i = 0; i < 3; ++i)
        if ((sides[i] == old) == is_old) edit_.derive(sides[i], like[i], Derivation::copies);
    const Halfedge before = m_.prev(old), after = m_.next(old);
    edit_.connect(before, fresh);
    edit_.connect(fresh, after);
    edit_.set_face(fresh, part);
    if (part) replace_start(edit_, part, old, fresh);
    const Face face = edit_.add_face(sides[0]);
    const Face with_new[] = {beside, face};
    edit_.divide<Face>(beside, with_new, [] { return std::vector<double>{1, 0}; });
    const Edge halves[] = {edge(old), edge(fresh)};
    edit_.divide<Edge>(edge(old), halves, [] { return std::vector<double>{1, 1}; });
    for (std::size_t i = 0; i < 3; ++i) {
      edit_.connect(sides[i], sides[(i + 1) % 3]);
      edit_.set_face(sides[i], face);
    }
    effect_.created.insert(effect_.created.end(), {edge(fresh), face});
    effect_.changed.push_back(face);
  }

  Edit& edit_;
  const Mesh& m_;
  Vertex fresh_;
  Halfedge between_, beside_left_;
  OpEffect effect_;
};

}  // namespace

constinit const OpInfo VertexSplit::info{
    .id = "vertex_split",
    .name_en = "Split vertex",
    .name_ja = "頂点分割",
    .line = {.lists = {vertex_split_parameters}, .read_rest = read_ends, .print_rest = print_ends},
    .help_en = "splits a vertex into an edge; the new end gets the faces from L counter-clockwise to R",
    .help_ja = "頂点を稜線にする。新しい端点が L から反時計回りに R までの部分を受け持つ",
    .target = OpTargetKind::selection,
    .group = OpGroup::refine,
    .topology = Topology::kept,
    .on_selection = OnSelection::all};

glm::dvec3 VertexSplit::position(const Mesh& m) const {
  if (target) return *target;
  const Sector sector = sector_of(m, left, right);
  std::vector<Halfedge> taken = sector.edges, kept;
  for (Halfedge h : {left, right})
    if (h) taken.push_back(h), kept.push_back(h);
  for (Halfedge h : outgoing(m, vertex))
    if (h != right && !is_taken(sector, left, h)) kept.push_back(h);
  const glm::dvec3 v = m.position(vertex);
  const glm::dvec3 to = mean_of_ends(m, taken) - v, away = v - mean_of_ends(m, kept);
  const glm::dvec3 usual = v + 0.5 * to;
  if (!is_finite(usual)) return v;
  for (double step : {0.5, 0.25, 0.125}) {
    for (const glm::dvec3& direction : {to, away}) {
      const glm::dvec3 place = v + step * direction;
      const ShapeDoubts shape = shape_with(m, *this, sector, place);
      if (is_finite(place) && shape.turned.empty() && shape.degenerate.empty()) return place;
    }
  }
  return usual;
}

Verdict VertexSplit::check(const Mesh& m) const {
  Verdict verdict;
  if (is_gone(m, vertex, verdict)) return verdict;
  for (Halfedge h : {left, right})
    if (h && is_gone(m, h, verdict)) return verdict;
  for (Halfedge h : {left, right})
    if (h && m.from(h) != vertex) verdict.refuse(Rule::no_gap, {vertex, edge(h)});
  if (!left && !right) verdict.refuse(Rule::wire, {vertex});
  if (left && left == right) verdict.refuse(Rule::same_vertex, {m.to(left)});
  if (left && right && left != right && same_point(m, m.to(left), m.to(right)))
    verdict.refuse(Rule::same_vertex, {point(m, m.to(left))});
  if (!verdict.legal()) return verdict;
  const Sector sector = sector_of(m, left, right);
  if (!sector.reaches_gap) return refused_by(Rule::no_gap, {vertex});
  if (left) check_end(m, left, !m.is_outside(left), verdict);
  if (right) check_end(m, right, !m.is_outside(twin(right)), verdict);
  if (!verdict.legal()) return verdict;
  const bool in_one_fan = !left || !right || are_in_one_fan(m, left, right);
  if (!in_one_fan || (sector.gaps > 0 && count_fans(m, vertex) > 1))
    return refused_by(Rule::copies, {point(m, vertex)});
  for (Halfedge h : sector.edges)
    if (is_cut_on_points(m, h)) verdict.refuse(Rule::copies, {point(m, vertex), point(m, m.to(h))});
  check_faces(m, sector, left, verdict);
  return verdict;
}

std::vector<Reason> VertexSplit::warnings(const Mesh& m) const {
  std::vector<Reason> found;
  shape_with(m, *this, sector_of(m, left, right), position(m)).add_to(found);
  return found;
}

OpEffect VertexSplit::apply(Edit& edit) const {
  const Mesh& mesh = edit.mesh();
  assert(check(mesh).legal());
  const Sector sector = sector_of(mesh, left, right);
  Splitter splitter(edit, vertex, position(mesh));
  // The boundary halfedge that leaves v at the gap where the sector starts or ends.
  Halfedge gap;
  if (!left) gap = mesh.clockwise(sector.edges.empty() ? right : sector.edges.front());
  if (!right) gap = sector.edges.empty() ? Halfedge() : sector.edges.back();
  for (Halfedge h : sector.edges) edit.set_from(h, splitter.fresh());
  if (left) splitter.open_left(left);
  if (right) splitter.open_right(right);
  if (!left) splitter.lead_past(twin(splitter.between()), gap);
  if (!right) splitter.lead_past(splitter.between(), gap ? gap : splitter.beside_left());
  for (Halfedge h : {left, right})
    if (h) hold_outside(edit, mesh.to(h));
  edit.set_halfedge(vertex, splitter.between());
  hold_outside(edit, vertex);
  edit.set_halfedge(splitter.fresh(), twin(splitter.between()));
  hold_outside(edit, splitter.fresh());
  std::vector<Edge> parts;
  for (const Halfedge h : {left, right})
    if (h) parts.push_back(edge(h));
  for (const Element& e : splitter.effect().created)
    if (e.kind == Element::Kind::edge) parts.push_back(e.edge());
  share_among_sheets(edit, parts);
  OpEffect effect = splitter.effect();
  effect.changed.insert(effect.changed.begin(), sector.faces.begin(), sector.faces.end());
  return effect;
}

}  // namespace ryosen
