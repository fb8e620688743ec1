// Attribute values of elements that operators divide.
#include <gtest/gtest.h>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/edit.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/ops/all.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/random_edits.h"
#include "tests/support/core/random_ops.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

template <class T, class Elements>
T total_of(const Mesh& mesh, std::string_view name, const Elements& elements) {
  T total{};
  for (const auto element : elements) total += attribute_value<T>(*find_column(mesh, name), element.index);
  return total;
}

struct Totals {
  std::int64_t of_faces = 0, of_edges = 0;
  double area = 0, length = 0, of_vertices = 0;

  explicit Totals(const Mesh& mesh)
      : of_faces(total_of<std::int64_t>(mesh, "face.count", live_faces(mesh))),
        of_edges(total_of<std::int64_t>(mesh, "edge.count", live_edges(mesh))),
        area(total_of<double>(mesh, "face.area", live_faces(mesh))),
        length(total_of<double>(mesh, "edge.length", live_edges(mesh))),
        of_vertices(total_of<double>(mesh, "vertex.mass", live_vertices(mesh))) {}
};

template <class T>
void fill_at_random(Edit& edit, std::size_t attribute, std::uint32_t count, const auto& value) {
  for (std::uint32_t i = 0; i < count; ++i) edit.set_attribute(attribute, i, attribute_words<T>(value()));
}

void add_values(Mesh& mesh, Journal& journal, Dice& dice) {
  Edit edit(mesh, &journal);
  const auto whole = [&] { return static_cast<std::int64_t>(dice.below(2000)) - 1000; };
  const auto part = [&] { return dice.unit(); };
  const auto add = [&](std::string_view name, ElementKind kind, ValueRule rule, auto value, std::uint32_t count,
                       const auto& next) {
    fill_at_random<decltype(value)>(edit, edit.add_attribute(name, kind, rule, value), count, next);
  };
  const std::uint32_t faces = mesh.face_slots(), edges = mesh.edge_slots(), vertices = mesh.vertex_slots();
  add("face.count", ElementKind::face, ValueRule::sum, std::int64_t{0}, faces, whole);
  add("face.area", ElementKind::face, ValueRule::sum, 0.0, faces, part);
  add("face.mark", ElementKind::face, ValueRule::first, std::int64_t{0}, faces, whole);
  add("edge.count", ElementKind::edge, ValueRule::sum, std::int64_t{0}, edges, whole);
  add("edge.length", ElementKind::edge, ValueRule::sum, 0.0, edges, part);
  add("edge.crease", ElementKind::edge, ValueRule::blend, -1.0, edges, part);
  add("vertex.mass", ElementKind::vertex, ValueRule::sum, 0.0, vertices, part);
  edit.commit();
}

bool divides(const AnyOp& op) {
  return std::holds_alternative<SplitEdge>(op) || std::holds_alternative<Triangulate>(op) ||
         std::holds_alternative<Poke>(op) || std::holds_alternative<SeparateLoop>(op) ||
         std::holds_alternative<SeparateEdge>(op) || std::holds_alternative<VertexSplit>(op);
}

TEST(divided_values, sums_stay_and_integers_exactly) {
  std::size_t done = 0;
  for (std::uint64_t seed = 0; seed < test::seed_count(200, 4000); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Mesh mesh = seed % 2 == 0 ? test::random_kernel_mesh(seed) : test::random_complex(seed);
    Journal journal;
    Dice dice(seed);
    add_values(mesh, journal, dice);
    for (int i = 0; i < 60; ++i) {
      const AnyOp op = test::random_op(mesh, dice);
      if (!divides(op) || !check(mesh, op).legal()) continue;
      const Totals before(mesh);
      const MeshColumns columns = mesh.columns();
      Edit edit(mesh, &journal);
      ryosen::apply(edit, op);
      edit.commit();
      const Totals after(mesh);
      ASSERT_EQ(after.of_faces, before.of_faces) << command_of(Mesh(columns), op);
      ASSERT_EQ(after.of_edges, before.of_edges) << command_of(Mesh(columns), op);
      ASSERT_NEAR(after.area, before.area, 1e-9) << command_of(Mesh(columns), op);
      ASSERT_NEAR(after.length, before.length, 1e-9) << command_of(Mesh(columns), op);
      ASSERT_NEAR(after.of_vertices, before.of_vertices, 1e-9) << command_of(Mesh(columns), op);
      ++done;
      if (!dice.one_in(4)) continue;
      journal.undo(mesh);
      ASSERT_EQ(mesh.columns(), columns);
      journal.redo(mesh);
    }
  }
  EXPECT_GT(done, test::is_sample() ? 1u : 500u);
}

// Which of two parts has which share.
TEST(divided_values, parts_take_their_shares) {
  Mesh mesh = test::make_mesh({{0, 1, 2}});
  Journal journal;
  {
    Edit edit(mesh, &journal);
    const std::size_t face = edit.add_attribute("area", ElementKind::face, ValueRule::sum, 0.0);
    const std::size_t side = edit.add_attribute("length", ElementKind::edge, ValueRule::sum, 0.0);
    const std::size_t crease = edit.add_attribute("crease", ElementKind::edge, ValueRule::blend, 0.0f);
    edit.set_attribute(face, 0, attribute_words(32.0));
    const Edge bottom = edge(find_halfedge(mesh, Vertex(0), Vertex(1)));
    edit.set_attribute(side, bottom.index, attribute_words(8.0));
    edit.set_attribute(crease, bottom.index, attribute_words(0.75f));
    edit.commit();
  }
  Edit edit(mesh, &journal);
  ryosen::apply(edit, SplitEdge{find_halfedge(mesh, Vertex(0), Vertex(1)), 0.25});
  edit.commit();
  const auto value = [&](std::string_view name, std::uint32_t index) {
    return attribute_value<double>(*find_column(mesh, name), index);
  };
  const Edge left = edge(find_halfedge(mesh, Vertex(0), Vertex(3))),
             right = edge(find_halfedge(mesh, Vertex(3), Vertex(1)));
  EXPECT_EQ(value("length", left.index), 2);
  EXPECT_EQ(value("length", right.index), 6);
  EXPECT_EQ(attribute_value<float>(*find_column(mesh, "crease"), left.index), 0.75f);
  EXPECT_EQ(attribute_value<float>(*find_column(mesh, "crease"), right.index), 0.75f);
  EXPECT_EQ(value("length", edge(find_halfedge(mesh, Vertex(3), Vertex(2))).index), 0) << "new edges get the default";
  for (const Face f : live_faces(mesh)) {
    bool has_a = false;
    for (const Vertex v : vertices_around(mesh, f)) has_a = has_a || v == Vertex(0);
    EXPECT_EQ(value("area", f.index), has_a ? 8 : 24);
  }
}

}  // namespace
}  // namespace ryosen
