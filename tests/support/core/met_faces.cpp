#include "tests/support/core/met_faces.h"

#include <algorithm>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/live_elements.h"
#include "tests/support/core/pairs_by_asking_all.h"

namespace ryosen::test {

namespace {

// Points of faces, without their pairs.
MetFaces unasked_faces(const Mesh& mesh) {
  MetFaces faces;
  for (const Face f : live_faces(mesh)) {
    std::size_t k = 0;
    for (const Vertex v : vertices_around(mesh, f)) faces.corners[f][k++] = mesh.copy_point(v).index;
  }
  return faces;
}

bool have_common_side(const std::array<std::uint32_t, 3>& a, const std::array<std::uint32_t, 3>& b) {
  return std::count_if(a.begin(), a.end(), [&](auto corner) { return std::count(b.begin(), b.end(), corner) > 0; }) > 1;
}

}  // namespace

MetFaces met_faces(const IndexedMesh& list, std::span<const Face> names) {
  MetFaces faces;
  for (std::size_t i = 0; i < names.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) faces.corners[names[i]][k] = list.face(i)[k];
  for (const FacePair& pair : pairs_by_asking_all(list)) {
    const Face a = names[pair.first.index], b = names[pair.second.index];
    faces.pairs.insert({std::min(a, b), std::max(a, b)});
  }
  return faces;
}

MetFaces met_faces(const Mesh& mesh) {
  const MetFaces faces = unasked_faces(mesh);
  IndexedMesh list;
  std::vector<Face> names;
  list.positions.assign(mesh.positions().begin(), mesh.positions().end());
  for (const auto& [face, corners] : faces.corners) {
    names.push_back(face);
    list.corners.insert(list.corners.end(), corners.begin(), corners.end());
    list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size()));
  }
  return met_faces(list, names);
}

MetFaces searched_faces(const Mesh& mesh) {
  MetFaces faces = unasked_faces(mesh);
  const SelfIntersections found = find_self_intersections(mesh);
  faces.pairs.insert(found.pairs.begin(), found.pairs.end());
  return faces;
}

std::map<Face, std::set<Face>> heirs_by_sides(const MetFaces& before, const MetFaces& after) {
  std::map<Face, std::set<Face>> heirs;
  for (const auto& [gone, corners] : before.corners) {
    if (after.corners.count(gone) > 0) continue;
    std::set<Face>& own = heirs[gone];
    for (const auto& [face, others] : before.corners)
      if (after.corners.count(face) > 0 && have_common_side(corners, others)) own.insert(face);
  }
  return heirs;
}

std::vector<FacePair> pairs_from_nowhere(const MetFaces& before, const MetFaces& after) {
  const std::map<Face, std::set<Face>> heirs = heirs_by_sides(before, after);
  const auto sources_of = [&](Face f) {
    std::vector<Face> sources{f};
    for (const auto& [gone, own] : heirs)
      if (own.count(f) > 0) sources.push_back(gone);
    return sources;
  };
  std::vector<FacePair> unknown;
  for (const FacePair& pair : after.pairs) {
    if (before.pairs.count(pair) > 0) continue;
    bool is_known = false;
    for (const Face a : sources_of(pair.first))
      for (const Face b : sources_of(pair.second))
        is_known = is_known || before.pairs.count({std::min(a, b), std::max(a, b)}) > 0;
    if (!is_known) unknown.push_back(pair);
  }
  return unknown;
}

}  // namespace ryosen::test
