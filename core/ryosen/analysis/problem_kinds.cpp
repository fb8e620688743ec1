#include "ryosen/analysis/problem_kinds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "ryosen/analysis/boundary_loops.h"
#include "ryosen/analysis/coincident_points.h"
#include "ryosen/analysis/equal_faces.h"
#include "ryosen/base/count_text.h"
#include "ryosen/base/open_table.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/geometry/predicates.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/faces_at.h"

namespace ryosen {

namespace {

bool is_boundary_edge(Neighbourhood& around, Edge e) {
  const Mesh& mesh = around.mesh();
  const Halfedge h = halfedge(e);
  if (around.is_single_sheet(h)) return mesh.is_boundary(e);
  return around.edge(h).is_boundary() && around.is_first_sheet(e);
}

// Of an edge that may have several sheets, for which the first one speaks.
template <bool (PointEdge::*is_one)() const>
bool is_first_of(Neighbourhood& around, Edge e) {
  const Halfedge h = halfedge(e);
  return !around.is_single_sheet(h) && (around.edge(h).*is_one)() && around.is_first_sheet(e);
}

// Where faces join the same points, the edge that has them speaks for all.
bool is_wire_edge(Neighbourhood& around, Edge e) { return around.mesh().is_wire(e) && around.is_first_wire(e); }

bool is_nonmanifold_vertex(Neighbourhood& around, Vertex v) {
  if (around.is_plain(v) || around.point(v) != v) return false;
  const Star star = around.star(v);
  return star.fans > 1 || star.has_nonmanifold_edge;
}

bool is_isolated_vertex(Neighbourhood& around, Vertex v) {
  const Mesh& mesh = around.mesh();
  if (!mesh.is_isolated(v) || around.point(v) != v) return false;
  return !any_of_copies(mesh, v, [&](Vertex copy) { return !mesh.is_isolated(copy); });
}

bool is_nonfinite_vertex(Neighbourhood& around, Vertex v) {
  return !is_finite(around.mesh().position(v)) && around.point(v) == v;
}

// A difference of products too large for rounding to have made it: the bound of orient2d (predicates.cpp).
bool differ(double left, double right) {
  const double size = std::abs(left) + std::abs(right);
  return size > 1e-280 && size <= 1e+300 && std::abs(left - right) > 4e-16 * size;
}

bool surely_not_collinear(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 u = b - a, v = c - a;
  return differ(u.y * v.z, u.z * v.y) || differ(u.z * v.x, u.x * v.z) || differ(u.x * v.y, u.y * v.x);
}

bool is_degenerate_at(const Mesh& mesh, Face f, std::span<const glm::dvec3> places) {
  const Halfedge first = mesh.halfedge(f), second = mesh.next(first);
  const glm::dvec3& a = places[mesh.from(first).index];
  // Then it is not degenerate, and a coordinate that is not finite makes no difference to that.
  if (surely_not_collinear(a, places[mesh.from(second).index], places[mesh.to(second).index])) return false;
  glm::dvec3 b = a;
  for (Vertex v : vertices_around(mesh, f)) {
    const glm::dvec3& p = places[v.index];
    if (!is_finite(p)) return false;
    if (b == a) b = p;
  }
  for (Vertex v : vertices_around(mesh, f))
    if (!are_collinear(a, b, places[v.index])) return false;
  return true;
}

bool is_degenerate_face(Neighbourhood& around, Face f) {
  return is_degenerate_at(around.mesh(), f, around.mesh().positions());
}

bool repeats_corner(const QuarantinedFace& face, std::uint32_t file_vertices) {
  if (face.corners.size() < 3) return false;
  std::vector<std::int64_t> points(face.corners.begin(), face.corners.end());
  sort_unique(points);
  return points.front() >= 0 && points.back() < std::int64_t{file_vertices} && points.size() < face.corners.size();
}

std::vector<Face> faces_at(const Mesh& m, Vertex v) {
  std::vector<Face> faces;
  for_each_face_at(m, v, [&](Face f) { faces.push_back(f); });
  sort_unique(faces);
  return faces;
}

std::vector<std::uint32_t> points_of(const Mesh& m, Face f) {
  std::vector<std::uint32_t> points;
  for (Vertex v : vertices_around(m, f)) points.push_back(point(m, v).index);
  sort_unique(points);
  return points;
}

// The faces behind the element, ascending, each once.
std::vector<Element> with_faces(Element element, std::vector<Face> faces) {
  sort_unique(faces);
  std::vector<Element> found{element};
  found.insert(found.end(), faces.begin(), faces.end());
  return found;
}

// The boundary loop that a boundary edge is in, in traversal order from the edge, or the edge alone where its chain
// ends at a non-manifold edge. O(boundary edges).
std::vector<Element> loop_of_edge(Neighbourhood& around, const IndexSet& boundary, Element element) {
  const BoundaryLoops loops = find_boundary_loops(around, boundary);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const auto loop = loops[i];
    const auto at = std::find_if(loop.begin(), loop.end(), [&](Halfedge h) { return Element(edge(h)) == element; });
    if (at == loop.end()) continue;
    std::vector<Element> found;
    for (Halfedge h : loop) found.emplace_back(edge(h));
    std::rotate(found.begin(), found.begin() + (at - loop.begin()), found.end());
    return found;
  }
  return {element};
}

// The edge and the faces at its points.
std::vector<Element> edge_with_faces(Neighbourhood& around, const IndexSet&, Element element) {
  const Mesh& m = around.mesh();
  const auto [a, b] = ends(m, element.edge());
  std::vector<Face> faces;
  for (Halfedge h : sheets_between(m, a, b))
    for (Halfedge side : {h, twin(h)})
      if (const Face f = m.face(side)) faces.push_back(f);
  return with_faces(element, std::move(faces));
}

// The vertex and the faces at all its copies.
std::vector<Element> vertex_with_fans(Neighbourhood& around, const IndexSet&, Element element) {
  return with_faces(element, faces_at(around.mesh(), element.vertex()));
}

// The face and all others on the same points.
std::vector<Element> equal_faces_of(Neighbourhood& around, const IndexSet&, Element element) {
  const Mesh& m = around.mesh();
  const std::vector<std::uint32_t> points = points_of(m, element.face());
  std::vector<Element> found{element};
  for (Face f : faces_at(m, Vertex(points[0])))
    if (f != element.face() && points_of(m, f) == points) found.emplace_back(f);
  return found;
}

// The vertex and all others at its place. O(members).
std::vector<Element> points_at_place(Neighbourhood& around, const IndexSet& members, Element element) {
  const Mesh& m = around.mesh();
  std::vector<Element> found{element};
  members.for_each([&](std::uint32_t i) {
    if (i != element.index && m.position(Vertex(i)) == m.position(element.vertex())) found.emplace_back(Vertex(i));
  });
  return found;
}

// The two triangles of a hanging pair.
std::vector<Element> pair_of_face(Neighbourhood& around, const IndexSet&, Element element) {
  const Face partner = hanging_partner(around, element.face());
  return partner ? std::vector<Element>{element, partner} : std::vector<Element>{element};
}

constexpr std::array<ProblemRow, enum_count<ProblemKind>> built_in{{
    {.kind = ProblemKind::nonmanifold_edge,
     .id = "nonmanifold_edge",
     .name_en = "Non-manifold edge",
     .name_ja = "非多様体の稜線",
     .several_en = "non-manifold edges",
     .one_en = "One edge carries three or more faces.",
     .many_en = "# edges carry three or more faces.",
     .many_ja = "三つ以上の面が接する稜線が # 本あります。",
     .figure = "nonmanifold_edges",
     .figure_en = "Edges of three or more faces.",
     .figure_ja = "非多様体の稜線数。",
     .edge = is_first_of<&PointEdge::is_nonmanifold>,
     .about = edge_with_faces},
    {.kind = ProblemKind::nonmanifold_vertex,
     .id = "nonmanifold_vertex",
     .name_en = "Non-manifold vertex",
     .name_ja = "非多様体の頂点",
     .several_en = "non-manifold vertices",
     .one_en = "The faces at one vertex do not form a single fan, or it ends a non-manifold edge.",
     .many_en = "The faces at # vertices do not form a single fan, or they end non-manifold edges.",
     .many_ja = "周りの面が一つの扇にならないか、非多様体の稜線の端にある頂点が # 個あります。",
     .figure = "nonmanifold_vertices",
     .figure_en = "Vertices whose faces form no single fan, or where a non-manifold edge ends.",
     .figure_ja = "非多様体の頂点数。",
     .vertex = is_nonmanifold_vertex,
     .about = vertex_with_fans},
    {.kind = ProblemKind::misoriented_edge,
     .id = "misoriented_edge",
     .name_en = "Misoriented edge",
     .name_ja = "向きの不一致な稜線",
     .several_en = "misoriented edges",
     .one_en = "The two faces at one edge are turned against each other.",
     .many_en = "The two faces at each of # edges are turned against each other.",
     .many_ja = "両側の面の向きが食い違う稜線が # 本あります。",
     .figure = "misoriented_edges",
     .figure_en = "Edges whose two faces are turned against each other.",
     .figure_ja = "向きの不一致な稜線数。",
     .edge = is_first_of<&PointEdge::is_misoriented>,
     .about = edge_with_faces},
    {.kind = ProblemKind::degenerate_repeat,
     .id = "degenerate_repeat",
     .name_en = "Face with a repeated corner",
     .name_ja = "同じ頂点を繰り返す面",
     .several_en = "faces with a repeated corner",
     .one_en = "One face visits a vertex more than once.",
     .many_en = "# faces visit a vertex more than once.",
     .many_ja = "同じ頂点を二度以上通る面が # 個あります。",
     .figure = "degenerate_repeat",
     .figure_en = "Quarantined faces that visit a vertex twice.",
     .figure_ja = "同じ頂点を繰り返すため隔離された面の数。",
     .quarantined = repeats_corner},
    {.kind = ProblemKind::degenerate_area,
     .id = "degenerate_area",
     .name_en = "Degenerate face",
     .name_ja = "面積ゼロの面",
     .several_en = "degenerate faces",
     .one_en = "The corners of one face lie exactly on a line.",
     .many_en = "The corners of # faces lie exactly on a line.",
     .many_ja = "角がちょうど一直線に並ぶ、面積ゼロの面が # 個あります。",
     .figure = "degenerate_area",
     .figure_en = "Faces whose corners lie on a line.",
     .figure_ja = "面積ゼロの面の数。",
     .face = is_degenerate_face,
     .face_at = is_degenerate_at},
    {.kind = ProblemKind::duplicate_face,
     .id = "duplicate_face",
     .name_en = "Duplicate face",
     .name_ja = "重複面",
     .several_en = "duplicate faces",
     .one_en = "One face has the same vertices as an earlier one.",
     .many_en = "# faces have the same vertices as an earlier one.",
     .many_ja = "前の面と同じ頂点を持つ重複面が # 個あります。",
     .figure = "duplicate_faces",
     .figure_en = "Faces with the same vertices as an earlier one.",
     .figure_ja = "重複面の数。",
     .face = has_lower_equal_face,
     .about = equal_faces_of,
     .find_all = find_duplicate_faces},
    {.kind = ProblemKind::hanging_pair,
     .id = "hanging_pair",
     .name_en = "Hanging pair",
     .name_ja = "背中合わせの三角形",
     .several_en = "hanging pairs",
     .one_en = "Two triangles lie back to back and hang on one edge at most.",
     .many_en = "# pairs of triangles lie back to back and hang on one edge at most.",
     .many_ja = "背中合わせに重なり、高々一本の稜線でつながる三角形の組（テキストの「縮退」）が # 組あります。",
     .figure = "hanging_pairs",
     .figure_en = "Pairs of triangles back to back that hang on one edge at most.",
     .figure_ja = "背中合わせの三角形の組の数。",
     .face = closes_hanging_pair,
     .by_hand_en = "No repair takes these away, since they bound a closed part: delete one of the two, or both.",
     .by_hand_ja = "閉じた部分の壁なので自動では除きません。一方または両方を削除してください。",
     .about = pair_of_face},
    {.kind = ProblemKind::isolated_vertex,
     .id = "isolated_vertex",
     .name_en = "Isolated vertex",
     .name_ja = "孤立頂点",
     .several_en = "isolated vertices",
     .one_en = "One vertex belongs to no face.",
     .many_en = "# vertices belong to no face.",
     .many_ja = "どの面にも属さない頂点が # 個あります。",
     .figure = "isolated_vertices",
     .figure_en = "Vertices that no usable face and no line uses; a face set aside or a point may.",
     .figure_ja = "孤立頂点（使える面も線も使わない頂点。隔離された面や点は使うことがある）の数。",
     .vertex = is_isolated_vertex,
     .is_of_the_vertex = true,
     .spares_lines = true},
    {.kind = ProblemKind::nonfinite_vertex,
     .id = "nonfinite_vertex",
     .name_en = "Vertex without a place",
     .name_ja = "座標が有限でない頂点",
     .several_en = "vertices without a place",
     .one_en = "One vertex has a coordinate that is not a finite number.",
     .many_en = "# vertices have a coordinate that is not a finite number.",
     .many_ja = "座標が有限の数でない頂点が # 個あります。",
     .figure = "nonfinite_vertices",
     .figure_en = "Vertices with a coordinate that is no finite number.",
     .figure_ja = "座標が有限でない頂点の数。",
     .vertex = is_nonfinite_vertex,
     .is_of_the_vertex = true},
    {.kind = ProblemKind::quarantined_face,
     .id = "quarantined_face",
     .name_en = "Quarantined face",
     .name_ja = "隔離された面",
     .several_en = "quarantined faces",
     .one_en = "One face of the file cannot be connected and is kept aside.",
     .many_en = "# faces of the file cannot be connected and are kept aside.",
     .many_ja = "接続できず隔離されたファイル中の面が # 個あります。",
     .figure = "quarantined",
     .figure_en = "Faces that cannot take part in the mesh.",
     .figure_ja = "隔離された面の数。",
     .quarantined = [](const QuarantinedFace&, std::uint32_t) { return true; }},
    {.kind = ProblemKind::self_intersection,
     .id = "self_intersection",
     .name_en = "Face that meets another",
     .name_ja = "自己交差する面",
     .several_en = "faces that meet others",
     .one_en = "One face meets another elsewhere than in their common vertices and edges.",
     .many_en = "# faces meet others elsewhere than in their common vertices and edges.",
     .many_ja = "共有する頂点・稜線以外で他の面と交わる面が # 個あります。",
     .searched_by = "self_intersections",
     .by_hand_en = "No repair takes these away: move or delete one of the faces that meet.",
     .by_hand_ja = "自動では直せません。交わる面の一方を動かすか削除してください。"},
    {.kind = ProblemKind::boundary_loop,
     .id = "boundary_loop",
     .severity = ProblemSeverity::info,
     .name_en = "Boundary loop",
     .name_ja = "境界ループ",
     .several_en = "boundary loops",
     .one_en = "The surface has one boundary loop.",
     .many_en = "The surface has # boundary loops.",
     .many_ja = "曲面に境界ループが # 本あります。",
     .figure = "boundary_edges",
     .figure_en = "Edges of one face.",
     .figure_ja = "境界の稜線数。",
     .edge = is_boundary_edge,
     .about = loop_of_edge},
    {.kind = ProblemKind::ring,
     .id = "ring",
     .severity = ProblemSeverity::info,
     .name_en = "Ring of a face",
     .name_ja = "面の穴",
     .several_en = "rings of faces",
     .one_en = "A face has one ring, an inner loop.",
     .many_en = "Faces have # rings, their inner loops.",
     .many_ja = "面の内側のループ（穴）が # 個あります。",
     .face = [](Neighbourhood& around, Face f) { return around.mesh().has_rings(f); }},
    {.kind = ProblemKind::wire,
     .id = "wire",
     .severity = ProblemSeverity::info,
     .name_en = "Wire",
     .name_ja = "面のない稜線",
     .several_en = "wires",
     .one_en = "One edge has no face on either side.",
     .many_en = "# edges have no face on either side.",
     .many_ja = "どちら側にも面のない稜線が # 本あります。",
     .edge = is_wire_edge},
    {.kind = ProblemKind::coincident_points,
     .id = "coincident_points",
     .severity = ProblemSeverity::info,
     .name_en = "Coincident point",
     .name_ja = "重なった頂点",
     .several_en = "coincident points",
     .one_en = "One vertex lies on another.",
     .many_en = "# vertices lie on others.",
     .many_ja = "他の頂点とちょうど重なる頂点が # 個あります。",
     .by_hand_en = "Parts that touch may keep them; a copy that lies on its original can be deleted.",
     .by_hand_ja = "接する部品どうしならそのままで構いません。元に重なった複製は削除できます。",
     .is_of_the_vertex = true,
     .about = points_at_place,
     .find_all = find_coincident_points},
}};

static_assert(rows_are_in_order(built_in, &ProblemRow::kind));

constinit OpenTable<ProblemRow, most_problem_kinds> table(built_in);

}  // namespace

Text ProblemRow::sentence(std::size_t count) const { return count_text(count, one_en, many_en, many_ja); }

Text ProblemRow::name_of(std::size_t count) const {
  std::string one(name_en);
  if (!one.empty() && one[0] >= 'A' && one[0] <= 'Z') one[0] = static_cast<char>(one[0] - 'A' + 'a');
  return {count == 1 || several_en.empty() ? one : std::string(several_en), std::string(name_ja)};
}

std::span<const ProblemRow> problem_table() { return table.rows(); }
const ProblemRow& row_of(ProblemKind kind) { return table.rows()[static_cast<std::size_t>(kind)]; }
std::vector<Element> about(const ProblemRow& row, Neighbourhood& around, const IndexSet& members, Element element) {
  return row.about ? row.about(around, members, element) : std::vector<Element>{element};
}

const ProblemRow* find_problem_row(std::string_view id) { return table.find(id); }

ScopedProblem::ScopedProblem(ProblemRow row) : kind(static_cast<ProblemKind>(table.rows().size())) {
  row.kind = kind;
  table.add(row);
}
ScopedProblem::~ScopedProblem() { table.remove_last(); }

}  // namespace ryosen
