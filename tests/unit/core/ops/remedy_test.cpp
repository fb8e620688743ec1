#include "core/ops/remedy.h"

#include <gtest/gtest.h>

#include "core/mesh/circulate.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

void expect_remedy_works(Polygons faces, const std::string& line) {
  Mesh mesh = make_mesh(faces);
  const MeshColumns before = mesh.columns();
  const Parsed<AnyOp> op = parse_line(mesh, line);
  ASSERT_TRUE(op.op);
  ASSERT_FALSE(check(mesh, *op.op).legal());
  const std::vector<std::string> remedy = find_remedy(mesh, *op.op);
  EXPECT_EQ(mesh.columns(), before);
  ASSERT_FALSE(remedy.empty()) << line;
  for (const std::string& step : remedy) {
    const Parsed<AnyOp> parsed = parse_line(mesh, step);
    ASSERT_TRUE(parsed.op) << step;
    Edit edit(mesh, nullptr);
    apply(edit, *parsed.op);
    edit.commit();
  }
  const Parsed<AnyOp> again = parse_line(mesh, line);
  ASSERT_TRUE(again.op);
  EXPECT_TRUE(check(mesh, *again.op).legal()) << line << " after " << remedy[0];
}

TEST(remedy, makes_the_operator_legal) {
  expect_remedy_works(tetrahedron(), "collapse 0-1");
  expect_remedy_works(tetrahedron(), "swap 0-1");
  expect_remedy_works({{0, 1, 2}}, "collapse 0-1");
  expect_remedy_works({{0, 1, 2}, {0, 2, 1}}, "collapse 0-1");
  expect_remedy_works({{0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}, "collapse 0-1");
  expect_remedy_works({{0, 1, 2}, {0, 1, 3}}, "swap 0-1@f0");
}

TEST(remedy, there_is_none_on_the_boundary_of_a_lone_triangle) {
  Mesh mesh = make_mesh({{0, 1, 2}});
  EXPECT_TRUE(find_remedy(mesh, SwapEdge{find_halfedge(mesh, Vertex(0), Vertex(1))}).empty());
}

}  // namespace
}  // namespace ryosen
