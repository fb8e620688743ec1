// Checks of a mesh that was kept near its input, and meshes to keep so.
#pragma once

#include <string>
#include <vector>

#include "ryosen/mesh/mesh.h"

namespace ryosen::test {

// The diagonal of the box around what is measured.
double size_of_surface(const Mesh& mesh);
// No point of either surface is farther from the other one, by dense samples and by the bound of surface_distance().
void expect_kept_within(const Mesh& before, const Mesh& after, double most, const std::string& name);

Mesh cut_in_triangles(Mesh mesh);
// Each vertex without copies moved by less than that along each axis.
Mesh shaken(Mesh mesh, double by, std::uint64_t seed);
Mesh stretched(Mesh mesh, const glm::dvec3& by);
// A mesh and its copy, that far away.
Mesh doubled(const Mesh& mesh, const glm::dvec3& apart);

struct NamedMesh {
  std::string name;
  Mesh mesh;
};
// Thirty meshes of triangles, five of each kind: smooth, with sharp edges, in sheets, torn, in parts, and of needles.
std::vector<NamedMesh> meshes_to_keep();

}  // namespace ryosen::test
