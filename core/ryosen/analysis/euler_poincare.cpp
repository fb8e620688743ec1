#include "ryosen/analysis/euler_poincare.h"

#include <string>

#include "ryosen/analysis/boundary_loops.h"
#include "ryosen/analysis/components.h"
#include "ryosen/analysis/problems.h"
#include "ryosen/base/interruption.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen {

namespace {

using Terms = EulerPoincare;
using Value = std::optional<std::int64_t>;

constexpr EulerTerm letters[] = {
    {'V', "vertices", "頂点", "Points of the mesh; a point at which separate sheets meet counts once.",
     "メッシュの点の数です。別々の面の集まりが出会う点も一つと数えます。",
     [](const Terms& t) -> Value { return t.vertices; }},
    {'E', "edges", "稜線", "Lines between two points, with any number of faces beside them.",
     "二点を結ぶ線の数です。両側の面の数は問いません。", [](const Terms& t) -> Value { return t.edges; }},
    {'F', "faces", "面", "Polygons of three or more corners.", "三つ以上の角をもつ多角形の数です。",
     [](const Terms& t) -> Value { return t.faces; }},
    {'B', "boundary loops", "境界ループ", "Closed walks along edges with a face on one side only: the rims of holes.",
     "片側だけに面がある稜線をたどって一周する輪、つまり穴の縁の数です。",
     [](const Terms& t) -> Value { return t.open_chain ? Value() : t.boundary_loops; }},
    {'W', "cycles along wires", "稜線だけの輪", "Closed walks outside the faces that go along edges without any face.",
     "面のない稜線を通って面の外を一周する輪の数です。", [](const Terms& t) -> Value { return t.wire_cycles; }, true},
    {'I', "isolated points", "稜線のない点", "Points that no edge and no face uses.",
     "どの稜線も面も使わない点の数です。", [](const Terms& t) -> Value { return t.isolated; }, true},
    {'H', "rings of faces", "面の穴", "Inner loops of faces: a face with a window in it has one ring.",
     "面の内側のループの数です。窓のあいた面には一つあります。", [](const Terms& t) -> Value { return t.rings; }},
    {'S', "connected parts", "つながった部分", "Parts that hang together by edges and faces, also called shells.",
     "稜線と面でつながった部分（シェル）の数です。", [](const Terms& t) -> Value { return t.parts; }},
    {'G', "handles", "種数", "Handles, the genus: 0 for a ball, 1 for a torus or a cup with an ear.",
     "取っ手の数（種数）です。球は 0、ドーナツは 1 です。", [](const Terms& t) -> Value { return t.genus; }},
};

Edge first_edge(const ProblemSets& sets, ProblemKind kind) { return Edge(sets.of(kind).nth(0)); }

void take_counts(EulerPoincare& terms, const Mesh& mesh, const ProblemSets& sets, std::size_t boundary_loops,
                 bool open_chain) {
  const ElementCounts counts = sets.counts_on_points(mesh);
  terms.vertices = counts.vertices;
  terms.edges = counts.edges;
  terms.faces = counts.faces;
  terms.rings = mesh.live().rings;
  terms.boundary_loops = static_cast<std::int64_t>(boundary_loops);
  terms.open_chain = open_chain;
  terms.isolated = sets.points_without_edge();
}

// Where the mesh is no manifold, if the sets of problems say so.
void find_nonmanifold(EulerPoincare& terms, const ProblemSets& sets) {
  if (sets.count(ProblemKind::nonmanifold_edge) > 0) {
    terms.no_genus = NoGenus::nonmanifold_edge;
    terms.at = first_edge(sets, ProblemKind::nonmanifold_edge);
  } else if (sets.count(ProblemKind::nonmanifold_vertex) > 0) {
    terms.no_genus = NoGenus::nonmanifold_vertex;
    terms.at = Vertex(sets.of(ProblemKind::nonmanifold_vertex).nth(0));
  }
}

// The ends of wires, and whether the kernel's outside links are valid at each: the point is one vertex, and its outside
// halfedges belong to wires and to boundary edges on points.
class WireEnds {
 public:
  WireEnds(const Mesh& mesh, const ProblemSets& sets) : mesh_(mesh), sets_(sets) {
    if (sets.count(ProblemKind::wire) == 0) return;
    is_end_.assign(mesh.vertex_slots(), false);
    sets.of(ProblemKind::wire).for_each([&](std::uint32_t i) {
      for (const Halfedge h : {halfedge(Edge(i), 0), halfedge(Edge(i), 1)}) {
        const Vertex v = mesh_.from(h);
        if (!is_end_[v.index] && !amid_ && !has_gap(v)) amid_ = v;
        is_end_[v.index] = true;
      }
    });
  }
  bool contains(Vertex v) const { return !is_end_.empty() && is_end_[v.index]; }
  // The first end where they are not; none if there is no such end.
  Vertex amid_faces() const { return amid_; }

