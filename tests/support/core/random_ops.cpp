#include "tests/support/core/random_ops.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/invariants.h"
#include "ryosen/ops/rules/surgery.h"
#include "tests/support/core/kernel_lists.h"
#include "tests/support/core/oracle/complex.h"

namespace ryosen::test {
namespace {

constexpr std::uint32_t most_tries = 200;

template <class Handle>
Handle random_live(const Mesh& mesh, std::uint32_t slots, Dice& dice) {
  for (std::uint32_t i = 0; slots > 0 && i < most_tries; ++i) {
    const Handle e(static_cast<std::uint32_t>(dice.below(static_cast<int>(slots))));
    if (mesh.is_alive(e)) return e;
  }
  for (std::uint32_t i = 0; i < slots; ++i)
    if (mesh.is_alive(Handle(i))) return Handle(i);
  return Handle();
}

template <class Range>
auto pick(const Range& range, Dice& dice) {
  std::vector<std::decay_t<decltype(*range.begin())>> all;
  for (auto element : range) all.push_back(element);
  return all[static_cast<std::size_t>(dice.below(static_cast<int>(all.size())))];
}

glm::dvec3 random_place(Dice& dice) { return {dice.unit(), dice.unit(), dice.unit()}; }

Halfedge random_gap(const Mesh& mesh, Vertex v, Dice& dice) {
  if (mesh.is_isolated(v)) return Halfedge();
  const std::vector<Halfedge> gaps = gaps_at(mesh, v);
  return gaps.empty() ? pick(outgoing(mesh, v), dice) : pick(gaps, dice);
}

// Often on the cycle of v, else anywhere.
Vertex partner(const Mesh& mesh, Vertex v, Dice& dice) {
  if (mesh.is_isolated(v) || dice.one_in(2)) return random_vertex(mesh, dice);
  return mesh.from(pick(loop(mesh, mesh.halfedge(v)), dice));
}

AnyOp random_make_edge(const Mesh& mesh, Vertex a, Dice& dice) {
  const Vertex b = partner(mesh, a, dice);
  return MakeEdge{a, b, random_gap(mesh, a, dice), random_gap(mesh, b, dice)};
}

AnyOp random_make_face(const Mesh& mesh, Vertex v, Dice& dice) {
  MakeFace op;
  const int n = 3 + dice.below(2);
  Halfedge h = mesh.halfedge(v);
  for (int i = 0; i < n; ++i) {
    if (h && !dice.one_in(6)) {
      op.corners.push_back(mesh.from(h));
      h = dice.one_in(3) ? mesh.next(mesh.counter_clockwise(h)) : mesh.next(h);
    } else {
      op.corners.push_back(random_vertex(mesh, dice));
    }
  }
  return op;
}

AnyOp random_weld(const Mesh& mesh, Vertex v, Dice& dice) {
  if (dice.one_in(3)) return Weld{{}, {}, random_halfedge(mesh, dice), random_halfedge(mesh, dice)};
  if (has_copies(mesh, v) && dice.one_in(2)) return Weld{v, mesh.next_copy(v), {}, {}};
  const auto place = v.index % 3 == 0 ? Weld::Place::middle : Weld::Place::first;
  return Weld{v, partner(mesh, v, dice), {}, {}, place};
}

AnyOp random_split(const Mesh& mesh, Vertex v, Dice& dice) {
  const auto end = [&] { return dice.one_in(4) ? Halfedge() : pick(outgoing(mesh, v), dice); };
  return VertexSplit{v, end(), end()};
}

AnyOp random_collapse(Halfedge h, Dice& dice) {
  const CollapseEdge::Place places[] = {CollapseEdge::Place::automatic, CollapseEdge::Place::start,
                                        CollapseEdge::Place::end, CollapseEdge::Place::middle};
  return CollapseEdge{h, places[dice.below(4)]};
}

AnyOp random_delete(const Mesh& mesh, Vertex v, Halfedge h, Dice& dice) {
  const int kind = dice.below(3);
  if (kind == 0 && h) return Delete{edge(h)};
  const Face f = random_face(mesh, dice);
  if (kind == 1 && f) return Delete{f};
  return Delete{v};
}

// Half of the time several faces, most of them at common points.
AnyOp random_extrude(const Mesh& mesh, Face f, Dice& dice) {
  Extrude op{{f}};
  if (dice.one_in(2)) return op;
  const int more = 1 + dice.below(4);
  for (int i = 0; i < more; ++i) {
    const Vertex v = pick(vertices_around(mesh, op.faces.back()), dice), copy = mesh.next_copy(v);
    const Face near = mesh.face(pick(outgoing(mesh, mesh.is_isolated(copy) ? v : copy), dice));
    op.faces.push_back(near && !dice.one_in(4) ? near : random_face(mesh, dice));
  }
  return op;
}

// Half of the time several edges, most of them at common points.
AnyOp random_extrude_edges(const Mesh& mesh, Halfedge h, Dice& dice) {
  ExtrudeEdges op{{h}};
  if (dice.one_in(2)) return op;
  const int more = 1 + dice.below(4);
  for (int i = 0; i < more; ++i) {
    const Halfedge last = op.edges.back(), near = pick(outgoing(mesh, mesh.from(last)), dice);
    op.edges.push_back(dice.one_in(3) ? mesh.next(last) : dice.one_in(3) ? random_halfedge(mesh, dice) : near);
  }
  return op;
}

// Whether reading the points gives the mesh, and no wire lies beside another edge.
bool reads_back(const Mesh& mesh) {
  const oracle::ComplexFacts facts = oracle::facts_of(complex_of(mesh));
  return facts.reads_back && facts.loops_on_points && facts.doubled_wires.empty();
}

Halfedge new_halfedge(const Mesh& mesh) { return halfedge(Edge(mesh.edge_slots() - 1)); }

bool link(Mesh& mesh, Journal& journal, Vertex a, Halfedge into_a, Vertex b, Halfedge into_b) {
  return try_apply(mesh, &journal, MakeEdge{a, b, into_a, into_b});
}

// A ring of three or four new vertices in a face, hung up by a bridge; then perhaps a face in it, and no bridge.
bool make_hole(Mesh& mesh, Journal& journal, Dice& dice) {
  const Face f = random_face(mesh, dice);
  if (!f) return false;
  const Halfedge at = pick(halfedges_around(mesh, f), dice);
  if (mesh.has_rings(f) || !try_apply(mesh, &journal, DeleteLoop{f})) return false;
  const int n = 3 + dice.below(2);
  std::vector<Vertex> ring;
  for (int i = 0; i < n; ++i) {
    if (!try_apply(mesh, &journal, MakeVertex{random_place(dice)})) return false;
    ring.push_back(Vertex(mesh.vertex_slots() - 1));
  }
  const Vertex corner = mesh.to(at);
  if (!link(mesh, journal, corner, at, ring[0], Halfedge())) return false;
  const Halfedge bridge = new_halfedge(mesh);
  const Halfedge there = mesh.from(bridge) == corner ? bridge : twin(bridge);
  Halfedge into = there;
  for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
    if (!link(mesh, journal, ring[i], into, ring[i + 1], Halfedge())) return false;
    into = mesh.to(new_halfedge(mesh)) == ring[i + 1] ? new_halfedge(mesh) : twin(new_halfedge(mesh));
  }
  if (!link(mesh, journal, ring.back(), into, ring[0], there)) return false;
  const Halfedge last = new_halfedge(mesh);
  if (!try_apply(mesh, &journal, MakeLoop{at})) return false;
  if (dice.one_in(2)) try_apply(mesh, &journal, MakeLoop{mesh.is_outside(last) ? last : twin(last)});
  return dice.one_in(3) || try_apply(mesh, &journal, MakeRing{bridge});
}

// Two faces become one that leads from the border of the one to that of the other.
bool make_tunnel(Mesh& mesh, Journal& journal, Dice& dice) {
  const Face f = random_face(mesh, dice), g = random_face(mesh, dice);
  if (!f || f == g) return false;
  const Halfedge at = mesh.halfedge(f), other = mesh.halfedge(g);
  if (!try_apply(mesh, &journal, DeleteLoop{f}) || !try_apply(mesh, &journal, DeleteLoop{g})) return false;
  if (!link(mesh, journal, mesh.to(at), at, mesh.to(other), other)) return false;
  const Halfedge bridge = new_halfedge(mesh);
  return try_apply(mesh, &journal, MakeLoop{at}) && (dice.one_in(3) || try_apply(mesh, &journal, MakeRing{bridge}));
}

Mesh base_mesh(std::uint64_t seed, Dice& dice) {
  const int kind = dice.below(5);
  if (kind == 0) {
    Mesh mesh;
    for (int i = 0; i < 6; ++i) try_apply(mesh, nullptr, MakeVertex{random_place(dice)});
    return mesh;
  }
  RandomMesh random = kind < 3 ? random_mesh(seed) : random_manifold(seed, 5 + dice.below(8));
  return kernel_mesh(oracle::polygon_list(random.points, std::move(random.faces)), seed);
}

}  // namespace

