#include "core/algo/hull/hull.h"

#include "core/algo/copying/part.h"
#include "core/hull/hull_shape.h"
#include "core/mesh/copies.h"

namespace ryosen {

namespace {

std::vector<glm::dvec3> places_meant(const Mesh& mesh, const ParameterValues& values) {
  std::vector<glm::dvec3> places;
  if (values.has("elements")) {
    for (const Vertex v : part_of(mesh, values.elements("elements")).points) places.push_back(mesh.position(v));
    return places;
  }
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i)
    if (mesh.is_alive(Vertex(i)) && point(mesh, Vertex(i)) == Vertex(i)) places.push_back(mesh.position(Vertex(i)));
  return places;
}

AlgorithmResult hull(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  const std::vector<glm::dvec3> places = places_meant(edit.mesh(), input.values);
  const ConvexHull hull = convex_hull(places, progress);
  if (progress.is_cancelled()) return {};
  const HullFaces faces = input.values.choice("faces") == "triangles" ? HullFaces::triangles : HullFaces::facets;
  HullList list = hull_list(places, hull, faces);
  const AddedPart added = add_part(edit, {std::move(list.list), {}, std::move(list.wires)}, false);
  AlgorithmResult result;
  result.changed = added.counts.vertices;
  result.left = places.size() - hull.used;
  result.text = hull_sentence(hull);
  if (result.left > 0) {
    const std::string left = std::to_string(result.left);
    result.text = result.text + Text{" Points that are not finite were left out: " + left + ".",
                                     "有限でない点 " + left + " 個は除きました。"};
  }
  return result;
}

}  // namespace

std::vector<AlgorithmRow> hull_rows() {
  return {{.id = "hull",
           .name_en = "Convex hull",
           .name_ja = "凸包",
           .help_en = "adds the convex hull of the vertices: facets in one plane united, exact",
           .help_ja = "頂点の凸包を追加する（同一平面の面は一枚にまとめる。判定は厳密）",
           .parameters = {{.id = "faces",
                           .kind = ParameterKind::choice,
                           .name_en = "Faces",
                           .name_ja = "面",
                           .help_en = "the facets as they are, or cut into triangles",
                           .help_ja = "面をそのまま出すか、三角形に分けるか",
                           .initial = "facets",
                           .choices = {{"facets", "Facets", "多角形"}, {"triangles", "Triangles", "三角形"}}},
                          {.id = "elements",
                           .kind = ParameterKind::elements,
                           .name_en = "Elements",
                           .name_ja = "対象",
                           .help_en = "of the vertices of these; else of all",
                           .help_ja = "これらの頂点の凸包（省くとすべての頂点）"}},
           .keeps_geometry = true,
           .solves = {},
           .run = hull,
           .selects_added = true,
           .has_own_subcommand = true}};
}

}  // namespace ryosen
