// Two triangles with two common edges: one of them is divided first, since the middles of these edges are joined once.
#include <gtest/gtest.h>

#include <string>

#include "ryosen/algo/subdivide/subdivide.h"
#include "ryosen/mesh/invariants.h"
#include "tests/support/core/shapes.h"

namespace ryosen::test {
namespace {

struct Folded {
  const char* name;
  Polygons faces;
  std::size_t cut;
};

const Folded folded[] = {
    {"a pillow", {{0, 1, 2}, {2, 1, 0}}, 1},
    {"two pillows at a point", {{0, 1, 2}, {2, 1, 0}, {0, 3, 4}, {4, 3, 0}}, 2},
    {"a pair on an edge of a tetrahedron", {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {0, 2, 3}, {0, 1, 4}, {4, 1, 0}}, 1},
    {"a pair on a boundary edge", {{0, 1, 2}, {1, 0, 3}, {0, 1, 3}}, 1},
    {"a tetrahedron", tetrahedron(), 0},
};

TEST(folded_triangles, stay_a_sound_mesh_when_they_are_divided) {
  for (const Folded& each : folded)
    for (const subdivide::Scheme scheme : {subdivide::Scheme::loop, subdivide::Scheme::sqrt3})
      for (const std::size_t steps : {1u, 2u}) {
        SCOPED_TRACE(each.name + std::string(scheme == subdivide::Scheme::loop ? ", loop, " : ", sqrt3, ") +
                     std::to_string(steps));
        Progress unheard;
        subdivide::Subdivided made =
            subdivide::subdivided(make_mesh(each.faces), {.scheme = scheme, .steps = steps}, unheard);
        ASSERT_FALSE(made.fault);
        EXPECT_EQ(made.cut_faces, each.cut);
        const Mesh finer(std::move(made.columns));
        const auto broken = check_invariants(finer);
        EXPECT_FALSE(broken) << broken->sentence;
        const std::size_t once = scheme == subdivide::Scheme::loop ? 4 : 3;
        EXPECT_EQ(finer.live().faces, (each.faces.size() + 2 * each.cut) * once * (steps == 2 ? once : 1));
      }
}

}  // namespace
}  // namespace ryosen::test
