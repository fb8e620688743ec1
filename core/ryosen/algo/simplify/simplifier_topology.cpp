// How a simplifier goes on where handles and parts keep faces: it closes handles and joins parts, those first that cost
// least, and collapses further.
#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "ryosen/algo/simplify/simplifier.h"
#include "ryosen/geometry/trees/triangle_tree.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/mesh/rings.h"
#include "ryosen/ops/rules/united_values.h"

namespace ryosen {

namespace {

using Sides = std::array<Halfedge, 3>;

// A cycle of three edges that is no face. Cutting along it leaves its vertices to what is left of its sides and gives
// copies of them to what is right; a triangle fills either end.
struct Neck {
  double size;  // the radius of the circle in its triangle: so far what fills it is from the surface
  Sides sides;
};

// Two triangles of different parts whose sides run against each other: both go, and what is around one is joined to
// what is around the other.
struct Joint {
  double size;  // half of the largest distance between corners that become one
  Sides sides;  // of the triangle whose corners stay
  Sides against{};
  std::array<std::uint32_t, 2> parts{};
};

// The parts that were joined, by their numbers.
class JoinedParts {
 public:
  // Whether they were apart until now.
  bool join(const std::array<std::uint32_t, 2>& parts) {
    const std::uint32_t a = whole_of(parts[0]), b = whole_of(parts[1]);
    if (a != b) whole_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

 private:
  std::uint32_t whole_of(std::uint32_t part) const {
    for (auto found = whole_.find(part); found != whole_.end(); found = whole_.find(part)) part = found->second;
    return part;
  }

  std::unordered_map<std::uint32_t, std::uint32_t> whole_;
};

// The middle of a closed disk of triangles that nothing keeps in its place; hubs are none, so that nothing walks around
// them for each of their edges.
bool is_within_triangles(const CollapseSurface& surface, Vertex v) {
  const Mesh& mesh = surface.mesh();
  if (mesh.is_isolated(v) || mesh.is_boundary(v) || has_copies(mesh, v) || is_hub(mesh, v) || !surface.is_free(v))
    return false;
  for (const Halfedge h : outgoing(mesh, v))
    if (mesh.is_outside(h) || !is_triangle(mesh, h) || mesh.has_rings(mesh.face(h))) return false;
  return count_fans(mesh, v) == 1;
}

std::vector<std::uint8_t> find_within_triangles(const CollapseSurface& surface) {
  std::vector<std::uint8_t> is_within(surface.mesh().vertex_slots());
  for (const Vertex v : live_vertices(surface.mesh())) is_within[v.index] = is_within_triangles(surface, v);
  return is_within;
}

double radius_within(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const double around = glm::length(b - a) + glm::length(c - b) + glm::length(a - c);
  return around > 0 ? glm::length(glm::cross(b - a, c - a)) / around : 0;
}

// The smallest first. Cost: the sum of the valences over all edges.
std::vector<Neck> find_necks(const CollapseSurface& surface, double largest) {
  const Mesh& mesh = surface.mesh();
  const std::vector<std::uint8_t> is_within = find_within_triangles(surface);
  std::vector<Halfedge> to_first(mesh.vertex_slots());  // by vertex: to the first corner of the cycles
  std::vector<Neck> necks;
  for (const Vertex a : live_vertices(mesh)) {
    if (!is_within[a.index]) continue;
    for (const Halfedge h : outgoing(mesh, a)) to_first[mesh.to(h).index] = twin(h);
    for (const Halfedge ab : outgoing(mesh, a)) {
      const Vertex b = mesh.to(ab);
      if (b < a || !is_within[b.index]) continue;
      for (const Halfedge bc : outgoing(mesh, b)) {
        const Vertex c = mesh.to(bc);
        const Halfedge ca = to_first[c.index];
        if (c < b || !ca || !is_within[c.index]) continue;
        if (mesh.to(mesh.next(ab)) == c || mesh.to(mesh.next(twin(ab))) == c) continue;  // a face
        const double size = radius_within(surface.place(a), surface.place(b), surface.place(c));
        if (size > 0 && size <= largest) necks.push_back({size, {ab, bc, ca}});
      }
    }
    for (const Halfedge h : outgoing(mesh, a)) to_first[mesh.to(h).index] = Halfedge();
  }
  std::stable_sort(necks.begin(), necks.end(), [](const Neck& a, const Neck& b) { return a.size < b.size; });
  return necks;
}

// Whether the surface leads around from one side of a cycle to its other one, so that it goes around a handle. Cost:
// the smaller side, or the way around.
bool leads_around(const Mesh& mesh, const Sides& sides) {
  std::unordered_map<Face, bool> is_left;
  std::array<std::vector<Face>, 2> reached;
  for (const Halfedge side : sides)
    for (const bool left : {false, true})
      if (const Face f = mesh.face(left ? side : twin(side)); is_left.try_emplace(f, left).second)
        reached[left].push_back(f);
  std::array<std::size_t, 2> next{};
  while (true)
    for (const bool left : {false, true}) {
      if (next[left] == reached[left].size()) return false;
      const Face from = reached[left][next[left]++];
      for (const Halfedge h : halfedges_around(mesh, from)) {
        if (std::find_if(sides.begin(), sides.end(), [&](Halfedge s) { return edge(s) == edge(h); }) != sides.end())
          continue;
        const Face f = mesh.face(twin(h));
        if (!f) continue;
        const auto [known, is_new] = is_left.try_emplace(f, left);
        if (!is_new && known->second != left) return true;
        if (is_new) reached[left].push_back(f);
      }
    }
}

// Puts `stays` in the place of `goes` along its face, to which the values at its corner go.
void take_place(Edit& edit, Halfedge stays, Halfedge goes) {
  const HalfedgeLinks at = edit.mesh().links(goes);
  edit.connect(at.prev, stays);
  edit.connect(stays, at.next);
  edit.set_face(stays, at.face);
  if (edit.mesh().halfedge(at.face) == goes) edit.set_halfedge(at.face, stays);
}

void fill_triangle(Edit& edit, const Sides& sides, Face like) {
  const Face f = edit.add_face(sides[0]);
  edit.derive(f, like, Derivation::copies);
  for (const std::size_t i : {0u, 1u, 2u}) {
    edit.connect(sides[i], sides[(i + 1) % 3]);
    edit.set_face(sides[i], f);
    edit.fresh(sides[i]);
  }
}

// The corners of the part on the right, in the order of the sides.
std::array<Vertex, 3> cut_along(Edit& edit, const Sides& sides) {
  const Mesh& m = edit.mesh();
  std::array<std::vector<Halfedge>, 3> right;  // by corner the halfedges that leave it on the right
  for (const std::size_t i : {0u, 1u, 2u})
    for (Halfedge h = m.counter_clockwise(twin(sides[(i + 2) % 3])); h != sides[i]; h = m.counter_clockwise(h))
      right[i].push_back(h);
  std::array<Vertex, 3> copies;
  for (const std::size_t i : {0u, 1u, 2u}) {
    const Vertex v = m.from(sides[i]);
    copies[i] = edit.add_vertex(m.position(v));
    edit.derive(copies[i], v, Derivation::copies);
    for (const Halfedge h : right[i]) edit.set_from(h, copies[i]);
    edit.set_halfedge(v, sides[i]);
  }
  const Face left_face = m.face(sides[0]), right_face = m.face(twin(sides[0]));
  Sides made;
  for (const std::size_t i : {0u, 1u, 2u}) {
    made[i] = edit.add_edge(copies[i], copies[(i + 1) % 3]);
    edit.derive(edge(made[i]), edge(sides[i]), Derivation::copies);
    take_place(edit, twin(made[i]), twin(sides[i]));
    const std::pair<Halfedge, Halfedge> corner{twin(made[i]), twin(sides[i])};
    edit.move_corners({&corner, 1});
    edit.set_halfedge(copies[i], made[i]);
  }
  fill_triangle(edit, made, right_face);
  fill_triangle(edit, {twin(sides[0]), twin(sides[2]), twin(sides[1])}, left_face);
  return copies;
}

// The components, by vertex.
std::vector<std::uint32_t> label_parts(const Mesh& mesh, std::uint32_t& count) {
  std::vector<std::uint32_t> part(mesh.vertex_slots(), no_index);
  std::vector<Vertex> reached;
  for (const Vertex first : live_vertices(mesh)) {
    if (mesh.is_isolated(first) || part[first.index] != no_index) continue;
    part[first.index] = count;
    reached.assign(1, first);
    for (std::size_t i = 0; i < reached.size(); ++i)
      for (const Halfedge h : outgoing(mesh, reached[i]))
        if (const Vertex v = mesh.to(h); std::exchange(part[v.index], count) == no_index) reached.push_back(v);
    ++count;
  }
  return part;
}

Sides sides_from(const Mesh& mesh, Halfedge h) { return {h, mesh.next(h), mesh.prev(h)}; }

// The way to lay a triangle against another one that brings corners together which are near each other.
Joint nearest_joint(const CollapseSurface& surface, Face stays, Face goes) {
  const Mesh& mesh = surface.mesh();
  const Sides sides = sides_from(mesh, mesh.halfedge(stays));
  std::optional<Joint> nearest;
  for (const Halfedge first : sides_from(mesh, mesh.halfedge(goes))) {
    const Sides around = sides_from(mesh, first);
    const Sides against{around[0], around[2], around[1]};
    double size = 0;
    for (const std::size_t i : {0u, 1u, 2u})
      size = std::max(size, 0.5 * glm::length(surface.place(mesh.from(sides[i])) - surface.place(mesh.to(against[i]))));
    if (!nearest || size < nearest->size) nearest = Joint{size, sides, against};
  }
  return *nearest;
}

// Where the corners of two triangles come that become one.
std::array<glm::dvec3, 3> middles_between(const Mesh& mesh, const Sides& sides, const Sides& against) {
  std::array<glm::dvec3, 3> middles;
  for (const std::size_t i : {0u, 1u, 2u})
    middles[i] = 0.5 * mesh.position(mesh.from(sides[i])) + 0.5 * mesh.position(mesh.to(against[i]));
  return middles;
}

// Of each part but the largest one the nearest joint to another one; the nearest first. O(n log n).
std::vector<Joint> find_joints(const CollapseSurface& surface, double largest) {
  const Mesh& mesh = surface.mesh();
  std::uint32_t count = 0;
  const std::vector<std::uint32_t> part = label_parts(mesh, count);
  if (count < 2) return {};
  const std::vector<std::uint8_t> is_within = find_within_triangles(surface);
  std::vector<glm::dvec3> places(mesh.vertex_slots());
  for (const Vertex v : live_vertices(mesh)) places[v.index] = surface.place(v);
  std::vector<Primitive> triangles;
  std::vector<std::size_t> sizes(count);
  for (const Face f : live_faces(mesh)) {
    const Sides sides = sides_from(mesh, mesh.halfedge(f));
    const auto corner = [&](std::size_t i) { return mesh.from(sides[i]).index; };
    if (!is_within[corner(0)] || !is_within[corner(1)] || !is_within[corner(2)]) continue;
    triangles.push_back(Primitive::triangle(corner(0), corner(1), corner(2), f.index));
    ++sizes[part[corner(0)]];
  }
  if (triangles.empty()) return {};
  const auto largest_part = static_cast<std::uint32_t>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  const TriangleTree tree(places, triangles, 1);
  std::vector<std::optional<Joint>> nearest(count);
  for (const Primitive& triangle : triangles) {
    const std::uint32_t own = part[triangle.vertices[0]];
    if (own == largest_part) continue;
    const glm::dvec3 middle =
        (places[triangle.vertices[0]] + places[triangle.vertices[1]] + places[triangle.vertices[2]]) / 3.0;
    const auto is_of_another = [&](std::uint32_t t) {
      return part[mesh.from(mesh.halfedge(Face(tree.owner(t)))).index] != own;
    };
    const TriangleTree::Near near = tree.nearest_of(middle, is_of_another);
    if (near.triangle == no_index) continue;
    Joint joint = nearest_joint(surface, Face(tree.owner(near.triangle)), Face(triangle.owner));
    joint.parts = {part[mesh.from(joint.sides[0]).index], own};
    if (joint.size <= largest && (!nearest[own] || joint.size < nearest[own]->size)) nearest[own] = joint;
  }
  std::vector<Joint> joints;
  for (const std::optional<Joint>& joint : nearest)
    if (joint) joints.push_back(*joint);
  std::stable_sort(joints.begin(), joints.end(), [](const Joint& a, const Joint& b) { return a.size < b.size; });
  return joints;
}

}  // namespace

// Until the goal is reached or nothing more can be closed, joined or collapsed; false where it was cancelled.
bool Simplifier::change_topology(Progress& progress) {
  merged_into_.clear();  // what fills a cut comes from no face of the input
  while (!is_at_goal() && progress.go_on() && (close_handles() || join_parts())) {
    known_ = LocalFacts();
    hub_pairs_.clear();
    minds_ = CollapseSurface::Minds::input;
    if (find_further(progress) && !collapse_all(progress)) return false;
  }
  return progress.go_on();
}

// So many at once as may be needed, of about the same size: each takes away a few faces, some of them when it is
// collapsed.
std::size_t Simplifier::most_changes() const { return 1 + (mesh_.live().faces - goal_.faces) / 8; }

bool Simplifier::close_handles() {
  const std::size_t most = closed_handles_ + most_changes();
  std::vector<std::uint8_t> is_changed(mesh_.vertex_slots());
  double largest = surface_.error_limit();
  const std::size_t before = closed_handles_;
  for (const auto& [size, sides] : find_necks(surface_, largest)) {
    if (size > largest || closed_handles_ == most) break;
    if (std::any_of(sides.begin(), sides.end(), [&](Halfedge h) { return is_changed[mesh_.from(h).index]; }) ||
        !leads_around(mesh_, sides))
      continue;
    if (distance_guard_ && distance_guard_->filling_may_exceed(sides)) continue;
    if (closed_handles_ == before) largest = std::min(largest, 2 * size);
    error_max_ = std::max(error_max_, size);
    for (const Halfedge h : sides) is_changed[mesh_.from(h).index] = 1;
    const std::array<Vertex, 3> copies = cut_along(*edit_, sides);
    for (const std::size_t i : {0u, 1u, 2u}) surface_.add_copy(copies[i], mesh_.from(sides[i]));
    if (distance_guard_)
      distance_guard_->follow_filling({mesh_.face(twin(sides[0])), mesh_.face(mesh_.halfedge(copies[0]))});
    is_changed.resize(mesh_.vertex_slots(), 1);
    ++closed_handles_;
  }
  is_blocked_.resize(mesh_.edge_slots());
  has_blocked_.resize(mesh_.vertex_slots());
  surface_.add_edges();
  return closed_handles_ > before;
}

bool Simplifier::join_parts() {
  const std::size_t before = joined_parts_, most = joined_parts_ + most_changes();
  has_parts_too_far_ = false;
  JoinedParts joined;
  std::vector<std::uint8_t> is_changed(mesh_.vertex_slots());
  const auto is_gone = [&](Halfedge h) { return !mesh_.is_alive(h) || is_changed[mesh_.from(h).index]; };
  for (const Joint& joint : find_joints(surface_, surface_.error_limit())) {
    if (is_at_goal() || joined_parts_ == most) break;
    has_parts_too_far_ = jump_ && joint.size > jump_->limit();
    if (has_parts_too_far_) break;
    if (std::any_of(joint.sides.begin(), joint.sides.end(), is_gone) ||
        std::any_of(joint.against.begin(), joint.against.end(), is_gone) ||
        may_exceed_distance(joint.sides, joint.against) || !joined.join(joint.parts))
      continue;
    if (distance_guard_) distance_guard_->follow();
    error_max_ = std::max(error_max_, joint.size);
    join(joint.sides, joint.against);
    for (const Halfedge h : joint.sides) is_changed[mesh_.from(h).index] = 1;
    ++joined_parts_;
  }
  return joined_parts_ > before;
}

bool Simplifier::may_exceed_distance(const Sides& sides, const Sides& against) const {
  return distance_guard_ && distance_guard_->joining_may_exceed(sides, against, middles_between(mesh_, sides, against));
}

// against[i] ends where sides[i] begins, and both become one edge.
void Simplifier::join(const std::array<Halfedge, 3>& sides, const std::array<Halfedge, 3>& against) {
  const std::array<Face, 2> gone{mesh_.face(sides[0]), mesh_.face(against[0])};
  const std::array<glm::dvec3, 3> middles = middles_between(mesh_, sides, against);
  std::array<Vertex, 3> kept, going;
  for (const std::size_t i : {0u, 1u, 2u}) {
    kept[i] = mesh_.from(sides[i]);
    going[i] = mesh_.to(against[i]);
  }
  for (const std::size_t i : {0u, 1u, 2u}) {
    unite_ends(*edit_, going[i], kept[i], 0.5);
    std::vector<Halfedge> leaving;
    for (const Halfedge h : outgoing(mesh_, going[i])) leaving.push_back(h);
    for (const Halfedge h : leaving)
      if (mesh_.face(h) != gone[1]) edit_->set_from(h, kept[i]);
  }
  for (const std::size_t i : {0u, 1u, 2u}) {
    edit_->derive(sides[i], twin(against[i]), Derivation::copies);
    take_place(*edit_, sides[i], twin(against[i]));
    edit_->derive(edge(sides[i]), edge(sides[i]), edge(against[i]), 0.5, Derivation::unites);
    edit_->remove(edge(against[i]));
    edit_->set_halfedge(kept[i], sides[i]);
  }
  for (const Face f : gone) edit_->drop(f);
  for (const std::size_t i : {0u, 1u, 2u}) {
    edit_->set_position(kept[i], middles[i]);
    edit_->remove(going[i]);
    surface_.merge(going[i], kept[i], middles[i]);
  }
}

}  // namespace ryosen
