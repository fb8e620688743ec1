// Whether a mesh meets a form's requirements, and the table of relations.
#include <algorithm>
#include <array>
#include <string>

#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/textbook/forms/form.h"
#include "ryosen/textbook/forms/polygons.h"

namespace ryosen::forms {

namespace {

using Reason = std::optional<Text>;

std::string v_name(Vertex v) { return "v" + std::to_string(v.index); }
std::string f_name(Face f) { return "f" + std::to_string(f.index); }

Reason find_polygon(const Mesh& mesh) {
  for (const Face f : live_faces(mesh)) {
    const std::size_t corners = corners_of_loop(mesh, mesh.halfedge(f));
    if (corners == 3) continue;
    const std::string n = std::to_string(corners);
    return Text{"It holds triangles alone; " + f_name(f) + " has " + n + " corners.",
                "三角形しか持てません。" + f_name(f) + " は " + n + " 角形です。"};
  }
  return {};
}

Reason find_copies(const Mesh& mesh) {
  for (const Vertex v : live_vertices(mesh))
    if (mesh.next_copy(v) != v)
      return Text{"It holds one sheet of faces at each point; at " + v_name(v) + " there are several.",
                  "一つの点には一続きの面しか持てません。" + v_name(v) + " には複数あります。"};
  return {};
}

Reason find_wire(const Mesh& mesh) {
  for (const Edge e : live_edges(mesh)) {
    const Halfedge h = halfedge(e);
    if (!mesh.is_outside(h) || !mesh.is_outside(twin(h))) continue;
    const std::string ends = std::to_string(mesh.from(h).index) + "-" + std::to_string(mesh.to(h).index);
    return Text{"It holds edges with a face alone; " + ends + " has none.",
                "面のある稜線しか持てません。" + ends + " には面がありません。"};
  }
  return {};
}

// Finds a vertex with more than one gap in its cycle, or with a gap beside a closed fan.
Reason find_several_fans(const Mesh& mesh) {
  std::vector<std::uint8_t> gaps(mesh.vertex_slots(), 0);
  for (const Halfedge h : live_halfedges(mesh)) {
    if (!mesh.is_outside(h) || ++gaps[mesh.from(h).index] < 2) continue;
    const std::string v = v_name(mesh.from(h));
    return Text{"It holds one fan of faces at each vertex; at " + v + " there are several.",
                "一つの頂点には一つの扇しか持てません。" + v + " には複数あります。"};
  }
  return {};
}

Reason find_isolated(const Mesh& mesh) {
  for (const Vertex v : live_vertices(mesh))
    if (mesh.is_isolated(v))
      return Text{"It holds vertices of faces alone; " + v_name(v) + " has none.",
                  "面の頂点しか持てません。" + v_name(v) + " には面がありません。"};
  return {};
}

Reason find_equal_places(const Mesh& mesh) {
  std::vector<Vertex> points;
  for (const Vertex v : live_vertices(mesh)) {
    if (is_further_copy(mesh, v)) continue;
    const glm::dvec3& p = mesh.position(v);
    if (!is_finite(p))
      return Text{"It tells points apart by their coordinates; those of " + v_name(v) + " are not finite.",
                  "座標で点を見分けます。" + v_name(v) + " の座標は有限ではありません。"};
    points.push_back(v);
  }
  const auto place = [&](Vertex v) {
    const glm::dvec3& p = mesh.position(v);
    return std::array{p.x, p.y, p.z};
  };
  std::sort(points.begin(), points.end(), [&](Vertex a, Vertex b) { return place(a) < place(b); });
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (place(points[i - 1]) != place(points[i])) continue;
    const std::string a = v_name(std::min(points[i - 1], points[i])), b = v_name(std::max(points[i - 1], points[i]));
    return Text{"It tells points apart by their coordinates; " + a + " and " + b + " have the same.",
                "座標で点を見分けます。" + a + " と " + b + " は同じ座標です。"};
  }
  return {};
}

Reason find_rings(const Mesh& mesh) {
  for (const Face f : live_faces(mesh))
    if (!inner_loops(mesh, f).empty())
      return Text{"It holds faces without inner loops; " + f_name(f) + " has some.",
                  "内側のループを持つ面は持てません。" + f_name(f) + " にはあります。"};
  return {};
}

Reason find_bridge(const Mesh& mesh) {
  for (const Edge e : live_edges(mesh)) {
    const Halfedge h = halfedge(e);
    if (mesh.is_outside(h) || mesh.face(h) != mesh.face(twin(h))) continue;
    const std::string ends = std::to_string(mesh.from(h).index) + "-" + std::to_string(mesh.to(h).index);
    return Text{"It holds edges between different faces alone; " + ends + " has one face on both sides.",
                "両側の面が異なる稜線しか持てません。" + ends + " の両側は同じ面です。"};
  }
  return {};
}

struct Check {
  Needs need;
  Reason (*find)(const Mesh& mesh);
};
constexpr std::array checks{
    Check{triangles, find_polygon},
    Check{no_rings, find_rings},
    Check{no_bridges, find_bridge},
    Check{one_vertex_per_point, find_copies},
    Check{no_wires, find_wire},
    Check{one_fan_per_vertex, find_several_fans},
    Check{no_isolated_vertices, find_isolated},
    Check{different_places, find_equal_places},
};

constexpr std::array relation_rows{
    RelationRow{Relation::vertex_vertices, "vertex_vertices", ElementOf::vertex, "V→V", "V→V"},
    RelationRow{Relation::vertex_edges, "vertex_edges", ElementOf::vertex, "V→E", "V→E"},
    RelationRow{Relation::vertex_faces, "vertex_faces", ElementOf::vertex, "V→F", "V→F"},
    RelationRow{Relation::edge_vertices, "edge_vertices", ElementOf::edge, "E→V", "E→V"},
    RelationRow{Relation::edge_edges, "edge_edges", ElementOf::edge, "E→E", "E→E"},
    RelationRow{Relation::edge_faces, "edge_faces", ElementOf::edge, "E→F", "E→F"},
    RelationRow{Relation::face_vertices, "face_vertices", ElementOf::face, "F→V", "F→V"},
    RelationRow{Relation::face_edges, "face_edges", ElementOf::face, "F→E", "F→E"},
    RelationRow{Relation::face_faces, "face_faces", ElementOf::face, "F→F", "F→F"},
    RelationRow{Relation::valence, "valence", ElementOf::vertex, "valence", "次数"},
};
static_assert(rows_are_in_order(relation_rows, &RelationRow::relation));

}  // namespace

std::span<const RelationRow> relations() { return relation_rows; }

std::optional<Text> why_unsuitable(const Mesh& mesh, std::uint32_t needs) {
  for (const Check& check : checks)
    if (needs & check.need)
      if (Reason reason = check.find(mesh)) return reason;
  return {};
}

}  // namespace ryosen::forms
