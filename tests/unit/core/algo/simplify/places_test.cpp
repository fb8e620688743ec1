// Where collapses put points on flat and straight parts, and that values are those of the place.
#include <gtest/gtest.h>

#include "ryosen/algo/simplify/quadric.h"
#include "tests/support/core/simplified.h"
#include "tests/support/core/valued_sheet.h"

namespace ryosen::test {
namespace {

TEST(SimplifyPlaces, values_at_boundaries_and_seams_are_those_of_the_place) {
  constexpr double across = 100 * 4e-15;  // of rounding, where values lie beyond the seam
  // Where the boundary is locked most goals are out of reach, and at last weighed seams go, too.
  for (const char* const boundary : {"weighted", "free", "locked seams=keep"})
    for (const char* const words : {" faces=100", " faces=20", " faces=9", " faces=100 effort=0", " faces=60 effort=2"})
      for (const double seam : {no_seam, 0.5}) {
        const std::string line = "boundary=" + std::string(boundary) + words;
        Mesh mesh = valued_sheet(20, seam, some_turn());
        ASSERT_GT(simplified(mesh, line).changed, 0u);
        EXPECT_LT(worst_value(mesh, seam, some_turn()), across) << line << ", seam " << seam;
      }
  Mesh locked = valued_sheet(20, 0.5, some_turn());
  ASSERT_GT(simplified(locked, "boundary=locked faces=110").changed, 0u);
  EXPECT_LT(worst_value(locked, 0.5, some_turn()), across) << "within reach of the goal";
}

// How far texture coordinates lie at most from the places of their points, seen from above.
double worst_from_above(const Mesh& mesh, double seam) {
  const CornerAttribute texture = corner_attributes(mesh).front();
  double worst = 0;
  for (Halfedge h(0); h.index < mesh.halfedge_slots(); ++h.index) {
    if (!mesh.is_alive(h) || mesh.is_outside(h)) continue;
    double middle = 0;
    for (const Halfedge corner : loop(mesh, h)) middle += mesh.position(mesh.from(corner)).x / 3;
    if (std::abs(middle - seam) < 1e-9) continue;  // a needle along the seam may be of either side
    const auto value = attribute_value<glm::dvec3>(mesh.attributes()[texture.pool_column],
                                                   mesh.attributes()[texture.index_column].data[h.index]);
    const glm::dvec3 p = mesh.position(mesh.from(h));
    worst = std::max(worst, glm::distance(glm::dvec2(value), glm::dvec2(p.x + (middle > seam ? across_seam : 0), p.y)));
  }
  return worst;
}

// A seam that a retreating boundary has laid open ends there: what lies beyond it does not come along.
TEST(SimplifyPlaces, values_at_the_ends_of_seams_stay_at_a_free_boundary) {
  constexpr double seam = 0.5, most = 0.05;  // an edge at most: what a place is beside the surface counts, too
  for (const double waves : {3.0, 5.0, 7.0, 9.0})
    for (const char* const words : {"faces=120", "faces=60", "faces=60 effort=0", "faces=60 effort=2"}) {
      Mesh mesh = valued_sheet(20, seam);
      Edit edit(mesh, nullptr);
      for (Vertex v(0); v.index < mesh.vertex_slots(); ++v.index) {
        const glm::dvec3 p = mesh.position(v);
        edit.set_position(v, {p.x, p.y, 0.1 * std::sin(waves * p.x) * std::cos((waves - 2) * p.y)});
      }
      edit.commit();
      ASSERT_GT(simplified(mesh, std::string("boundary=free ") + words).changed, 0u);
      EXPECT_LT(worst_from_above(mesh, seam), most) << words << ", " << waves;
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
