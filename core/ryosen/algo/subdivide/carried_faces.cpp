#include "ryosen/algo/subdivide/carried_faces.h"

#include <algorithm>

#include "ryosen/geometry/polygon_normal.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/mesh/value_rules.h"

namespace ryosen::subdivide {

namespace {

double area_of(const MeshColumns& columns, Face f) {
  std::vector<glm::dvec3> places;
  Halfedge h = columns.face_halfedge[f.index];
  do {
    places.push_back(columns.positions[columns.halfedges[h.index].from.index]);
    h = columns.halfedges[h.index].next;
  } while (h != columns.face_halfedge[f.index]);
  return polygon_area(places);
}

// Each face is divided among those that come of it, by their areas.
void divide_faces(const Mesh& mesh, AttributeColumn& column, const MeshColumns& out, const ChildAt& child) {
  const AttributeColumn before = column;
  column.data.resize(out.face_halfedge.size() * column.words());
  std::vector<Face> parents(out.face_halfedge.size());
  for (const Face f : live_faces(mesh)) parents[f.index] = f;  // one part keeps the number
  for (Halfedge h(0); h.index < mesh.halfedge_slots(); ++h.index)
    if (!mesh.is_outside(h)) parents[child(h).index] = mesh.face(h);
  std::vector<std::vector<Face>> parts(mesh.face_slots());
  for (Face part(0); part.index < parents.size(); ++part.index)
    if (parents[part.index]) parts[parents[part.index].index].push_back(part);
  for (const Face f : live_faces(mesh)) {
    const std::vector<Face>& own = parts[f.index];
    std::vector<double> areas;
    for (const Face part : own) areas.push_back(area_of(out, part));
    const std::vector<std::uint32_t> values = divide_value(before, f.index, areas);
    for (std::size_t i = 0; i < own.size(); ++i)
      std::copy_n(values.data() + i * column.words(), column.words(),
                  column.data.data() + std::size_t{own[i].index} * column.words());
  }
}

}  // namespace

void carry_faces(const Mesh& mesh, AttributeColumn& column, const MeshColumns& out, const ChildAt& child) {
  if (column.rule == ValueRule::sum || column.rule == ValueRule::own) return divide_faces(mesh, column, out, child);
  column.data.resize(out.face_halfedge.size() * column.words());
  for (std::uint32_t i = 0; i < mesh.halfedge_slots(); ++i) {
    const Halfedge h(i);
    if (mesh.is_outside(h)) continue;
    const Face from = mesh.face(h), to = child(h);
    const std::uint32_t* const words = column.data.data() + std::size_t{from.index} * column.words();
    if (from != to)
      std::copy(words, words + column.words(), column.data.data() + std::size_t{to.index} * column.words());
  }
}

}  // namespace ryosen::subdivide
