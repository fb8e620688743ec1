// What a view is framed by where a mesh has isolated vertices, and what counts as framed.
#include "app/editor/camera/framing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "app/editor/commands/text/words.h"
#include "app/editor/session/session.h"
#include "app/editor/textbook/playing.h"
#include "ryosen/indexed/from_indexed.h"
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

TEST(framing, keeps_off_what_covers_the_view_and_fills_the_rest) {
  const Mesh mesh = triangle_with({0.1, 0.2, 0.9});
  for (const bool ortho : {false, true})
    for (const Covered& covered : {Covered{0, 290, 50, {}}, Covered{150, 0, 0, {}}, Covered{100, 200, 120, {}}}) {
      const Camera camera = framing({&mesh}, with_ortho({}, ortho), view, covered);
      glm::dvec2 low(1e9), high(-1e9);
      for (const glm::dvec3& place : mesh.positions()) {
        const auto at = project(camera, view, place);
        ASSERT_TRUE(at);
        low = glm::min(low, at->pixel);
        high = glm::max(high, at->pixel);
      }
      const glm::dvec2 from(covered.left, covered.above), to(view.width - covered.right, view.height);
      EXPECT_TRUE(low.x >= from.x && low.y >= from.y && high.x <= to.x && high.y <= to.y) << ortho << covered.right;
      EXPECT_GT(std::max((high.x - low.x) / (to.x - from.x), (high.y - low.y) / (to.y - from.y)), 0.87) << ortho;
      EXPECT_TRUE(shows_all(camera, view, covered, mesh.positions()));
    }
  const Camera whole = framing({&mesh}, {}, view);
  EXPECT_FALSE(shows_all(whole, view, {0, 290, 0, {}}, mesh.positions()));
  EXPECT_EQ(framing({&mesh}, {}, view, {300, 300, 0, {}}), whole) << "hardly anything would be left";
}

// The axes ask for more than a panel has left: nothing goes below the panel to get out of their way.
TEST(framing, keeps_off_a_strip_though_the_axes_leave_hardly_any_room_beside_it) {
  constexpr Size narrow{400, 640};
  IndexedMesh source;
  source.positions = {{-0.1, -1, 0}, {0.1, -1, 0}, {0.1, 1, 0}, {-0.1, 1, 0}};
  source.corners = {0, 1, 2, 3};
  source.face_offsets = {0, 4};
  const Mesh mesh = from_indexed(source);
  Covered covered{250, 0, 0, room_of_axes(narrow, 1)};
  ASSERT_TRUE(covered.corner);
  const Camera camera = framing({&mesh}, {}, narrow, covered);
  for (const glm::dvec3& place : mesh.positions()) EXPECT_GT(project(camera, narrow, place)->pixel.x, covered.left);
}

TEST(framing, shows_all_where_nothing_of_it_lies_below_what_is_kept_off) {
  const Mesh mesh = triangle_with({0.1, 0.2, 0});
  const Camera camera = framing({&mesh}, {}, view);
  EXPECT_TRUE(shows_all(camera, view, {}, mesh.positions()));
  EXPECT_FALSE(shows_all(camera, view, {0, 0, 200, {}}, mesh.positions())) << "below a caption";
  EXPECT_TRUE(shows_all(camera, view, {300, 300, 0, {}}, mesh.positions())) << "no camera can keep off these";
}

TEST(framing, named_views_show_what_all_is_framed_by) {
  Session playing(std::make_unique<Document>());
  ASSERT_TRUE(playing.run("steps script cube").done() && playing.run("steps at 1").done());
  ASSERT_FALSE(playing.shown.player()->places_at_end.empty());
  ASSERT_TRUE(playing.run("view front").done());
  EXPECT_TRUE(shows_all(playing.view.camera, playing.view.size, playing.framing.covered(),
                        playing.shown.player()->places_at_end));

  const test::TemporaryFolder folder;
  Session far_off(std::make_unique<Document>());
  const std::string file = file_argument(folder.at("far.obj"));
  for (const std::string& line : {std::string("cube"), std::string("translate by=9,0,0"), "save " + file})
    ASSERT_TRUE(far_off.run(line).done()) << line;
  Session session(std::move(Document::open(test::asset("cube.obj"))).value());
  ASSERT_TRUE(session.run("compare " + file).done());
  ASSERT_TRUE(session.run("view front").done());
  ASSERT_TRUE(session.compared());
  EXPECT_TRUE(
      shows_all(session.view.camera, session.compared()->state().size, {}, session.compared()->mesh().positions()));
}

TEST(framing, goes_out_of_the_way_of_the_axes_where_something_would_lie_under_them) {
  for (const Size size : {Size{748, 754}, Size{620, 640}}) {
    Session session(std::move(Document::open(test::asset("isolated_vertex.obj"))).value());
    session.view.size = size;
    const PixelRect corner = *room_of_axes(size, 1);
    const auto is_under = [&] {
      const auto at = project(session.view.camera, size, session.mesh().position(Vertex(3)));
      const glm::dvec2 middle(corner.x0 + 0.5 * corner.width(), 0.5 * corner.height());
      return at && glm::length(at->pixel - middle) < 0.5 * corner.width();
    };
    session.framing.frame_all();
    EXPECT_TRUE(is_under());
    session.view.shows_axes = true;
    session.framing.frame_all();
    EXPECT_FALSE(is_under()) << size.width;
    ASSERT_TRUE(session.run("view front").done());
    EXPECT_FALSE(is_under()) << size.width;
    session.set_document(std::move(Document::open(test::asset("isolated_vertex.obj"))).value());
    EXPECT_FALSE(is_under()) << size.width;
  }
  Session session(std::move(Document::open(test::asset("torus.off"))).value());
  const Camera before = session.view.camera;
  session.view.shows_axes = true;
  session.framing.frame_all();
  EXPECT_LT(glm::length(session.view.camera.eye - before.eye), 1e-9) << "nothing lies there";
}

TEST(framing, counts_until_the_camera_moves) {
  Session session(std::move(Document::open(test::asset("cube.obj"))).value());
  EXPECT_TRUE(session.framing.is_framed());
  ASSERT_TRUE(session.run("wheel 1 300,200").done());
  EXPECT_FALSE(session.framing.is_framed());
  session.framing.frame_all();
  EXPECT_TRUE(session.framing.is_framed());
}

}  // namespace
}  // namespace ryosen