Vertex random_vertex(const Mesh& mesh, Dice& dice) { return random_live<Vertex>(mesh, mesh.vertex_slots(), dice); }
Halfedge random_halfedge(const Mesh& mesh, Dice& dice) {
  return random_live<Halfedge>(mesh, mesh.live().edges == 0 ? 0 : mesh.halfedge_slots(), dice);
}
Face random_face(const Mesh& mesh, Dice& dice) { return random_live<Face>(mesh, mesh.face_slots(), dice); }

AnyOp random_op(const Mesh& mesh, std::size_t place, Dice& dice) {
  const std::string_view id = all_ops()[place].id;
  const Vertex v = random_vertex(mesh, dice);
  const Halfedge h = random_halfedge(mesh, dice);
  const Face f = random_face(mesh, dice);
  if (!v || id == "make_vertex") return MakeVertex{random_place(dice)};
  if (id == "remove_vertex") return RemoveVertex{v};
  if (id == "move_vertex") {
    const Vertex onto = random_vertex(mesh, dice);
    return MoveVertex{v, dice.one_in(4) ? mesh.position(onto) : random_place(dice)};
  }
  if (id == "make_edge") return random_make_edge(mesh, v, dice);
  if (id == "unite_edge") return UniteEdge{v};
  if (id == "separate_fans") return SeparateFans{v};
  if (id == "delete") return random_delete(mesh, v, h, dice);
  if (id == "make_face") return random_make_face(mesh, v, dice);
  if (!h) return MakeVertex{random_place(dice)};
  const Halfedge free = mesh.is_outside(h) ? h : twin(h);
  if (id == "collapse") return random_collapse(h, dice);
  if (id == "swap") return SwapEdge{h, dice.one_in(2)};
  if (id == "split") {
    const int t = dice.below(6);
    return t < 5 ? SplitEdge{h, 0.25 * t} : SplitEdge{h, 0.5, random_place(dice)};
  }
  if (id == "orient") return Orient{};
  if (id == "delete_edge") return DeleteEdge{h};
  if (id == "make_loop") return MakeLoop{free};
  if (id == "fill") return Fill{free};
  if (id == "separate_edge") return SeparateEdge{h, 0.5};
  if (id == "unite_loop") return UniteLoop{h};
  if (id == "make_ring") return MakeRing{h};
  if (id == "extrude_edges") return random_extrude_edges(mesh, h, dice);
  if (id == "weld") return random_weld(mesh, v, dice);
  if (id == "vertex_split") return mesh.is_isolated(v) ? AnyOp(VertexSplit{v, h, {}}) : random_split(mesh, v, dice);
  if (id == "dissolve") return dice.one_in(2) ? Dissolve{h} : Dissolve{{}, v};
  if (!f) return MakeVertex{random_place(dice)};
  if (id == "delete_loop") return DeleteLoop{f};
  if (id == "poke") return Poke{f};
  if (id == "extrude") return random_extrude(mesh, f, dice);
  if (id == "triangulate") return Triangulate{dice.one_in(20) ? Face() : f};
  if (id == "reverse") return dice.one_in(2) ? Reverse{{f}} : Reverse{{f, random_face(mesh, dice)}};
  if (id == "detach") return dice.one_in(2) ? Detach{{f}} : Detach{{f, random_face(mesh, dice)}};
  const Face other = dice.one_in(8) ? random_face(mesh, dice) : f;
  const Halfedge a = pick(halfedges_around(mesh, f), dice), b = pick(halfedges_around(mesh, other), dice);
  if (id == "separate_loop") return SeparateLoop{a, b};
  if (id == "unite_ring") return UniteRing{a, b};
  if (id == "make_vertex") return MakeVertex{random_place(dice)};
  throw std::logic_error("random_op has no arguments for " + std::string(id));
}

