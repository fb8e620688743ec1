#include "ryosen/ops/extrude.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "ryosen/geometry/is_finite.h"
#include "ryosen/geometry/polygon_normal.h"
#include "ryosen/mesh/face_polygon.h"
#include "ryosen/ops/parameters/member_values.h"
#include "ryosen/ops/rules/face_geometry.h"
#include "ryosen/ops/rules/face_lists.h"
#include "ryosen/ops/rules/raise.h"

namespace ryosen {

namespace {

using namespace parameters;

std::optional<Text> fault_of_extrusion(const Mesh& mesh, const void* op) {
  const Extrude& extrude = *static_cast<const Extrude*>(op);
  if (!extrude.offset && !extrude.distance) return std::nullopt;
  const glm::dvec3 by = extrude.movement(mesh);
  for (const Face f : extrude.faces)
    for (const Vertex v : vertices_around(mesh, f))
      if (is_finite(mesh.position(v)) && !is_finite(mesh.position(v) + by))
        return Text{"a movement that leaves the face at a finite place", "面の座標が有限になる移動量を"};
  return std::nullopt;
}

constexpr OpDrag drag_of_extrusion{.moved =
                                       [](const Mesh&, const void* op, const ColumnLengths&) {
                                         const std::vector<Face>& faces = static_cast<const Extrude*>(op)->faces;
                                         return std::vector<Element>(faces.begin(), faces.end());
                                       },
                                   .begins_flat = true,
                                   .along_normal = true,
                                   .unmoved_en = extruded_by_nothing_en,
                                   .unmoved_ja = extruded_by_nothing_ja};

constexpr OpParameter extrude_parameters[] = {
    with_words({"faces", "Faces", "面", "the faces that are moved together", "まとめて動かす面"},
               list(face<&Extrude::faces>("fN"), "fM")),
    with_words(
        {"by", "Movement", "移動量",
         "how far they move along their mean normal, or by X,Y,Z (by the root of their mean area if it is left out)",
         "平均の法線方向の距離、または移動量 X,Y,Z（省くと平均面積の平方根）"},
        dragged(drag_of_extrusion, optional(named("Distance", "距離", number<&Extrude::distance>("DISTANCE")),
                                            named("Offset", "移動量", position<&Extrude::offset>()))))};

}  // namespace

constinit const OpInfo Extrude::info{
    .id = "extrude",
    .name_en = "Extrude faces",
    .name_ja = "面の押し出し",
    .line = {.lists = {extrude_parameters}, .fault = fault_of_extrusion},
    .help_en =
        "moves faces together along their mean normal or by X,Y,Z and connects their border to its old place by walls",
    .help_ja = "面をまとめて平均の法線方向または X,Y,Z だけ動かし、まとまりの境界の稜線を元の位置と側面でつなぐ",
    .target = OpTargetKind::face,
    .group = OpGroup::refine,
    .on_selection = OnSelection::all};

namespace {

// Below this share of the sum of the areas the sum of the vector areas is rounding.
constexpr double least_share = 1e-12;

// The common normal of faces and the square root of their mean area.
struct Slope {
  glm::dvec3 normal{0};
  double size = 0;
};

// Areas may overflow where their sums are taken, so each is taken relative to the largest.
Slope slope_of(const Mesh& mesh, std::span<const Face> faces) {
  std::vector<std::pair<double, glm::dvec3>> parts;  // area, normal
  double largest = 0;
  FacePolygon polygon;
  for (Face f : faces) {
    polygon.read(mesh, f);
    if (!polygon.is_finite()) continue;
    const std::vector<glm::dvec3> walk = polygon.keyhole_walk();
    parts.emplace_back(polygon_area(walk), polygon_normal(walk));
    largest = std::max(largest, parts.back().first);
  }
  if (parts.empty()) return {};
  if (parts.size() == 1) return {parts[0].second, std::sqrt(largest)};
  glm::dvec3 sum(0);
  double all = 0;
  for (const auto& [area, normal] : parts) {
    const double share = area == largest ? 1 : area / largest;
    sum += share * normal;
    all += share;
  }
  const double length = glm::length(sum);
  const double size = std::sqrt(largest) * std::sqrt(all / static_cast<double>(parts.size()));
  return length > least_share * all ? Slope{sum / length, size} : Slope{};
}

// Refuses faces with another one on the same points that would stay.
void refuse_duplicates(const Mesh& mesh, const Region& region, Verdict& verdict) {
  std::map<std::vector<std::uint32_t>, Face> asked;  // the first face on each set of points
  for (Face f : region.faces()) {
    const std::vector<std::uint32_t> points = point_set(loops_of(mesh, f).corners);
    if (!asked.emplace(points, f).second) continue;
    const Face other = face_on_unless(mesh, points, [&](Face g) { return region.contains(g); });
    if (other) verdict.refuse(Rule::loses_duplicate, {f, other});
  }
}

}  // namespace

glm::dvec3 Extrude::movement(const Mesh& mesh) const {
  if (offset) return *offset;
  const Region region(mesh, faces);
  const Slope slope = slope_of(mesh, region.faces());
  const glm::dvec3 by = distance.value_or(slope.size) * slope.normal;
  return is_finite(by) ? by : glm::dvec3();
}

Verdict Extrude::check(const Mesh& mesh) const {
  Verdict verdict;
  if (!any_is_gone(mesh, faces, verdict)) refuse_duplicates(mesh, Region(mesh, faces), verdict);
  return verdict;
}

std::vector<Reason> Extrude::warnings(const Mesh& mesh) const {
  const glm::dvec3 by = movement(mesh);
  const Region region(mesh, faces);
  std::vector<Element> flat;
  for (const Region::Border& border : region.border()) {
    const glm::dvec3 &a = mesh.position(mesh.from(border.side)), &b = mesh.position(mesh.to(border.side));
    if (FaceGeometry{{a, b, b + by, a + by}}.is_degenerate()) flat.push_back(edge(border.side));
  }
  if (flat.empty()) return {};
  return {{Rule::degenerate, flat}};
}

OpEffect Extrude::apply(Edit& edit) const {
  assert(check(edit.mesh()).legal());
  return raise(edit, Region(edit.mesh(), faces), movement(edit.mesh()));
}

}  // namespace ryosen
