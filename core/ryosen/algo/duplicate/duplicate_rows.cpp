#include "ryosen/algo/algorithm_rows.h"

#include <algorithm>
#include <cmath>

#include "ryosen/algo/duplicate/part.h"
#include "ryosen/algo/features.h"
#include "ryosen/algo/repair/point_merger.h"
#include "ryosen/base/count_text.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"

namespace ryosen {

namespace {

Part part_meant(const Mesh& mesh, const ParameterValues& values) {
  return part_of(mesh, values.has("elements") ? values.elements("elements") : all_elements(mesh));
}

AlgorithmResult result_of(const AddedPart& added) {
  AlgorithmResult result;
  result.changed = added.counts.vertices;
  result.left = added.left_wires;
  const std::string v = std::to_string(added.counts.vertices), e = std::to_string(added.counts.edges);
  result.text = count_text(added.counts.faces, "# face were added", "# faces were added", "面 # を追加しました");
  result.text.en = v + " vertices, " + e + " edges and " + result.text.en;
  result.text.ja = "頂点 " + v + "、稜線 " + e + "、" + result.text.ja;
  return result;
}

void end_sentence(AlgorithmResult& result) { result.text = result.text + Text{".", "。"}; }

AlgorithmResult duplicate(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  Part part = part_meant(edit.mesh(), input.values);
  AlgorithmResult result;
  for (glm::dvec3& place : part.list.positions) place += input.values.place("by");
  if (!progress.go_on(1, 2)) return result;
  result = result_of(add_part(edit, std::move(part), true));
  end_sentence(result);
  return result;
}

// The faces run the other way round, so that their outside stays outside.
void reflect(IndexedMesh& list, int axis, double at) {
  for (glm::dvec3& place : list.positions) place[axis] = at - (place[axis] - at);
  const auto turn = [&](std::vector<std::uint32_t>& values) {
    if (values.empty()) return;
    for (std::size_t f = 0; f < list.face_count(); ++f)
      std::reverse(values.begin() + list.face_offsets[f], values.begin() + list.face_offsets[f + 1]);
  };
  turn(list.corners);
  turn(list.texcoords.index);
  list.normals = {};  // theirs would point elsewhere
}

// Of the points of a part those within a distance of the plane at which one gap ends.
std::vector<Vertex> points_at_plane(const Mesh& mesh, const Part& part, int axis, double at, double distance) {
  std::vector<Vertex> found;
  for (const Vertex v : part.points)
    if (std::abs(mesh.position(v)[axis] - at) <= distance && mesh.is_boundary(v) && !has_copies(mesh, v) &&
        !ends_a_wire_or_fan(mesh, v))
      found.push_back(v);
  return found;
}

// A point and its image become one where an edge of the boundary between two such closes, so that one fan comes out.
std::size_t weld(Edit& edit, const std::vector<std::pair<Vertex, Vertex>>& pairs, int axis, double at) {
  const Mesh& mesh = edit.mesh();
  std::vector<Vertex> points;
  for (const auto& [v, image] : pairs) points.insert(points.end(), {v, image});
  PointMerger merger(mesh, points);
  std::vector<std::pair<Vertex, Vertex>> joined;
  for (const auto& [v, image] : pairs)
    if (merger.merge(v, image)) joined.emplace_back(v, image);
  const auto has_partner = [&](const auto& pair) {
    const auto is_joined = [&](Vertex v) {  // they are ascending
      const auto at_v = std::lower_bound(joined.begin(), joined.end(), v,
                                         [](const auto& other, Vertex wanted) { return other.first < wanted; });
      return at_v != joined.end() && at_v->first == v;
    };
    for (const Halfedge h : outgoing(mesh, pair.first))
      if (mesh.is_boundary(edge(h)) && is_joined(mesh.to(h))) return true;
    return false;
  };
  for (std::size_t before = joined.size() + 1; before != joined.size();) {
    before = joined.size();
    std::vector<std::pair<Vertex, Vertex>> left;
    std::copy_if(joined.begin(), joined.end(), std::back_inserter(left), has_partner);
    joined = std::move(left);
  }
  std::vector<JoinedPoints> classes;
  for (const auto& [v, image] : joined) {
    glm::dvec3 place = mesh.position(v);
    place[axis] = at;
    classes.push_back({{v, image}, place});
  }
  if (!classes.empty()) join_points(edit, classes);
  return classes.size();
}

AlgorithmResult mirror(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  const Mesh& mesh = edit.mesh();
  const ParameterValues& values = input.values;
  const int axis = values.choice("axis") == "x" ? 0 : values.choice("axis") == "y" ? 1 : 2;
  const double at = values.place("about")[axis];
  Part part = part_meant(mesh, values);
  const bool welds = values.has("weld");
  std::vector<Vertex> on_plane;
  if (welds) on_plane = points_at_plane(mesh, part, axis, at, values.length("weld"));
  const std::vector<Vertex> points = part.points;
  reflect(part.list, axis, at);
  if (!progress.go_on(1, 2)) return {};
  const AddedPart added = add_part(edit, std::move(part), true);
  AlgorithmResult result = result_of(added);
  std::vector<std::pair<Vertex, Vertex>> pairs;
  for (const Vertex v : on_plane) {
    const auto number = std::lower_bound(points.begin(), points.end(), v) - points.begin();
    const Vertex image(added.first.index + static_cast<std::uint32_t>(number));
    if (!has_copies(mesh, image)) pairs.emplace_back(v, image);
  }
  if (welds) {
    const std::size_t welded = weld(edit, pairs, axis, at);
    result.text += count_text(welded, "; one vertex was welded at the plane", "; # vertices were welded at the plane",
                              "（面上で頂点 # 個を縫合）");
  }
  end_sentence(result);
  return result;
}

ParameterRow elements() {
  return parameter_row(
      {"elements", "Elements", "対象", "faces, also by all of their vertices, edges and vertices; else all",
       "面（全頂点の指定でも可）、稜線、頂点（省くとすべて）"},
      {.kind = ParameterKind::elements, .is_worked_on = true});
}

}  // namespace

std::vector<AlgorithmRow> duplicate_rows() {
  return {
      algorithm_row({"duplicate", "Duplicate", "複製", "adds a copy of elements as a part of its own",
                     "要素の複製を独立した部分として追加する"},
                    {.parameters = {elements(), parameter_row({"by", "By", "移動量", "how far the copy lies from there",
                                                               "複製をずらす量"},
                                                              {.kind = ParameterKind::place, .initial = "0,0,0"})},
                     .run = duplicate,
                     .selects_added = true}),
      algorithm_row(
          {"mirror", "Mirror", "鏡像",
           "adds the mirror image of elements, its faces turned so that outside stays outside",
           "要素の鏡像を、面の表裏を保って追加する"},
          {.parameters = {parameter_row({"axis", "Axis", "軸", "the direction across the plane", "鏡の面に垂直な軸"},
                                        {.kind = ParameterKind::choice,
                                         .initial = "x",
                                         .choices = {{"x", "X", "X"}, {"y", "Y", "Y"}, {"z", "Z", "Z"}}}),
                          parameter_row({"about", "About", "通る点", "a point of the plane", "鏡の面が通る点"},
                                        {.kind = ParameterKind::place, .initial = "0,0,0"}),
                          parameter_row({"weld", "Weld", "縫合距離",
                                         "boundary vertices as near to the plane are shared with the image; else none",
                                         "面からこの距離以内の境界頂点を鏡像と共有する（省くと共有しない）"},
                                        {.kind = ParameterKind::length}),
                          elements()},
           .run = mirror,
           .selects_added = true}),
  };
}

}  // namespace ryosen
