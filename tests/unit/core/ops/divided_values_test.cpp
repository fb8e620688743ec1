// Attribute values of elements that operators divide or unite.
#include <gtest/gtest.h>

#include <map>
#include <tuple>

#include "ryosen/indexed/from_indexed.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/edit.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/ops/all.h"
#include "tests/support/core/element_values.h"
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
std::map<std::pair<Vertex, Vertex>, Edge> edges_by_points(const Mesh& mesh) {
  std::map<std::pair<Vertex, Vertex>, Edge> edges;
  for (const Edge e : live_edges(mesh)) {
    const auto [a, b] = ends(mesh, e);
    edges.emplace(std::minmax({point(mesh, a), point(mesh, b)}), e);
  }
  return edges;
}
std::vector<Edge> undirected_edges(const Mesh& mesh) {
  std::vector<Edge> found;
  for (const auto& [points, e] : edges_by_points(mesh)) found.push_back(e);
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
    test::add_values(mesh, &journal);
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
      test::expect_copies_agree(mesh);
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

// The values that deleted elements had before the operator.
struct Deleted {
  std::int64_t faces = 0;
  double vertices = 0;

  Deleted(const Mesh& before, const OpEffect& effect) {
    for (const Element& e : effect.deleted) {
      if (e.kind == Element::Kind::face)
        faces += attribute_value<std::int64_t>(*find_column(before, "face.count"), e.index);
      if (e.kind == Element::Kind::vertex)
        vertices += attribute_value<double>(*find_column(before, "vertex.mass"), e.index);
    }
  }
};

void expect_edges_keep_values(const Mesh& before, const Mesh& after) {
  const auto was = edges_by_points(before);
  const auto value = [](const Mesh& mesh, Edge e) {
    return attribute_value<std::int64_t>(*find_column(mesh, "edge.count"), e.index);
  };
  for (const auto& [points, e] : edges_by_points(after)) {
    ASSERT_TRUE(was.contains(points));
    EXPECT_EQ(value(after, e), value(before, was.at(points)));
  }
}

// Sums count united elements, and lose those of elements that go with their values.
void expect_sums_are_united(const AnyOp& op, const Mesh& before, const OpEffect& effect, const Mesh& after) {
  const Totals was(before), is(after);
  const Deleted deleted(before, effect);
  if (const auto* const swap = std::get_if<SwapEdge>(&op)) {
    const auto [a, b] = ends(before, edge(swap->halfedge));
    // A wire may be left where the edge was.
    const bool is_left = edges_by_points(after).contains(std::minmax({point(before, a), point(before, b)}));
    EXPECT_EQ(is.of_faces, was.of_faces);
    EXPECT_EQ(
        is.of_edges - was.of_edges,
        is_left ? attribute_value<std::int64_t>(*find_column(before, "edge.count"), edge(swap->halfedge).index) : 0);
    EXPECT_EQ(is.of_vertices, was.of_vertices);
  } else if (const auto* const collapse = std::get_if<CollapseEdge>(&op)) {
    const Edge gone = edge(collapse->halfedge);
    EXPECT_EQ(is.of_vertices, was.of_vertices);
    EXPECT_EQ(is.of_edges,
              was.of_edges - attribute_value<std::int64_t>(*find_column(before, "edge.count"), gone.index));
    EXPECT_EQ(is.of_faces, was.of_faces - deleted.faces);
  } else if (std::holds_alternative<UniteEdge>(op)) {
    EXPECT_EQ(is.of_vertices, was.of_vertices - deleted.vertices);
    EXPECT_EQ(is.of_edges, was.of_edges);
    EXPECT_EQ(is.of_faces, was.of_faces);
  } else if (std::holds_alternative<UniteLoop>(op)) {
    EXPECT_EQ(is.of_vertices, was.of_vertices);
    expect_edges_keep_values(before, after);
    EXPECT_EQ(is.of_faces, was.of_faces);
  } else if (const auto* const dissolve = std::get_if<Dissolve>(&op); dissolve && dissolve->halfedge) {
    EXPECT_EQ(is.of_vertices, was.of_vertices - deleted.vertices);
    expect_edges_keep_values(before, after);
    EXPECT_EQ(is.of_faces, was.of_faces);
  } else if (std::holds_alternative<Weld>(op)) {
    EXPECT_EQ(is.of_vertices, was.of_vertices);
    EXPECT_EQ(is.of_edges, was.of_edges);
    EXPECT_EQ(is.of_faces, was.of_faces);
  }
}

TEST(united_values, sums_stay_and_copies_agree_whatever_is_done) {
  std::map<std::size_t, std::size_t> done;  // by operator
  for (std::uint64_t seed = 0; seed < test::seed_count(200, 4000); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Mesh mesh = seed % 2 == 0 ? test::random_kernel_mesh(seed) : test::random_complex(seed);
    Journal journal;
    Dice dice(seed);
    test::add_values(mesh, &journal);
    for (int i = 0; i < 60; ++i) {
      const AnyOp op = test::random_op(mesh, dice);
      if (!check(mesh, op).legal()) continue;
      const Mesh before = mesh;
      Edit edit(mesh, &journal);
      const OpEffect effect = ryosen::apply(edit, op);
      edit.commit();
      SCOPED_TRACE(command_of(before, op));
      expect_sums_are_united(op, before, effect, mesh);
      test::expect_copies_agree(mesh);
      if (HasFailure()) return;
      ++done[op.index()];
      if (!dice.one_in(4)) continue;
      journal.undo(mesh);
      ASSERT_EQ(mesh.columns(), before.columns());
      journal.redo(mesh);
    }
  }
  EXPECT_GT(done.size(), test::is_sample() ? 1u : 20u) << "operators";
}

// The place is told by its word, also where the edge has no length, is turned or very long.
TEST(united_values, of_a_collapse_are_those_of_the_place) {
  using Place = CollapseEdge::Place;
  for (const double length : {0.0, 1.0, 1e200})
    for (const auto& [place, expected, mark] : {std::tuple(Place::automatic, 8.0, 2), std::tuple(Place::end, 8.0, 2),
                                                std::tuple(Place::start, 4.0, 1), std::tuple(Place::middle, 6.0, 2)}) {
      IndexedMesh list = test::indexed({{0, 1, 2}, {2, 1, 3}}, 4);
      list.positions = {{0, 0, 0}, {length, 0, 0}, {0, 1, 0}, {length, 1, 0}};
      Mesh mesh = from_indexed(list);
      Edit edit(mesh, nullptr);
      const std::size_t mean = edit.add_attribute("mean", ElementKind::vertex, ValueRule::blend, 0.0),
                        first = edit.add_attribute("mark", ElementKind::vertex, ValueRule::first, 0);
      edit.set_attribute(mean, 0, attribute_words(4.0));
      edit.set_attribute(mean, 1, attribute_words(8.0));
      edit.set_attribute(first, 0, attribute_words(1));
      edit.set_attribute(first, 1, attribute_words(2));
      const CollapseEdge op{find_halfedge(mesh, Vertex(0), Vertex(1)), place};
      ASSERT_TRUE(op.check(mesh).legal());
      op.apply(edit);
      edit.commit();
      EXPECT_EQ(attribute_value<double>(mesh.attributes()[mean], 1), expected) << length;
      EXPECT_EQ(attribute_value<int>(mesh.attributes()[first], 1), mark) << length;
    }
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
