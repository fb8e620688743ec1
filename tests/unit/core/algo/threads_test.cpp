// What the algorithms on surfaces make does not depend on how many threads work at it.
#include <gtest/gtest.h>

#include <cmath>

#include "ryosen/base/parallel.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/run_algorithm.h"

namespace ryosen::test {
namespace {

// A torus whose points lie a little beside their places.
Mesh rough_torus(bool has_triangles) {
  Mesh mesh = made_by("torus segments=40");
  Journal journal;
  if (has_triangles) run_algorithm(mesh, journal, "subdivide scheme=midpoint");
  if (has_triangles) run_algorithm(mesh, journal, "remesh length=0.1 rounds=1");
  Edit edit(mesh, nullptr);
  Dice dice(17);
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i)
    if (const Vertex v(i); mesh.is_alive(v))
      edit.set_position(v, mesh.position(v) + 0.004 * glm::dvec3(dice.unit(), dice.unit(), dice.unit()));
  return mesh;
}

TEST(threads, make_no_difference_to_what_is_made) {
  const Mesh squares = rough_torus(false), triangles = rough_torus(true);
  std::size_t changed = 0;
  const std::vector<unsigned> few{1, 3}, many{1, 2, 3}, counts = is_long_run() ? many : few;
  for (const char* const line : {"simplify ratio=0.2",
                                 "simplify ratio=0.3 effort=0",
                                 "simplify ratio=0.2 effort=2",
                                 "simplify faces=0 max_turn=30 min_angle=5",
                                 "simplify faces=4 triangulate=on",
                                 "simplify faces=4 topology=change triangulate=on",
                                 "simplify ratio=0.5 no_self_intersections=on triangulate=on",
                                 "simplify error=0.5% triangulate=on",
                                 "subdivide scheme=loop",
                                 "subdivide scheme=catmull_clark steps=2",
                                 "subdivide scheme=midpoint",
                                 "subdivide scheme=sqrt3",
                                 "subdivide scheme=loop limit=on crease_angle=20",
                                 "smooth steps=4",
                                 "smooth steps=3 method=implicit weights=uniform",
                                 "smooth method=taubin steps=4",
                                 "smooth keep_volume=on steps=4",
                                 "remesh length=0.12",
                                 "remesh length=0.1 adaptive=on",
                                 "delaunay"})
    for (const Mesh* const mesh : {&squares, &triangles}) {
      std::optional<MeshColumns> first;
      for (const unsigned threads : counts) {
        const ThreadCount count(threads);
        Mesh made = *mesh;
        Journal journal;
        changed += run_algorithm(made, journal, line).changed > 0 ? 1 : 0;
        if (!first)
          first = made.columns();
        else
          EXPECT_EQ(made.columns(), *first) << line << " by " << threads << " threads";
      }
    }
  EXPECT_GE(changed, counts.size() * 30) << "few of them leave the mesh as it is";
}

}  // namespace
}  // namespace ryosen::test
