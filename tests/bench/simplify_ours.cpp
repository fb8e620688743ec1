// What Ryosen makes of a mesh, for tests/bench/quality.sh; beside simplify_peers.cpp.
//   simplify_ours INPUT.off OUTPUT.off FACES [EFFORT [COLOUR_WEIGHT]]
// Prints the seconds that it took without reading and writing.
#include <chrono>
#include <cstdlib>

#include "ryosen/algo/simplify/simplifier.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/mesh/attribute.h"
#include "tests/bench/plain_off.h"

namespace {

using namespace ryosen;
using Clock = std::chrono::steady_clock;

Mesh mesh_of(const plain::Triangles& triangles) {
  IndexedMesh source;
  for (const auto& p : triangles.points) source.positions.emplace_back(p[0], p[1], p[2]);
  for (const auto& colour : triangles.colours) source.vertex_colours.emplace_back(colour[0], colour[1], colour[2], 1);
  for (const auto& f : triangles.faces) {
    source.corners.insert(source.corners.end(), f.begin(), f.end());
    source.face_offsets.push_back(static_cast<std::uint32_t>(source.corners.size()));
  }
  return from_indexed(std::move(source));
}

plain::Triangles triangles_of(const Mesh& mesh) {
  plain::Triangles triangles;
  for (const glm::dvec3& p : mesh.positions()) triangles.points.push_back({p.x, p.y, p.z});
  if (const AttributeColumn* const colours = find_column(mesh, attribute_names::colour))
    for (const auto& colour : attribute_values<glm::dvec4>(*colours))
      triangles.colours.push_back({colour.x, colour.y, colour.z});
  for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
    if (!mesh.is_alive(Face(i))) continue;
    const Halfedge h = mesh.halfedge(Face(i));
    const auto number = [&](Vertex v) { return mesh.copy_point(v).index; };
    triangles.faces.push_back({number(mesh.from(h)), number(mesh.to(h)), number(mesh.from(mesh.prev(h)))});
  }
  return triangles;
}

}  // namespace

int main(int count, char** words) {
  if (count < 4 || count > 6) return 2;
  const Mesh mesh = mesh_of(plain::read_off(words[1]));
  SimplifyGoal goal;
  goal.faces = static_cast<std::size_t>(std::atoll(words[3]));
  CollapseLimits limits;
  if (count >= 6) limits.colour_weight = std::atof(words[5]);
  if (count >= 5) goal.effort = static_cast<unsigned>(std::atoi(words[4]));
  const Clock::time_point begin = Clock::now();
  Mesh work = mesh;
  Progress unheard;
  Simplifier(work, limits, goal, nullptr, &mesh).run(unheard);
  const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  plain::write_off(words[2], triangles_of(work));
  std::printf("%.4f\n", seconds);
}
