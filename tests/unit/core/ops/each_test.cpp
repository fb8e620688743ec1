#include "ryosen/ops/each.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "ryosen/analysis/figures.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/invariants.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

void apply_line(Mesh& mesh, std::string_view op, std::vector<std::string_view> arguments) {
  const ParsedOp parsed = parse_op(mesh, op, op_arguments(arguments));
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
  for (const std::string_view wire : {"10-3", "4-10", "3-4", "11-8", "9-11", "8-9"})
    apply_line(mesh, "delete_edge", {wire});
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

// A patch of quads on a torus comes together in one point, whichever of its vertices is the last: nothing is pinched.
TEST(each, welds_a_patch_into_one_point_of_a_whole_surface) {
  constexpr std::uint32_t rows = 8, columns = 9;
  for (const std::uint32_t width : {1u, 2u, 3u})
    for (std::uint32_t last = 0; last <= 2 * width + 1; ++last) {
      SCOPED_TRACE(std::to_string(width) + " quads, last " + std::to_string(last));
      const auto id = [&](std::uint32_t i, std::uint32_t j) { return i % rows * columns + j % columns; };
      Polygons quads;
      for (std::uint32_t i = 0; i < rows; ++i)
        for (std::uint32_t j = 0; j < columns; ++j)
          quads.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)});
      Mesh mesh = make_mesh(quads, rows * columns);
      std::vector<Element> patch;
      for (std::uint32_t i = 0; i <= width; ++i)
        for (std::uint32_t j = 0; j <= 2; ++j) patch.emplace_back(Vertex(i * columns + j));
      std::swap(patch[last], patch.back());
      Edit edit(mesh, nullptr);
      Progress unheard;
      const EachResult result = apply_to_each(edit, Weld::info, patch, {}, false, unheard);
      edit.commit();
      EXPECT_EQ(result.done, patch.size() - 1);
      EXPECT_EQ(result.refusals(), 0u);
      const Figures figures = compute_figures(mesh);
      EXPECT_TRUE(figures.manifold && figures.closed);
      EXPECT_EQ(figures.euler_characteristic, 0);
      EXPECT_EQ(mesh.live().vertices, rows * columns + 1 - patch.size());
      EXPECT_EQ(mesh.live().faces, rows * columns - 2 * width);
      const auto broken = check_invariants(mesh);
      EXPECT_FALSE(broken) << broken->sentence;
    }
}

// An edge goes from its lower point, a halfedge in its own direction.
TEST(each, splits_in_the_direction_of_the_element) {
  const Mesh start = make_mesh(tetrahedron());
  const Halfedge h = sheets_between(start, Vertex(1), Vertex(2)).front();
  for (const Element& e : {Element(edge(h)), Element(h), Element(twin(h))}) {
    Mesh mesh = start;
    Edit edit(mesh, nullptr);
    Progress unheard;
    const std::string_view quarter[] = {"0.25"};
    const EachResult result = apply_to_each(edit, SplitEdge::info, {&e, 1}, quarter, false, unheard);
    edit.commit();
    ASSERT_EQ(result.done, 1u);
    const glm::dvec3 a = start.position(Vertex(1)), b = start.position(Vertex(2)), p = mesh.position(Vertex(4));
    EXPECT_NEAR(glm::distance(p, e == Element(twin(h)) ? b : a), glm::distance(a, b) / 4, 1e-12);
  }
}

TEST(each, says_that_an_element_of_another_kind_is_not_welded) {
  Mesh mesh = make_mesh(two_quads());
  const Halfedge h = sheets_between(mesh, Vertex(0), Vertex(1)).front();
  const Element into_edge[] = {Vertex(2), edge(h)}, into_vertex[] = {edge(h), Vertex(2)};
  const auto sentence = [&](std::span<const Element> selected) {
    Edit edit(mesh, nullptr);
    Progress unheard;
    const EachResult result = apply_to_each(edit, Weld::info, selected, {}, false, unheard);
    EXPECT_EQ(result.error, NameError::malformed);
    return result.sentence.en;
  };
  EXPECT_EQ(sentence(into_edge), "'v2' is not a name; expected A-B, A-B@f5, h12 or e6");
  EXPECT_EQ(sentence(into_vertex), "'h" + std::to_string(h.index) + "' is not a name; expected v7 or v7@f5");
}

}  // namespace
}  // namespace ryosen
