#include "ryosen/algo/algorithm_rows.h"

#include "ryosen/algo/duplicate/part.h"
#include "ryosen/hull/hull_extent.h"
#include "ryosen/hull/hull_shape.h"
#include "ryosen/hull/projection.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen {

namespace {

using Numbers = std::vector<std::uint32_t>;

// The points that are meant, by slot, one list for each hull.
std::vector<Numbers> numbers_meant(const Mesh& mesh, const ParameterValues& values) {
  const bool is_apart = values.flag("per_component");
  if (values.has("elements") || is_apart) {
    const Part part = part_of(mesh, values.has("elements") ? values.elements("elements") : all_elements(mesh));
    std::vector<Numbers> lists;
    if (is_apart) {
      lists = joined_points(part.list, part.wires);
    } else {
      lists.emplace_back(part.points.size());
      for (std::uint32_t i = 0; i < part.points.size(); ++i) lists[0][i] = i;
    }
    for (Numbers& list : lists)
      for (std::uint32_t& i : list) i = part.points[i].index;
    return lists;
  }
  Numbers all;
  for (const Vertex v : live_vertices(mesh))
    if (point(mesh, v) == v) all.push_back(v.index);
  return {std::move(all)};
}

// By slot; what is not alive has any place.
std::vector<glm::dvec3> places_of(const Mesh& mesh, const std::vector<Numbers>& lists, std::string_view projection) {
  Numbers all;
  for (const Numbers& list : lists) all.insert(all.end(), list.begin(), list.end());
  std::vector<glm::dvec3> places;
  for (const std::uint32_t i : all) places.push_back(mesh.position(Vertex(i)));
  project(places, find_projection(projection)->projection);
  std::vector<glm::dvec3> by_slot(mesh.vertex_slots(), glm::dvec3(0.0));
  for (std::size_t k = 0; k < all.size(); ++k) by_slot[all[k]] = places[k];
  return by_slot;
}

// What the hulls are together.
struct Hulls {
  HullList list;
  std::size_t vertices = 0, facets = 0, left = 0, count = 0;
  HullSize size;
  HullExtent extent;  // the extremes, where they are asked for
  Text text;          // of the last one
};

Text joined(const Text& one, const Text& other) {
  return other.en.empty() ? one : one + Text{" " + other.en, other.ja};
}

void add(Hulls& all, std::span<const glm::dvec3> places, const ConvexHull& hull, const ParameterValues& values,
         Progress& progress) {
  add_hull(places, hull, values.choice("faces") == "triangles" ? HullFaces::triangles : HullFaces::facets, all.list);
  all.vertices += hull.vertices.size();
  all.facets += hull.facet_count();
  const HullSize size = hull_size(places, hull);
  all.size.volume += size.volume;
  all.size.area += size.area;
  ++all.count;
  all.text = joined(hull_sentence(hull), size_sentence(hull, size));
  if (values.flag("measure")) all.extent = extremes(all.extent, hull_extent(places, hull, progress));
}

AlgorithmResult hull(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  const ParameterValues& values = input.values;
  const std::vector<Numbers> lists = numbers_meant(edit.mesh(), values);
  const std::vector<glm::dvec3> places = places_of(edit.mesh(), lists, values.choice("project"));
  Hulls all;
  for (const Numbers& list : lists) {
    progress.begin_part(all.count, lists.size());
    const ConvexHull hull = hull_of_some(places, list, progress);
    if (progress.is_cancelled()) return {};
    all.left += list.size() - hull.used;
    add(all, places, hull, values, progress);
    if (progress.is_cancelled()) return {};
  }
  const AddedPart added = add_part(edit, {std::move(all.list.list), {}, std::move(all.list.wires)}, false);
  AlgorithmResult result;
  result.changed = added.counts.vertices;
  result.left = all.left;
  result.text = joined(all.count == 1 ? all.text : hulls_sentence(all.count, all.vertices, all.facets, all.size),
                       extent_sentence(all.extent));
  if (result.left > 0) {
    const std::string left = std::to_string(result.left);
    result.text +=
        Text{" Points that are not finite were left out: " + left + ".", "有限でない点 " + left + " 個は除きました。"};
  }
  return result;
}

std::vector<ParameterRow> parameters() {
  return {parameter_row({"faces", "Faces", "面", "the facets as they are, or cut into triangles",
                         "面をそのまま出すか、三角形に分けるか"},
                        {.kind = ParameterKind::choice,
                         .initial = "facets",
                         .choices = {{"facets", "Facets", "多角形"}, {"triangles", "Triangles", "三角形"}}}),
          parameter_row({"elements", "Elements", "対象", "of the vertices of these; else of all",
                         "これらの頂点の凸包（省くとすべての頂点）"},
                        {.kind = ParameterKind::elements, .is_worked_on = true}),
          parameter_row({"per_component", "Per component", "連結成分ごと", "a hull of each connected component",
                         "連結成分ごとに凸包を作る"},
                        {.kind = ParameterKind::flag, .initial = "off"}),
          parameter_row({"project", "Projection", "投影", "the polygon around the points as seen along an axis",
                         "点を軸方向に投影した多角形"},
                        {.kind = ParameterKind::choice, .initial = "none", .choices = choices_of(projections())}),
          parameter_row({"measure", "Measure", "計測", "also tells its farthest pair of points and its smallest width",
                         "最も遠い 2 点と最小の幅も示す"},
                        {.kind = ParameterKind::flag, .initial = "off"})};
}

}  // namespace

std::vector<AlgorithmRow> hull_rows() {
  return {algorithm_row(
      {"hull", "Convex hull", "凸包", "adds the convex hull of the vertices: facets in one plane united, exact",
       "頂点の凸包を追加する（同一平面の面は一枚にまとめる。判定は厳密）"},
      {.parameters = parameters(),
       .keeps_geometry = true,
       .run = hull,
       .selects_added = true,
       .has_own_subcommand = true})};
}

}  // namespace ryosen
