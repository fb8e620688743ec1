// A small solid is first seen as one, and all else from where it always is.
#include "app/editor/camera/framing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "app/editor/session/session.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

std::unique_ptr<Document> seen_first(const char* name) { return std::move(Document::open(test::asset(name))).value(); }

TEST(first_camera, is_the_usual_one_where_more_than_one_side_is_seen_or_there_is_no_solid) {
  for (const char* const name : {"cube.obj", "torus.off", "ball.off", "klein_bottle.off", "stanford_bunny.obj",
                                 "two_quads.obj", "isolated_vertex.obj", "fin.obj", "moebius.off"})
    EXPECT_EQ(first_camera_of(seen_first(name)->mesh()), first_camera()) << name;
  EXPECT_EQ(first_camera_of(Mesh()), first_camera());
  Session session(std::make_unique<Document>());
  ASSERT_TRUE(session.run("cube").done() && session.run("scale 0.03 axis=0,0,1").done());
  EXPECT_EQ(first_camera_of(session.mesh()), first_camera()) << "a plate is one side above all";
}

TEST(first_camera, turns_where_a_solid_would_look_like_a_face) {
  Session session(seen_first("tetrahedron.off"));
  const Camera usual = session.view.camera;
  session.frontend.turns_to_solids = true;
  session.set_document(seen_first("tetrahedron.off"));
  EXPECT_NE(session.view.camera, usual);
  EXPECT_TRUE(session.framing.is_framed());
  const glm::dvec3 to_eye = -axes(session.view.camera).forward;
  EXPECT_GT(glm::dot(to_eye, -axes(usual).forward), 0.5) << "as little as it takes";
  EXPECT_GT(glm::dot(to_eye, glm::dvec3(1)), 0.2) << "the slanted side is seen,";
  EXPECT_LT(std::min({to_eye.x, to_eye.y, to_eye.z}), -0.2) << "and one of those in the planes of the axes";
}

}  // namespace
}  // namespace ryosen