 private:
  bool has_gap(Vertex v) const {
    if (has_copies(mesh_, v)) return false;
    for (Halfedge h : outgoing(mesh_, v)) {
      const bool is_outside = mesh_.is_outside(h) || mesh_.is_outside(twin(h));
      if (is_outside && !sets_.of(ProblemKind::wire).contains(edge(h).index) &&
          !sets_.of(ProblemKind::boundary_loop).contains(edge(h).index))
        return false;
    }
    return true;
  }

  const Mesh& mesh_;
  const ProblemSets& sets_;
  std::vector<bool> is_end_;
  Vertex amid_;
};

void find_what_hinders(EulerPoincare& terms, Neighbourhood& around, const ProblemSets& sets, const WireEnds& wires) {
  find_nonmanifold(terms, sets);
  if (terms.no_genus != NoGenus::none) return;
  const bool is_misoriented = sets.count(ProblemKind::misoriented_edge) > 0;
  if (is_misoriented) {
    if (const Halfedge twist = find_twist(around)) {
      terms.no_genus = NoGenus::one_sided;
      terms.at = edge(twist);
    } else if (sets.count(ProblemKind::wire) > 0) {
      terms.no_genus = NoGenus::unturned;
      terms.at = first_edge(sets, ProblemKind::misoriented_edge);
    }
  } else if (wires.amid_faces()) {
    terms.no_genus = NoGenus::wire_at_copies;
    terms.at = wires.amid_faces();
  }
}

std::int64_t count_wire_cycles(const Mesh& mesh, const ProblemSets& sets, const BoundaryLoops& loops) {
  if (sets.count(ProblemKind::wire) == 0) return 0;
  std::int64_t count = 0;
  std::vector<bool> on_cycle(mesh.halfedge_slots(), false);
  sets.of(ProblemKind::wire).for_each([&](std::uint32_t i) {
    for (const Halfedge start : {halfedge(Edge(i), 0), halfedge(Edge(i), 1)}) {
      if (on_cycle[start.index]) continue;
      ++count;
      for (Halfedge h : loop(mesh, start)) on_cycle[h.index] = true;
    }
  });
  for (std::size_t i = 0; i < loops.size(); ++i)
    count -= std::any_of(loops[i].begin(), loops[i].end(), [&](Halfedge h) { return on_cycle[h.index]; });
  return count;
}

// A spanning forest of the points, which gives the parts, and one of the faces and outside walks over the other edges.
class TreeAndCotree {
 public:
  TreeAndCotree(Neighbourhood& around, const ProblemSets& sets)
      : mesh_(around.mesh()), around_(around), sets_(sets), points_(mesh_.vertex_slots()) {
    if (!mesh_.has_copies()) return;
    for (const Vertex v : live_vertices(mesh_)) points_.join(v.index, mesh_.next_copy(v).index);
  }

  // Only the forest of the points. A face connects its loops like an edge between them.
  void join_points() {
    for (const Edge e : live_edges(mesh_)) {
      stop_if_interrupted();
      join_ends(e);
    }
    for_each_ring([&](Halfedge outer, Halfedge ring) { join(outer, ring); });
  }

  // Both; returns the number of edges in neither. The mesh is manifold and orientable, wires follow the kernel's links.
  std::int64_t join_all(const WireEnds& wires) {
    others_.reset(std::size_t{mesh_.face_slots()} + mesh_.halfedge_slots());
    join_walks(wires);
    std::int64_t in_neither = 0;
    for (const Edge e : live_edges(mesh_)) {
      stop_if_interrupted();
      if (sets_.is_further_sheet(e) || join_ends(e)) continue;
      const auto [a, b] = sides(e);
      in_neither += !others_.join(a, b);
    }
    for_each_ring([&](Halfedge outer, Halfedge ring) { in_neither += !join(outer, ring); });
    return in_neither;
  }

  std::int64_t parts() const {
    return std::int64_t{points_.count()} - (std::int64_t{mesh_.vertex_slots()} - mesh_.live().vertices);
  }

 private:
  bool join(Halfedge a, Halfedge b) { return points_.join(mesh_.from(a).index, mesh_.from(b).index); }
  bool join_ends(Edge e) { return join(halfedge(e, 0), halfedge(e, 1)); }
  template <class Visit>
  void for_each_ring(Visit visit) {
    for (std::uint32_t i = 0; mesh_.has_rings() && i < mesh_.face_slots(); ++i)
      for (std::uint32_t r = mesh_.first_ring(Face(i)); r != no_index; r = mesh_.ring(r).next)
        visit(mesh_.halfedge(Face(i)), mesh_.ring(r).halfedge);
  }

