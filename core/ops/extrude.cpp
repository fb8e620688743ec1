#include "core/ops/extrude.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/geometry/is_finite.h"
#include "core/geometry/polygon_normal.h"
#include "core/mesh/attribute.h"
#include "core/mesh/face_polygon.h"
#include "core/ops/lines/arguments.h"
#include "core/ops/rules/corner_values.h"
#include "core/ops/rules/face_geometry.h"
#include "core/ops/rules/face_lists.h"
#include "core/ops/rules/surgery.h"

namespace ryosen {

namespace {

// One non-bridge side of the face and the wall above it.
//
//      from' ---top---> to'
//        |               |
//       rise            rise of the next side
//        |               |
//      from ---side---> to
struct Wall {
  Halfedge side;
  Halfedge top;   // from' -> to', a side of the face; its twin belongs to the wall
  Halfedge rise;  // from -> from'
  Vertex from;
};

// The walls of a face, by start vertex.
class Walls {
 public:
  explicit Walls(std::vector<Wall> walls) : walls_(std::move(walls)), by_vertex_(walls_) {
    std::sort(by_vertex_.begin(), by_vertex_.end(), [](const Wall& a, const Wall& b) { return a.from < b.from; });
  }
  const std::vector<Wall>& in_order() const { return walls_; }
  const Wall& at(Vertex v) const {
    return *std::lower_bound(by_vertex_.begin(), by_vertex_.end(), v,
                             [](const Wall& wall, Vertex key) { return wall.from < key; });
  }

