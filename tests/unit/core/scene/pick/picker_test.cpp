#include "ryosen/scene/pick/picker.h"

#include <gtest/gtest.h>

#include "ryosen/mesh/edit.h"
#include "ryosen/mesh/journal.h"
#include "ryosen/ops/all.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

// Looks along -Z at the square from (0, 0) to (1, 1), 100 pixels each way.
constexpr Size picture{100, 100};
Camera square_camera() {
  Camera camera;
  camera.eye = {0.5, 0.5, 5};
  camera.target = {0.5, 0.5, 0};
  camera.up = {0, 1, 0};
  camera.ortho_height = 1.0;
  return camera;
}

void run(Mesh& mesh, Journal& journal, Picker& picker, const std::string& line) {
  const ParsedOp parsed = parse_line(mesh, line);
  ASSERT_TRUE(parsed.op) << line;
  ASSERT_TRUE(check(mesh, *parsed.op).legal()) << line;
  {
    Edit edit(mesh, &journal);
    apply(edit, *parsed.op);
    edit.commit();
  }
  picker.update(mesh, touched_elements(mesh, journal, journal.position() - 1));
}

Element picked(const Mesh& mesh, Picker& picker, glm::dvec2 pixel, PickMode mode) {
  const auto found = picker.pick(mesh, square_camera(), picture, pixel, mode);
  return found ? found->element : Element();
}

TEST(picker, finds_wires_and_their_ends_and_follows_them) {
  Mesh mesh;
  Journal journal;
  Picker picker(mesh);
  EXPECT_FALSE(picker.pick(mesh, square_camera(), picture, {50, 50}, PickMode::edge));  // builds the tree
  for (const char* line : {"make_vertex 0.2,0.5,0", "make_vertex 0.8,0.5,0", "make_edge v0 v1"})
    run(mesh, journal, picker, line);
  EXPECT_EQ(picked(mesh, picker, {50, 52}, PickMode::edge), Element(Edge(0)));
  EXPECT_EQ(picked(mesh, picker, {20, 50}, PickMode::vertex), Element(Vertex(0)));
  EXPECT_FALSE(picker.pick(mesh, square_camera(), picture, {50, 70}, PickMode::edge));

  run(mesh, journal, picker, "move_vertex v0 0.2,0.3,0");
  run(mesh, journal, picker, "move_vertex v1 0.8,0.3,0");
  EXPECT_EQ(picked(mesh, picker, {50, 70}, PickMode::edge), Element(Edge(0)));
  EXPECT_FALSE(picker.pick(mesh, square_camera(), picture, {50, 50}, PickMode::edge));

  run(mesh, journal, picker, "delete_edge 0-1");
  EXPECT_FALSE(picker.pick(mesh, square_camera(), picture, {50, 70}, PickMode::edge));
  EXPECT_EQ(picked(mesh, picker, {20, 70}, PickMode::vertex), Element(Vertex(0)));
}

TEST(picker, finds_the_wires_that_a_face_leaves_until_it_comes_back) {
  IndexedMesh square = indexed({{0, 1, 2, 3}});
  square.positions = {{0.1, 0.1, 0}, {0.9, 0.1, 0}, {0.9, 0.9, 0}, {0.1, 0.9, 0}};
  Mesh mesh = from_indexed(std::move(square));
  Journal journal;
  Picker picker(mesh);
  EXPECT_EQ(picked(mesh, picker, {50, 50}, PickMode::face), Element(Face(0)));
  run(mesh, journal, picker, "delete_loop f0");
  EXPECT_FALSE(picker.pick(mesh, square_camera(), picture, {50, 50}, PickMode::face));
  const Element bottom = picked(mesh, picker, {50, 90}, PickMode::edge);
  EXPECT_EQ(bottom, Element(edge(find_halfedge(mesh, Vertex(0), Vertex(1)))));
  Picker built_anew(mesh);
  EXPECT_EQ(picked(mesh, built_anew, {50, 90}, PickMode::edge), bottom);

  journal.undo(mesh);
  picker.update(mesh, touched_elements(mesh, journal, journal.position()));
  EXPECT_EQ(picked(mesh, picker, {50, 50}, PickMode::face), Element(Face(0)));
  EXPECT_EQ(picked(mesh, picker, {50, 90}, PickMode::edge), bottom);
}

}  // namespace
}  // namespace ryosen
