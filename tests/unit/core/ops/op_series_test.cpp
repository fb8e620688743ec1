// Many calls of one operator: whatever its row does at less cost says and does the same as each call by itself.
#include "ryosen/ops/op_series.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "ryosen/mesh/invariants.h"
#include "ryosen/ops/each.h"
#include "tests/support/core/element_values.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/random_ops.h"
#include "tests/support/core/shapes.h"
#include "tests/support/core/ugly_meshes.h"
#include "tests/support/core/valued_sheet.h"

namespace ryosen {
namespace {

using namespace test;

using Words = std::vector<std::string_view>;

EachResult call_each(Edit& edit, const OpInfo& op, const std::vector<Element>& elements, const Words& words,
                     bool is_strict) {
  Progress unheard;
  EachResult result = apply_to_each(edit, op, elements, words, is_strict, unheard);
  edit.commit();
  return result;
}

void expect_same(const Mesh& start, const OpInfo& op, const std::vector<Element>& elements, const Words& words,
                 bool is_strict) {
  SCOPED_TRACE(std::string(op.id) + (words.empty() ? "" : " ") + std::string(words.empty() ? "" : words[0]) +
               (is_strict ? ", strict" : ""));
  OpInfo each_by_itself = op;
  each_by_itself.in_series = nullptr;
  Mesh single = start, many = start;
  Journal journal;
  Edit once(single, nullptr), edit(many, &journal);
  const EachResult expected = call_each(once, each_by_itself, elements, words, is_strict);
  const EachResult result = call_each(edit, op, elements, words, is_strict);
  EXPECT_EQ(expected.error, NameError::none) << expected.sentence.en;
  EXPECT_EQ(result.error, NameError::none) << result.sentence.en;
  EXPECT_EQ(result.done, expected.done);
  EXPECT_EQ(result.calls, expected.calls);
  EXPECT_EQ(result.gone, expected.gone);
  EXPECT_EQ(result.ends, expected.ends);
  ASSERT_EQ(result.refused.size(), expected.refused.size());
  for (std::size_t i = 0; i < result.refused.size(); ++i) {
    EXPECT_EQ(result.refused[i].rule, expected.refused[i].rule);
    EXPECT_EQ(result.refused[i].elements, expected.refused[i].elements);
  }
  EXPECT_EQ(many.hash(), single.hash());
  EXPECT_EQ(values_of(many), values_of(single));
  EXPECT_EQ(many.live(), single.live());
  EXPECT_EQ(many.vertex_slots(), single.vertex_slots());
  EXPECT_EQ(many.edge_slots(), single.edge_slots());
  EXPECT_EQ(many.face_slots(), single.face_slots());
  const auto broken = check_invariants(many);
  EXPECT_FALSE(broken) << broken->sentence;
  journal.undo(many);
  EXPECT_EQ(many.hash(), start.hash());
}

std::vector<Element> some_of(const Mesh& m, Element::Kind kind, Dice& dice) {
  std::vector<Element> some;
  const int share = 1 + dice.below(3);
  const auto add = [&](auto element) {
    if (m.is_alive(element) && dice.one_in(share)) some.emplace_back(element);
  };
  if (kind == Element::Kind::vertex)
    for (std::uint32_t i = 0; i < m.vertex_slots(); ++i) add(Vertex(i));
  else if (kind == Element::Kind::edge)
    for (std::uint32_t i = 0; i < m.edge_slots(); ++i) add(Edge(i));
  else
    for (std::uint32_t i = 0; i < m.face_slots(); ++i) add(Face(i));
  return some;
}

// What may stand behind the elements of a collapse; nothing behind those of the others.
Words some_words(const OpInfo& op, Dice& dice) {
  static constexpr std::string_view places[] = {"", "", "mid", "start", "end", "1,2,3"};
  const std::string_view place = op.id == "collapse" ? places[dice.below(6)] : "";
  return place.empty() ? Words() : Words{place};
}

// Of every operator with a series, on a part of the vertices, edges and faces that it takes.
void expect_same_of_all(const Mesh& start, Dice& dice) {
  for (const OpInfo& op : all_ops()) {
    if (!op.in_series) continue;
    for (const auto kind : {Element::Kind::vertex, Element::Kind::edge, Element::Kind::face}) {
      const std::vector<Element> elements = some_of(start, kind, dice);
      const CalledWith with = called_with(start, op, elements, {});
      if (with.taken.size() >= least_taken(op)) expect_same(start, op, elements, some_words(op, dice), dice.one_in(3));
    }
  }
}

// Triangles and quads that turn either way on few points, so that each has many copies.
Mesh heap(int faces, int points, Dice& dice) {
  std::vector<std::vector<std::uint32_t>> lists;
  for (int i = 0; i < faces; ++i) {
    std::vector<std::uint32_t> corners;
    const std::size_t sides = dice.one_in(4) ? 4 : 3;
    while (corners.size() < sides) {
      const auto p = static_cast<std::uint32_t>(dice.below(points));
      if (std::find(corners.begin(), corners.end(), p) == corners.end()) corners.push_back(p);
    }
    lists.push_back(std::move(corners));
  }
  return make_mesh(lists, points);
}

void expect_same_of_seed(std::uint64_t seed) {
  SCOPED_TRACE(seed);
  Dice dice(seed);
  const SeededMesh seeded = seeded_mesh(seed);
  Mesh start = seed % 3 == 0 ? make_mesh(seeded.faces, seeded.points) : random_complex(seed);
  if (seed % 4 == 1) add_values(start, nullptr);
  expect_same_of_all(start, dice);
}

TEST(op_series, on_surfaces_and_complexes) {
  for (std::uint64_t seed = 1; seed <= (is_long_run() ? 20'000u : 250u) && !HasFailure(); ++seed)
    expect_same_of_seed(seed);
}

// A copy without a face; a face that lies on the points of another and meets two of them twice.
TEST(op_series, of_long_runs_that_failed) {
  for (const std::uint64_t seed : {763u, 19039u}) expect_same_of_seed(seed);
}

TEST(op_series, on_points_with_many_copies) {
  for (std::uint64_t seed = 1; seed <= (is_long_run() ? 3000u : 25u); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    expect_same_of_all(heap(10 + dice.below(70), 4 + dice.below(6), dice), dice);
    if (HasFailure()) return;
  }
}

// Vertices with two edges are taken out between others, at which faces get other numbers.
TEST(op_series, dissolves_vertices_on_split_edges) {
  const OpInfo& dissolve = *find_op("dissolve");
  for (std::uint64_t seed = 1; seed <= (is_long_run() ? 5000u : 100u); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const auto size = static_cast<std::uint32_t>(3 + dice.below(3));
    Mesh start = seed % 2 == 0 ? random_complex(seed) : make_mesh(torus_grid(size, 3));
    for (int i = 0; i < 30; ++i) try_apply(start, nullptr, SplitEdge{random_halfedge(start, dice), 0.5});
    std::vector<Element> vertices = some_of(start, Element::Kind::vertex, dice);
    for (std::size_t i = vertices.size(); i > 1; --i)
      std::swap(vertices[i - 1], vertices[static_cast<std::size_t>(dice.below(static_cast<int>(i)))]);
    expect_same(start, dissolve, vertices, {}, dice.one_in(3));
    if (HasFailure()) return;
  }
}

TEST(op_series, on_sheets_with_values_and_a_seam) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    expect_same_of_all(valued_sheet(2 + static_cast<std::uint32_t>(dice.below(5)), seed % 2 == 0 ? 0.4 : no_seam),
                       dice);
    if (HasFailure()) return;
  }
}

TEST(op_series, on_shapes_where_one_element_meets_all) {
  for (const UglyFamily& family : ugly_families())
    for (const std::uint32_t n : {3u, 12u, 40u}) {
      SCOPED_TRACE(std::string(family.id) + " " + std::to_string(n));
      Dice dice(n);
      expect_same_of_all(from_indexed(family.make(n)), dice);
      if (HasFailure()) return;
    }
}

}  // namespace
}  // namespace ryosen