 private:
  std::vector<Wall> walls_, by_vertex_;
};

// Makes the new vertices, the edges up to them and the sides of the moved face.
Walls raise(Edit& edit, Face f, const glm::dvec3& by, OpEffect& effect) {
  const Mesh& m = edit.mesh();
  std::vector<Wall> walls;
  for (Halfedge h : halfedges_around(m, f))
    if (!is_bridge(m, h)) walls.push_back({h, Halfedge(), Halfedge(), m.from(h)});
  for (Wall& wall : walls) {
    const glm::dvec3 base = m.position(wall.from), moved = base + by;
    const Vertex top = edit.add_vertex(is_finite(moved) ? moved : base);
    blend_vertex_values(edit, wall.from, wall.from, 0, top);
    wall.rise = edit.add_edge(wall.from, top);
    effect.created.insert(effect.created.end(), {top, edge(wall.rise)});
  }
  Walls raised(std::move(walls));
  std::vector<Wall> with_tops = raised.in_order();
  for (Wall& wall : with_tops) {
    wall.top = edit.add_edge(m.to(wall.rise), m.to(raised.at(m.to(wall.side)).rise));
    effect.created.push_back(edge(wall.top));
  }
  return Walls(std::move(with_tops));
}

// The corner values of the walls: texture coordinates are copied upwards; normals are not set, they belong to the old
// surface.
void set_wall_values(Edit& edit, const Walls& walls) {
  CornerWriter corners(edit);
  const std::vector<CornerAttribute> attributes = corner_attributes(edit.mesh());
  for (std::size_t k = 0; k < corners.count(); ++k) {
    const bool is_normal =
        edit.mesh().attributes()[attributes[k].index_column].name == std::string(attribute_names::normal);
    std::vector<std::uint32_t> values;
    for (const Wall& wall : walls.in_order()) {
      values.push_back(corners.index(k, wall.side));
      corners.set(k, wall.top, values.back());
    }
    for (const Wall& wall : walls.in_order()) {
      const Wall& after = walls.at(edit.mesh().to(wall.side));
      const std::uint32_t here = is_normal ? no_index : corners.index(k, wall.top);
      const std::uint32_t there = is_normal ? no_index : corners.index(k, after.top);
      corners.set(k, wall.side, here);
      corners.set(k, twin(wall.rise), here);
      corners.set(k, twin(wall.top), there);
      corners.set(k, after.rise, there);
    }
  }
}

}  // namespace

Parsed<Extrude> Extrude::parse(const Mesh& mesh, std::span<const std::string_view> arguments) {
  ArgumentReader in(mesh, arguments, info.syntax);
  Extrude op{in.face()};
  const std::string argument(in.peek());
  if (!in.at_end()) {
    if (argument.find(',') != std::string::npos)
      op.offset = in.place();
    else
      op.distance = in.number();
  }
  Parsed<Extrude> out = in.result(op);
  if (!out.op || argument.empty()) return out;
  const glm::dvec3 by = op.movement(mesh);
  for (Vertex v : vertices_around(mesh, op.face))
    if (is_finite(mesh.position(v)) && !is_finite(mesh.position(v) + by))
      return malformed_argument<Extrude>(
          argument, {"a movement that leaves the face at a finite place", "面の座標が有限になる移動量を"});
  return out;
}

std::string Extrude::command(const Mesh& mesh) const {
  std::string text = "extrude " + name_of(mesh, face);
  if (offset) return text + " " + format_place(*offset);
  if (distance) text += " " + format_double(*distance);
  return text;
}

glm::dvec3 Extrude::movement(const Mesh& mesh) const {
  if (offset) return *offset;
  const FacePolygon polygon(mesh, face);
  if (!polygon.is_finite()) return {};
  const std::vector<glm::dvec3> walk = polygon.keyhole_walk();
  const glm::dvec3 by = distance.value_or(std::sqrt(polygon_area(walk))) * polygon_normal(walk);
  return is_finite(by) ? by : glm::dvec3();
}

Verdict Extrude::check(const Mesh& mesh) const {
  Verdict verdict;
  if (is_gone(mesh, face, verdict)) return verdict;
  if (const Face other = equal_face(mesh, face)) verdict.refuse(Rule::loses_duplicate, {face, other});
  return verdict;
}

std::vector<Reason> Extrude::warnings(const Mesh& mesh) const {
  const glm::dvec3 by = movement(mesh);
  std::vector<Element> flat;
  for (Halfedge h : halfedges_around(mesh, face)) {
    if (is_bridge(mesh, h)) continue;
    const glm::dvec3 &a = mesh.position(mesh.from(h)), &b = mesh.position(mesh.to(h));
    if (FaceGeometry{{a, b, b + by, a + by}}.is_degenerate()) flat.push_back(edge(h));
  }
  if (flat.empty()) return {};
  return {{Rule::degenerate, flat}};
}

OpEffect Extrude::apply(Edit& edit) const {
  const Mesh& m = edit.mesh();
  assert(check(m).legal());
  OpEffect effect;
  std::vector<std::pair<Halfedge, Halfedge>> order;  // each side of the face and its successor
  for (Halfedge h : halfedges_around(m, face)) order.emplace_back(h, m.next(h));
  std::vector<Halfedge> bridges;
  for (const auto& [h, after] : order)
    if (is_bridge(m, h)) bridges.push_back(h);
  const Walls walls = raise(edit, face, movement(m), effect);
  set_wall_values(edit, walls);

  const auto raised = [&](Halfedge h) { return is_bridge(m, h) ? h : walls.at(m.from(h)).top; };
  std::vector<std::pair<Halfedge, Halfedge>> links;
  for (const auto& [h, after] : order) links.emplace_back(raised(h), raised(after));
  edit.set_halfedge(face, raised(m.halfedge(face)));
  for (std::uint32_t r = m.first_ring(face); r != no_index; r = m.ring(r).next)
    edit.set_ring_halfedge(r, raised(m.ring(r).halfedge));
  for (const auto& [h, after] : links) edit.connect(h, after);
  for (Halfedge h : bridges) {
    const Wall& wall = walls.at(m.from(h));
    if (m.halfedge(wall.from) == h) edit.set_halfedge(wall.from, wall.side);
    edit.set_from(h, m.to(wall.rise));
  }

  effect.changed.push_back(face);
  for (const Wall& wall : walls.in_order()) {
    const Wall& after = walls.at(m.to(wall.side));
    const Face fresh = edit.add_face(wall.side);
    copy_face_values(edit, face, fresh);
    edit.connect(wall.side, after.rise);
    edit.connect(after.rise, twin(wall.top));
    edit.connect(twin(wall.top), twin(wall.rise));
    edit.connect(twin(wall.rise), wall.side);
    set_face_along(edit, wall.side, fresh);
    edit.set_face(wall.top, face);
    edit.set_halfedge(m.to(wall.rise), wall.top);
    effect.created.push_back(fresh);
    effect.changed.push_back(fresh);
  }
  return effect;
}

}  // namespace ryosen
