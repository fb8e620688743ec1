#include "tests/support/core/random_edits.h"

#include <limits>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/all.h"
#include "tests/support/core/shapes.h"

namespace ryosen::test {

Mesh random_kernel_mesh(std::uint64_t seed) {
  const SeededMesh random = seeded_mesh(seed);
  return make_mesh(random.faces, random.points);
}

namespace {

// Takes out a face without rings whose corners are all inside and have no copies, so that a hole stays as reading would
// make it.
void make_hole(const Mesh& mesh, Edit& edit, Face f) {
  if (mesh.has_rings(f)) return;
  std::vector<Halfedge> sides;
  for (Halfedge h : halfedges_around(mesh, f)) {
    if (mesh.is_boundary(mesh.from(h)) || has_copies(mesh, mesh.from(h))) return;
    sides.push_back(h);
  }
  for (Halfedge h : sides) {
    edit.set_face(h, Face());
    edit.fresh(h);
    edit.set_halfedge(mesh.from(h), h);
  }
  edit.drop(f);
}

template <class Handle>
Handle pick_live(const Mesh& mesh, std::uint32_t slots, Dice& dice) {
  for (int attempt = 0; attempt < 50 && slots > 0; ++attempt) {
    const Handle h(static_cast<std::uint32_t>(dice.below(static_cast<int>(slots))));
    if (mesh.is_alive(h)) return h;
  }
  return Handle();
}

void move_somewhere(const Mesh& mesh, Edit& edit, Vertex v, Dice& dice) {
  glm::dvec3 place(dice.unit(), dice.unit(), dice.unit());
  if (dice.one_in(4)) place.y = std::numeric_limits<double>::infinity();
  const Halfedge h = mesh.halfedge(v);
  if (h && dice.one_in(2)) place = 0.5 * (mesh.position(mesh.to(h)) + mesh.position(mesh.from(mesh.prev(h))));
  move_point(edit, v, place);
}

bool try_operator(const AnyOp& op, const Mesh& mesh, Edit& edit) {
  if (!check(mesh, op).legal()) return false;
  ryosen::apply(edit, op);
  return true;
}

bool try_edge_operator(const Mesh& mesh, Edit& edit, Dice& dice) {
  const Edge e = pick_live<Edge>(mesh, mesh.edge_slots(), dice);
  if (!e) return false;
  const Halfedge h = halfedge(e, static_cast<unsigned>(dice.below(2)));
  switch (dice.below(3)) {
    case 0:
      return try_operator(SwapEdge{h, dice.one_in(2)}, mesh, edit);
    case 1:
      return try_operator(
          CollapseEdge{h, dice.one_in(2) ? CollapseEdge::Place::middle : CollapseEdge::Place::automatic, {}}, mesh,
          edit);
    default:
      return try_operator(SplitEdge{h, dice.one_in(2) ? 0.5 : dice.unit()}, mesh, edit);
  }
}

}  // namespace

bool edit_at_random(Mesh& mesh, Journal& journal, Dice& dice) {
  Edit edit(mesh, &journal);
  bool done = false;
  if (dice.one_in(12)) {
    done = try_operator(Orient{}, mesh, edit);  // replaces all columns, so it comes alone
  } else {
    for (int steps = 1 + dice.below(2); steps > 0; --steps) {
      const int what = dice.below(6);
      if (what == 0) {
        const Vertex v = pick_live<Vertex>(mesh, mesh.vertex_slots(), dice);
        if (v) move_somewhere(mesh, edit, v, dice);
        done |= static_cast<bool>(v);
      } else if (what == 1) {
        const Face f = pick_live<Face>(mesh, mesh.face_slots(), dice);
        if (f) make_hole(mesh, edit, f);
        done |= static_cast<bool>(f);
      } else {
        done |= try_edge_operator(mesh, edit, dice);
      }
    }
  }
  if (done) edit.commit();
  return done;
}

std::optional<std::size_t> random_step(Mesh& mesh, Journal& journal, Dice& dice, int sides,
                                       const std::function<bool(int thrown)>& edit) {
  const int thrown = dice.below(sides);
  if (thrown == 0 && journal.can_undo()) {
    journal.undo(mesh);
    return journal.position();
  }
  if (thrown == 1 && journal.can_redo()) {
    journal.redo(mesh);
    return journal.position() - 1;
  }
  return edit(thrown) ? std::optional(journal.size() - 1) : std::nullopt;
}

}  // namespace ryosen::test