AnyOp random_op(const Mesh& mesh, Dice& dice) {
  return random_op(mesh, static_cast<std::size_t>(dice.below(static_cast<int>(all_ops().size()))), dice);
}

bool try_apply(Mesh& mesh, Journal* journal, const AnyOp& op) {
  if (!check(mesh, op).legal()) return false;
  Edit edit(mesh, journal);
  apply(edit, op);
  edit.commit();
  return true;
}

Mesh random_complex(std::uint64_t seed) {
  Dice dice(seed * 7919 + 17);
  Mesh mesh = base_mesh(seed, dice);
  const int steps = 3 + dice.below(12);
  for (int i = 0; i < steps; ++i) {
    Mesh next = mesh;
    Journal journal;
    const int kind = dice.below(5);
    std::string line = kind == 0 ? "hole" : "tunnel";
    bool done = false;
    if (kind == 0) done = make_hole(next, journal, dice);
    if (kind == 1) done = make_tunnel(next, journal, dice);
    if (kind > 1) {
      const AnyOp op = random_op(next, dice);
      if (check(next, op).legal()) line = command_of(next, op);
      done = try_apply(next, &journal, op);
    }
    const auto broken = check_invariants(next);
    EXPECT_FALSE(broken) << "seed " << seed << ", " << line << ": " << broken->sentence << "\n"
                         << to_text(complex_of(mesh));
    if (broken) return mesh;
    if (done && next.live().edges <= 45 && reads_back(next)) mesh = std::move(next);
  }
  return mesh;
}

}  // namespace ryosen::test
