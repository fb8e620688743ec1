#include "core/ops/each.h"

#include <gtest/gtest.h>

#include "core/analysis/invariants.h"
#include "core/mesh/copies.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

void apply_line(Mesh& mesh, std::string_view op, std::vector<std::string_view> arguments) {
  const Parsed<AnyOp> parsed = parse_op(mesh, op, arguments);
  ASSERT_TRUE(parsed.op && check(mesh, *parsed.op).legal()) << op;
  Edit edit(mesh, nullptr);
  apply(edit, *parsed.op);
  edit.commit();
}

// Two bow-ties at 0 and 5, of each of which one face has gone and its copy of the point, 10 and 11, lies bare; and a
// vertex 12 apart. Welded into 11, 10 goes with it, and 12 comes to what is left of the point.
TEST(each, welds_on_into_the_point_of_bare_copies) {
  Mesh mesh = make_mesh({{0, 1, 2}, {0, 3, 4}, {5, 6, 7}, {5, 8, 9}}, 10);
  for (const std::string_view face : {"f1", "f3"}) apply_line(mesh, "delete_loop", {face});
  for (const std::string_view wire : {"10-3", "4-10", "3-4", "11-8", "9-11", "8-9"}) apply_line(mesh, "delete_edge", {wire});
  apply_line(mesh, "make_vertex", {"7,7,7"});
  ASSERT_TRUE(mesh.is_isolated(Vertex(10)) && same_point(mesh, Vertex(10), Vertex(0)));
  ASSERT_TRUE(mesh.is_isolated(Vertex(11)) && same_point(mesh, Vertex(11), Vertex(5)));
  const Element selected[] = {Vertex(10), Vertex(12), Vertex(11)};
  Edit edit(mesh, nullptr);
  Progress unheard;
  const EachResult result = apply_to_each(edit, Weld::info, selected, {}, false, unheard);
  edit.commit();
  EXPECT_EQ(result.error, NameError::none);
  EXPECT_EQ(result.done, 2u);
  EXPECT_FALSE(mesh.is_alive(Vertex(12)));
  EXPECT_TRUE(same_point(mesh, Vertex(0), Vertex(5)));
  const auto broken = check_invariants(mesh);
  EXPECT_FALSE(broken) << broken->sentence;
}

}  // namespace
}  // namespace ryosen
