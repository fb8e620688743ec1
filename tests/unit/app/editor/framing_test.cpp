// What a view is framed by where a mesh has isolated vertices, and what counts as framed.
#include "app/editor/framing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "app/editor/session.h"
#include "core/indexed/from_indexed.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

constexpr Size view{640, 480};

// A triangle with the diagonal 1 around the origin, and a vertex without edges.
Mesh triangle_with(const glm::dvec3& isolated) {
  IndexedMesh source;
  source.positions = {{-0.4, -0.3, 0}, {0.4, -0.3, 0}, {0.4, 0.3, 0}, isolated};
  source.corners = {0, 1, 2};
  source.face_offsets = {0, 3};
  return from_indexed(source);
}

bool is_seen(const glm::dvec3& place, const Camera& camera) {
  const auto seen = project(camera, view, place);
  return seen && seen->pixel.x >= 0 && seen->pixel.y >= 0 && seen->pixel.x <= view.width &&
         seen->pixel.y <= view.height;
}

double width_of_triangle_px(const Camera& camera) {
  return std::abs(project(camera, view, {0.4, -0.3, 0})->pixel.x - project(camera, view, {-0.4, -0.3, 0})->pixel.x);
}

TEST(framing, shows_isolated_vertices_that_are_not_far) {
  for (const glm::dvec3& place : {glm::dvec3(0, 0, 1), glm::dvec3(0, 3.9, 0), glm::dvec3(-3.9, 0, 0)}) {
    const Mesh mesh = triangle_with(place);
    const Camera camera = framing({&mesh}, {}, view);
    for (const glm::dvec3& each : mesh.positions()) EXPECT_TRUE(is_seen(each, camera)) << place.x << ' ' << place.y;
    EXPECT_GT(width_of_triangle_px(camera), 0.1 * view.width) << "and the mesh is no dot";
  }
}

TEST(framing, leaves_out_those_that_are_far_or_have_no_place) {
  const Mesh alone = triangle_with({0, 0, 0});
  for (const double far : {4.1, 1e6, 1e300, std::numeric_limits<double>::infinity(), std::nan("")}) {
    const Mesh mesh = triangle_with({0, far, 0});
    EXPECT_EQ(framing({&mesh}, {}, view), framing({&alone}, {}, view)) << far;
  }
}

TEST(framing, shows_isolated_vertices_where_there_is_nothing_else) {
  IndexedMesh source;
  source.positions = {{5, 5, 5}, {1000, 5, 5}};
  source.face_offsets = {0};
  const Mesh mesh = from_indexed(source);
  const Camera camera = framing({&mesh}, {}, view);
  for (const glm::dvec3& each : mesh.positions()) EXPECT_TRUE(is_seen(each, camera));
}

TEST(framing, counts_until_the_camera_moves) {
  Session session(std::move(Document::open(test::asset("cube.obj"))).value());
  EXPECT_TRUE(session.is_framed());
  ASSERT_TRUE(session.run("wheel 1 300,200").done());
  EXPECT_FALSE(session.is_framed());
  session.frame_all();
  EXPECT_TRUE(session.is_framed());
}

}  // namespace
}  // namespace ryosen