  std::uint32_t walk(Halfedge outside) const { return mesh_.face_slots() + outside.index; }
  std::uint32_t side(Halfedge h) const { return mesh_.is_outside(h) ? walk(h) : mesh_.face(h).index; }
  // The faces or outside walks on the two sides of an edge on points.
  std::pair<std::uint32_t, std::uint32_t> sides(Edge e) {
    const Halfedge h = halfedge(e);
    if (around_.is_single_sheet(h)) return {side(h), side(twin(h))};
    around_.faces_at(h, faces_);
    if (faces_.size() == 2) return {faces_[0].index, faces_[1].index};
    return {faces_[0].index, walk(mesh_.is_outside(h) ? h : twin(h))};
  }

  // Joins outside halfedges that follow each other on points into walks.
  void join_walks(const WireEnds& wires) {
    sets_.of(ProblemKind::boundary_loop).for_each([&](std::uint32_t i) {
      stop_if_interrupted();
      const Halfedge h = halfedge(Edge(i)), outside = mesh_.is_outside(h) ? h : twin(h);
      for (const bool at_end : {true, false}) {
        const Vertex v = at_end ? mesh_.to(outside) : mesh_.from(outside);
        const Halfedge linked = at_end ? mesh_.next(outside) : mesh_.prev(outside);
        const BoundaryStep step{twin(outside), !at_end};
        others_.join(walk(outside), walk(wires.contains(v) ? linked : twin(around_.next_boundary(step).inside)));
      }
    });
    sets_.of(ProblemKind::wire).for_each([&](std::uint32_t i) {
      for (const Halfedge h : {halfedge(Edge(i), 0), halfedge(Edge(i), 1)}) others_.join(walk(h), walk(mesh_.next(h)));
    });
  }

  const Mesh& mesh_;
  Neighbourhood& around_;
  const ProblemSets& sets_;
  DisjointSets points_;
  DisjointSets others_;  // faces by slot, then outside halves
  std::vector<Face> faces_;
};

}  // namespace

std::span<const EulerTerm> euler_letters() { return letters; }

EulerPoincare euler_poincare(const Mesh& mesh, const ProblemSets& sets) {
  Neighbourhood around(mesh, Neighbourhood::Reach::whole);
  EulerPoincare terms;
  const BoundaryLoops loops = find_boundary_loops(around, sets.of(ProblemKind::boundary_loop));
  take_counts(terms, mesh, sets, loops.size(), loops.has_open_chain);
  terms.wire_cycles = count_wire_cycles(mesh, sets, loops);
  const WireEnds wires(mesh, sets);
  find_what_hinders(terms, around, sets, wires);
  TreeAndCotree trees(around, sets);
  if (terms.no_genus == NoGenus::none)
    terms.genus = trees.join_all(wires) / 2;
  else
    trees.join_points();
  terms.parts = trees.parts();
  return terms;
}

EulerPoincare euler_poincare(const Mesh& mesh) { return euler_poincare(mesh, ProblemSets(mesh)); }

bool follow_operator(EulerPoincare& terms, const Mesh& mesh, const ProblemSets& sets,
                     const BoundaryLoopCount& boundary_loops) {
  EulerPoincare now = terms;
  take_counts(now, mesh, sets, boundary_loops.count(), boundary_loops.has_open_chain());
  now.no_genus = NoGenus::none;
  find_nonmanifold(now, sets);
  // Other reasons may have changed their element; a sum that does not hold is computed again.
  if (now.no_genus != terms.no_genus || (now.no_genus == NoGenus::none && !now.holds())) return false;
  terms = now;
  return true;
}

Text why_no_genus(const Mesh& mesh, const EulerPoincare& terms) {
  if (terms.no_genus == NoGenus::none) return {};
  const std::string name = name_on_points(mesh, terms.at);
  switch (terms.no_genus) {
    case NoGenus::one_sided:
      return {"one-sided: a walk over " + name + " comes back turned over",
              "片側しかありません：" + name + " を通って一周すると裏返ります"};
    case NoGenus::unturned:
      return {"wires beside faces that disagree at " + name + ": orient them",
              "面のない稜線があり、" + name + " で面の向きが揃いません：orient で揃えます"};
    case NoGenus::wire_at_copies:
      return {"a wire ends amid the faces at " + name, "面のない稜線の端が面に囲まれた " + name + " にあります"};
    default:
      return {"not manifold at " + name, name + " で多様体ではありません"};
  }
}

Text why_no_value(const Mesh& mesh, const EulerPoincare& terms, const EulerTerm& term) {
  if (term.value(terms)) return {};
  return term.letter == 'B' ? no_loop_count : why_no_genus(mesh, terms);
}

}  // namespace ryosen
