#include "core/algo/remesh/remesh.h"

#include <cmath>

#include "core/algo/cut_faces.h"
#include "core/algo/remesh/remesher.h"
#include "core/algo/unit_scale.h"

namespace ryosen::remesh {

namespace {

// About how many triangles come of it, by the area and the features that are divided.
double expected_triangles(const Mesh& mesh, const Options& options) {
  double area = 0;
  for (std::uint32_t i = 0; i < mesh.face_slots(); ++i)
    if (mesh.is_alive(Face(i))) {
      const double twice = glm::length(area_normal(corners_of(mesh, mesh.halfedge(Face(i)))));
      if (std::isfinite(twice)) area += twice / 2;
    }
  double longest = 0;
  for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
    if (!mesh.is_alive(Edge(i))) continue;
    const auto [a, b] = ends(mesh, Edge(i));
    const double length = glm::distance(mesh.position(a), mesh.position(b));
    if (std::isfinite(length)) longest = std::max(longest, length);
  }
  return area / (options.length * options.length * 0.433) + longest / options.length;
}

std::optional<Text> fault_of_length(const Mesh& mesh, const Options& options) {
  constexpr double most = 3e8;  // elements of a mesh are numbered with 32 bits
  const double count = expected_triangles(mesh, options);
  if (count < most) return std::nullopt;
  return Text{"so short a length would make more triangles than a mesh can number; take a longer one",
              "この長さでは三角形の数がメッシュの上限を超えます。もっと長くしてください"};
}

bool run_rounds(Remesher& remesher, std::size_t rounds, Progress& progress) {
  for (std::size_t round = 0; round < rounds; ++round) {
    const auto at = [&](std::size_t pass) { return progress.go_on(4 * round + pass, 4 * rounds); };
    if (!(at(0) && remesher.split_long(progress) && at(1) && remesher.collapse_short(progress) && at(2) &&
          remesher.swap_for_valence(progress) && at(3) && remesher.relax(progress)))
      return false;
  }
  return remesher.swap_slivers(progress);
}

Mesh scaled(const Mesh& mesh, double scale) {
  MeshColumns columns = mesh.columns();
  for (glm::dvec3& p : columns.positions) p *= scale;
  return Mesh(std::move(columns));
}

// With the places in the old size, those that did not move to the bit.
MeshColumns unscaled(const Mesh& mesh, const Mesh& before, double scale) {
  MeshColumns columns = mesh.columns();
  for (std::size_t i = 0; i < columns.positions.size(); ++i) {
    const bool is_old = i < before.vertex_slots();
    const glm::dvec3 old = is_old ? before.position(Vertex(i)) : glm::dvec3(0);
    columns.positions[i] = is_old && columns.positions[i] == old * scale ? old : columns.positions[i] / scale;
  }
  return columns;
}

}  // namespace

Remeshed remeshed(const Mesh& mesh, const Options& options, Progress& progress) {
  Remeshed result;
  result.is_cancelled = !progress.go_on(0, options.rounds);
  if (result.is_cancelled) return result;
  const double scale = unit_scale(mesh.positions());
  Options own = options;
  own.length *= scale;
  own.tolerance *= scale;
  Mesh work = scaled(mesh, scale);
  Edit edit(work, nullptr);
  const std::vector<Face> polygons = polygons_of_mesh(work);
  result.cut_faces = polygons.size();
  if ((result.fault = cut_faces(edit, polygons)) || (result.fault = fault_of_length(work, own))) return result;
  const Target target(work, {own.length, own.adaptive, own.tolerance});
  Remesher remesher(edit, find_features(work, own.feature_angle_rad), target);
  result.is_cancelled = !run_rounds(remesher, own.rounds, progress);
  edit.commit();
  if (!result.is_cancelled) result.columns = unscaled(work, mesh, scale);
  return result;
}

}  // namespace ryosen::remesh
