// Where collapses put points on flat and straight parts, and that values are those of the place.
#include <gtest/gtest.h>

#include "core/algo/simplify/quadric.h"
#include "tests/support/core/simplified.h"
#include "tests/support/core/valued_sheet.h"

namespace ryosen::test {
namespace {

TEST(SimplifyPlaces, values_at_boundaries_and_seams_are_those_of_the_place) {
  constexpr double across = 100 * 4e-15;  // of rounding, where values lie beyond the seam
  for (const char* const boundary : {"weighted", "free", "locked"})
    for (const char* const words : {" faces=100", " faces=20", " faces=9", " faces=100 effort=0", " faces=60 effort=2"})
      for (const double seam : {no_seam, 0.5}) {
        const std::string line = "boundary=" + std::string(boundary) + words;
        Mesh mesh = valued_sheet(20, seam, some_turn());
        ASSERT_GT(simplified(mesh, line).changed, 0u);
        EXPECT_LT(worst_value(mesh, seam, some_turn()), across) << line << ", seam " << seam;
      }
}

// How far a point lies at most from the unit square in its plane, and the area.
struct Drift {
  double most = 0, area = 0;

  Drift(const Mesh& mesh, const glm::dmat3& turn) {
    for (Vertex v(0); v.index < mesh.vertex_slots(); ++v.index) {
      if (!mesh.is_alive(v)) continue;
      const glm::dvec3 p = glm::transpose(turn) * mesh.position(v);
      most = std::max({most, std::abs(p.z), -p.x, p.x - 1, -p.y, p.y - 1});
      if (mesh.is_boundary(v))
        most = std::max(most, std::min({std::abs(p.x), std::abs(p.x - 1), std::abs(p.y), std::abs(p.y - 1)}));
    }
    for (Face f(0); f.index < mesh.face_slots(); ++f.index) {
      if (!mesh.is_alive(f)) continue;
      glm::dvec3 sum(0);
      const glm::dvec3 first = mesh.position(mesh.from(mesh.halfedge(f)));
      for (const Halfedge h : loop(mesh, mesh.halfedge(f)))
        sum += glm::cross(mesh.position(mesh.from(h)) - first, mesh.position(mesh.to(h)) - first);
      area += glm::length(sum) / 2;
    }
  }
};

TEST(SimplifyPlaces, flat_parts_and_straight_boundaries_do_not_drift) {
  constexpr double ulps = 1e-15;
  for (const bool of_triangles : {true, false})
    for (const glm::dmat3& turn : {glm::dmat3(1), some_turn()})
      for (const char* const words : {"faces=2", "faces=30", "faces=2 effort=0", "faces=2 effort=2", "error=1e-12"}) {
        Mesh mesh = valued_sheet(30, no_seam, turn, of_triangles);
        simplified(mesh, words);
        const Drift drift(mesh, turn);
        EXPECT_LT(drift.most, ulps) << words << (of_triangles ? "" : " of squares");
        EXPECT_NEAR(drift.area, 1, 4 * ulps) << words << (of_triangles ? "" : " of squares");
        if (std::string_view(words).starts_with("faces=2")) {
          EXPECT_EQ(mesh.live().faces, 2u) << words;
        }
      }
}

}  // namespace
}  // namespace ryosen::test
