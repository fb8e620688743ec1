// Values of operators that are dragged by hand.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <limits>

#include "ryosen/mesh/circulate.h"
#include "ryosen/ops/all.h"
#include "tests/support/core/asset_mesh.h"

namespace ryosen::test {
namespace {

// Each operator of which a value can be dragged, on a cube.
std::vector<AnyOp> dragged_ops(const Mesh& cube) {
  std::vector<AnyOp> ops;
  const OpTarget target{.halfedge = cube.halfedge(Face(0)), .vertex = Vertex(0), .face = Face(0)};
  for (const OpInfo& info : all_ops())
    if (dragged_place(info.line)) ops.push_back(op_at(cube, info.id, target));
  return ops;
}

const void* values_of(const AnyOp& op) {
  return std::visit([](const auto& o) -> const void* { return &o; }, op);
}

TEST(drag, of_a_value_gives_the_operator_that_its_line_says) {
  const Mesh mesh = asset_mesh("cube.obj");
  const std::vector<AnyOp> ops = dragged_ops(mesh);
  EXPECT_EQ(ops.size(), 3u);
  for (const AnyOp& op : ops)
    for (const glm::dvec3& value : {glm::dvec3(0.25, -1, 3), glm::dvec3(0), glm::dvec3(1e-300, 1e300, 0.1)}) {
      const AnyOp moved = dragged(dragged(op, {7, 7, 7}), value);
      const std::string line = command_of(mesh, moved);
      const ParsedOp parsed = parse_line(mesh, line);
      ASSERT_TRUE(parsed.op) << line << ": " << parsed.sentence.en;
      EXPECT_TRUE(*parsed.op == moved) << line;
      EXPECT_FALSE(fault_of_values(mesh, moved)) << line;
    }
}

TEST(drag, moves_what_the_operator_makes) {
  for (const AnyOp& op : dragged_ops(asset_mesh("cube.obj"))) {
    const std::string line = command_of(asset_mesh("cube.obj"), op);
    const OpDrag& drag = *dragged_place(info_of(op).line)->drag;
    const auto middle_of_moved = [&](const AnyOp& done, const glm::dvec3& from) {
      Mesh mesh = asset_mesh("cube.obj");
      const ColumnLengths before = mesh.lengths();
      Edit edit(mesh, nullptr);
      apply(edit, done);
      edit.commit();
      std::vector<Vertex> points;
      for (const Element& e : drag.moved(mesh, values_of(done), before))
        if (e.kind == Element::Kind::vertex)
          points.push_back(e.vertex());
        else if (e.kind == Element::Kind::edge)
          points.insert(points.end(), {ends(mesh, e.edge()).first, ends(mesh, e.edge()).second});
        else
          for (const Vertex v : vertices_around(mesh, e.face())) points.push_back(v);
      EXPECT_FALSE(points.empty()) << line;
      glm::dvec3 sum(0);
      for (const Vertex v : points) sum += mesh.position(v) - from;
      return sum / static_cast<double>(points.size());
    };
    const Mesh mesh = asset_mesh("cube.obj");
    const glm::dvec3 from = drag.from ? drag.from(mesh, values_of(op)) : glm::dvec3(0), way(0.5, 0.25, -2);
    const glm::dvec3 unmoved = middle_of_moved(dragged(op, from), from),
                     moved = middle_of_moved(dragged(op, from + way), from);
    EXPECT_LT(glm::distance(moved - unmoved, way), 1e-12) << line;
  }
}

TEST(drag, to_no_finite_place_is_a_fault_as_in_a_line) {
  const Mesh mesh = asset_mesh("cube.obj");
  for (const AnyOp& op : dragged_ops(mesh)) {
    const AnyOp far = dragged(op, {std::numeric_limits<double>::infinity(), 0, 0});
    const auto fault = fault_of_values(mesh, far);
    ASSERT_TRUE(fault) << command_of(mesh, far);
    EXPECT_NE(fault->en.find("finite"), std::string::npos) << fault->en;
  }
}

}  // namespace
}  // namespace ryosen::test
