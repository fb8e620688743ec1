// The points of all meshes there are that span space, for the hulls of peers.
#pragma once

#include <cmath>
#include <filesystem>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "ryosen/hull/convex_hull.h"
#include "ryosen/io/formats.h"

namespace ryosen::test {

struct PointSet {
  std::string name;
  std::vector<glm::dvec3> points;
};

inline std::vector<PointSet> solid_point_sets() {
  std::vector<PointSet> sets;
  for (const char* const folder : {RYOSEN_SOURCE_DIR "/assets", RYOSEN_SHARED_DIR "/meshes"}) {
    if (!std::filesystem::is_directory(folder)) continue;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
      if (!entry.is_regular_file() || entry.file_size() > 6000000) continue;
      Result<MeshFile> file = read_mesh_file(entry.path());
      if (!file) continue;
      std::vector<glm::dvec3>& points = file->mesh.positions;
      std::erase_if(points, [](const glm::dvec3& p) { return !std::isfinite(p.x + p.y + p.z); });
      if (convex_hull(points).dimension == 3) sets.push_back({entry.path().string(), std::move(points)});
    }
  }
  return sets;
}

}  // namespace ryosen::test
