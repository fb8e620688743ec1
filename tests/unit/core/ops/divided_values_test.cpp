// Attribute values of elements that operators divide.
#include <gtest/gtest.h>

#include <map>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/edit.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/ops/all.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/random_edits.h"
#include "tests/support/core/random_ops.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

// Points share their value among their copies, and undirected edges among what is cut apart: it counts once.
std::vector<Vertex> points_of(const Mesh& mesh) {
  std::vector<Vertex> points;
  for (const Vertex v : live_vertices(mesh))
    if (point(mesh, v) == v) points.push_back(v);
  return points;
}
std::vector<Edge> undirected_edges(const Mesh& mesh) {
  std::map<std::pair<Vertex, Vertex>, Edge> edges;
  for (const Edge e : live_edges(mesh)) {
    const auto [a, b] = ends(mesh, e);
    edges.emplace(std::minmax({point(mesh, a), point(mesh, b)}), e);
  }
  std::vector<Edge> found;
  for (const auto& [points, e] : edges) found.push_back(e);
  return found;
}

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
        of_edges(total_of<std::int64_t>(mesh, "edge.count", undirected_edges(mesh))),
        area(total_of<double>(mesh, "face.area", live_faces(mesh))),
        length(total_of<double>(mesh, "edge.length", undirected_edges(mesh))),
        of_vertices(total_of<double>(mesh, "vertex.mass", points_of(mesh))) {}
};

std::int64_t whole_number(std::uint64_t a, std::uint64_t b) {
  Dice dice(a << 32u | b);
  return static_cast<std::int64_t>(dice.below(2000)) - 1000;
}

void add_values(Mesh& mesh, Journal& journal) {
  Edit edit(mesh, &journal);
  const auto add = [&](std::string_view name, ElementKind kind, ValueRule rule, auto fill) {
    using T = decltype(fill);
    const std::size_t k = edit.add_attribute(name, kind, rule, fill);
    const auto put = [&](std::uint32_t index, std::uint64_t x, std::uint64_t y) {
      edit.set_attribute(k, index, attribute_words(static_cast<T>(whole_number(x, y))));
    };
    if (kind == ElementKind::face)
      for (const Face f : live_faces(mesh)) put(f.index, f.index, k);
    if (kind == ElementKind::vertex)
      for (const Vertex v : live_vertices(mesh)) put(v.index, point(mesh, v).index, k);
    if (kind == ElementKind::edge)
      for (const Edge e : live_edges(mesh)) {
        const auto [a, b] = std::minmax({point(mesh, ends(mesh, e).first), point(mesh, ends(mesh, e).second)});
        put(e.index, a.index, b.index);
      }
  };
  add("face.count", ElementKind::face, ValueRule::sum, std::int64_t{0});
  add("face.area", ElementKind::face, ValueRule::sum, 0.0);
  add("face.mark", ElementKind::face, ValueRule::first, std::int64_t{0});
  add("edge.count", ElementKind::edge, ValueRule::sum, std::int64_t{0});
  add("edge.length", ElementKind::edge, ValueRule::sum, 0.0);
  add("edge.crease", ElementKind::edge, ValueRule::blend, -1.0);
  add("vertex.mass", ElementKind::vertex, ValueRule::sum, 0.0);
  edit.commit();
}

// Copies of a point, and edges of the same two points, have the same values.
void expect_copies_agree(const Mesh& mesh) {
  std::map<std::pair<Vertex, Vertex>, Edge> edges;
  for (const AttributeColumn& column : mesh.attributes()) {
    const auto agree = [&](std::uint32_t a, std::uint32_t b) {
      const auto at = [&](std::uint32_t i) { return column.data.begin() + std::ptrdiff_t{i} * column.words(); };
      return std::equal(at(a), at(a) + column.words(), at(b));
    };
    for (const Vertex v : live_vertices(mesh))
      ASSERT_TRUE(column.element != ElementKind::vertex || agree(v.index, point(mesh, v).index)) << column.name;
    if (column.element != ElementKind::edge) continue;
    for (const Edge e : live_edges(mesh)) {
      const auto [a, b] = ends(mesh, e);
      const auto [first, is_new] = edges.emplace(std::minmax({point(mesh, a), point(mesh, b)}), e);
      ASSERT_TRUE(agree(e.index, first->second.index)) << column.name;
    }
  }
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
    add_values(mesh, journal);
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
      expect_copies_agree(mesh);
      if (HasFatalFailure()) FAIL() << command_of(Mesh(columns), op);
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
