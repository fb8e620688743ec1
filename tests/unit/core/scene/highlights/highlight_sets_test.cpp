#include "ryosen/scene/highlights/highlight_sets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/random_edits.h"
#include "tests/support/core/random_ops.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

using Numbers = std::vector<std::uint32_t>;

const HighlightRow& creases() { return *find_highlight("creases"); }
const HighlightRow& seams() { return *find_highlight("seams"); }

// Searches what predicates of their own mark, too.
HighlightSets whole_search(const Mesh& mesh, unsigned threads = 0) {
  HighlightSets sets(mesh, threads);
  for (const HighlightRow& row : highlight_table()) sets.keep(mesh, row, threads);
  return sets;
}

const IndexSet& edges_of(const HighlightSets& sets, const HighlightRow& row) {
  return sets.of(own_mark(row, Element::Kind::edge));
}

TEST(highlight_sets, count_what_the_kinds_of_a_row_find) {
  const HighlightSets sets(make_mesh(fin()));
  EXPECT_EQ(sets.count(*find_highlight("nonmanifold")), 3u) << "an edge and two vertices";
  EXPECT_EQ(sets.count(*find_highlight("boundary")), 6u);
  EXPECT_EQ(sets.count(*find_highlight("wires")), 0u);
  EXPECT_TRUE(sets.keeps(*find_highlight("boundary")));
  EXPECT_FALSE(sets.keeps(creases()));
}

TEST(highlight_sets, are_the_same_for_any_number_of_threads) {
  for (std::uint64_t seed = 1; seed <= 200 && !HasFailure(); ++seed) {
    const Mesh mesh = random_complex(seed);
    const HighlightSets sets = whole_search(mesh, 1);
    for (const unsigned threads : {2u, 5u}) EXPECT_EQ(sets, whole_search(mesh, threads)) << seed << " " << threads;
  }
}

TEST(highlight_sets, are_equal_whatever_was_kept_before) {
  const Mesh mesh = make_mesh(tetrahedron());
  HighlightSets kept(mesh), kept_and_forgotten(mesh);
  kept.keep(mesh, creases());
  for (const HighlightRow* row : {&creases(), &seams()}) kept_and_forgotten.keep(mesh, *row);
  EXPECT_FALSE(kept == kept_and_forgotten);
  kept_and_forgotten.forget(seams());
  EXPECT_TRUE(kept == kept_and_forgotten);
}

int calls = 0;

TEST(highlight_sets, ask_a_predicate_only_while_its_highlight_is_kept) {
  const ScopedHighlight added({.id = "counted",
                               .name_en = "Counted",
                               .name_ja = "計数",
                               .legend_en = "All vertices.",
                               .legend_ja = "すべての頂点。",
                               .vertex = [](Neighbourhood&, Vertex) { return ++calls > 0; },
                               .looks = {0x00FF00, 0x00FF00, LineStyle::solid, 2, PointShape::disc, 4}});
  const HighlightRow& row = *find_highlight("counted");
  Mesh mesh = make_mesh(torus_grid(20, 20));
  Journal journal;
  calls = 0;
  HighlightSets sets(mesh);
  const auto edit_somewhere = [&] {
    Edit edit(mesh, &journal);
    move_point(edit, Vertex(210), mesh.position(Vertex(210)) + glm::dvec3(0.1, 0, 0));
    edit.commit();
    sets.update(mesh, journal, journal.size() - 1);
  };
  edit_somewhere();
  EXPECT_EQ(calls, 0);
  sets.keep(mesh, row, 1);
  EXPECT_EQ(calls, 400);
  EXPECT_EQ(sets.count(row), 400u);
  calls = 0;
  edit_somewhere();
  EXPECT_GT(calls, 0);
  EXPECT_LT(calls, 30) << "only around the edit";
  sets.forget(row);
  calls = 0;
  edit_somewhere();
  EXPECT_EQ(calls, 0);
  EXPECT_FALSE(sets.keeps(row));
}

TEST(highlight_sets, a_vertex_far_opposite_moves_and_the_edge_becomes_a_crease) {
  // Two flat polygons on the edge 0-1, one of them long: its far end is no neighbour of the edge.
  IndexedMesh source = indexed({{0, 1, 2}, {1, 0, 3, 4, 5, 6}});
  source.positions = {{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0, -4, 0}, {0.3, -8, 0}, {0.7, -8, 0}, {1, -4, 0}};
  Mesh mesh = from_indexed(std::move(source));
  Journal journal;
  HighlightSets sets(mesh);
  sets.keep(mesh, creases());
  ASSERT_EQ(sets.count(creases()), 0u);
  const auto move = [&](Vertex v, const glm::dvec3& place) {
    Edit edit(mesh, &journal);
    move_point(edit, v, place);
    edit.commit();
    sets.update(mesh, journal, journal.size() - 1);
  };
  const Edge bent = edge(find_halfedge(mesh, Vertex(0), Vertex(1)));
  move(Vertex(4), {0.3, -8, 9});
  EXPECT_EQ(edges_of(sets, creases()).to_vector(), Numbers{bent.index});
  const Mark mark = own_mark(creases(), Element::Kind::edge);
  EXPECT_TRUE(std::any_of(sets.changes().begin(), sets.changes().end(), [&](const HighlightSets::Change& change) {
    return change.mark == mark && change.index == bent.index;
  }));
  journal.undo(mesh);
  sets.update(mesh, journal, 0);
  EXPECT_EQ(sets.count(creases()), 0u);
  journal.redo(mesh);
  sets.update(mesh, journal, 0);
  EXPECT_EQ(sets.count(creases()), 1u);
}

TEST(highlight_sets, another_value_at_a_corner_makes_a_seam) {
  IndexedMesh source = indexed(two_quads());
  source.texcoords.pool = {{0, 0, 0}, {0.5, 0, 0}, {0, 0, 0}};
  source.texcoords.index = {0, 0, 0, 0, 2, 0, 0, 0};
  Mesh mesh = from_indexed(std::move(source));
  Journal journal;
  HighlightSets sets(mesh);
  sets.keep(mesh, seams());
  EXPECT_EQ(sets.count(seams()), 0u) << "equal values in two places of the pool are equal";
  const Halfedge common = find_halfedge(mesh, Vertex(0), Vertex(1));
  Edit edit(mesh, &journal);
  const std::uint32_t other = 1;
  edit.set_attribute(corner_attributes(mesh)[0].index_column, mesh.next(common).index, std::span(&other, 1));
  edit.commit();
  sets.update(mesh, journal, 0);
  EXPECT_EQ(edges_of(sets, seams()).to_vector(), Numbers{edge(common).index});
  journal.undo(mesh);
  sets.update(mesh, journal, 0);
  EXPECT_EQ(sets.count(seams()), 0u);
}

// A texture coordinate and a normal at each corner, of a few values, so that some edges are seams.
Mesh with_values(std::uint64_t seed) {
  const SeededMesh random = seeded_mesh(seed);
  IndexedMesh source = indexed(random.faces, random.points);
  Dice dice(seed);
  for (CornerValues* values : {&source.texcoords, &source.normals}) {
    values->pool = {{0, 0, 1}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
    for (std::size_t i = 0; i < source.corners.size(); ++i)
      values->index.push_back(dice.one_in(9) ? no_index : static_cast<std::uint32_t>(dice.below(dice.below(4) + 1)));
  }
  return from_indexed(std::move(source));
}

// Another value at some corner, and nothing else.
bool change_a_value(Mesh& mesh, Journal& journal, Dice& dice) {
  const std::vector<CornerAttribute> attributes = corner_attributes(mesh);
  const Halfedge h = random_halfedge(mesh, dice);
  if (attributes.empty() || !h) return false;
  Edit edit(mesh, &journal);
  const auto value = static_cast<std::uint32_t>(dice.below(4));
  edit.set_attribute(attributes[0].index_column, h.index, std::span(&value, 1));
  edit.commit();
  return true;
}

struct Walked {
  int edits = 0, creases = 0, seams = 0;  // and changes of these
};

// Random edits, undos and redos: after each the sets are those of a fresh search, and what is listed leads there.
void walk(Mesh mesh, std::uint64_t seed, Walked& walked) {
  Dice dice(seed);
  Journal journal;
  HighlightSets sets = whole_search(mesh);
  for (int step = 0; step < 20; ++step) {
    std::array<Numbers, 2> expected{edges_of(sets, creases()).to_vector(), edges_of(sets, seams()).to_vector()};
    const auto transaction = random_step(mesh, journal, dice, 6, [&](int thrown) {
      return thrown == 2   ? change_a_value(mesh, journal, dice)
             : thrown == 3 ? edit_at_random(mesh, journal, dice)
                           : try_apply(mesh, &journal, random_op(mesh, dice));
    });
    if (!transaction) continue;
    ++walked.edits;
    sets.update(mesh, journal, *transaction);
    const HighlightSets fresh = whole_search(mesh);
    ASSERT_EQ(edges_of(sets, creases()).to_vector(), edges_of(fresh, creases()).to_vector())
        << "seed " << seed << " step " << step;
    ASSERT_EQ(edges_of(sets, seams()).to_vector(), edges_of(fresh, seams()).to_vector())
        << "seed " << seed << " step " << step;
    ASSERT_EQ(sets, fresh) << "seed " << seed << " step " << step;
    if (sets.changed_everything()) continue;
    const Mark marks[] = {own_mark(creases(), Element::Kind::edge), own_mark(seams(), Element::Kind::edge)};
    for (const HighlightSets::Change& change : sets.changes())
      for (std::size_t k = 0; k < 2; ++k)
        if (change.mark == marks[k]) {
          ++(k == 0 ? walked.creases : walked.seams);
          const auto place = std::lower_bound(expected[k].begin(), expected[k].end(), change.index);
          if (place != expected[k].end() && *place == change.index)
            expected[k].erase(place);
          else
            expected[k].insert(place, change.index);
        }
    ASSERT_EQ(expected[0], edges_of(fresh, creases()).to_vector());
    ASSERT_EQ(expected[1], edges_of(fresh, seams()).to_vector());
  }
}

TEST(highlight_sets, are_kept_current_through_edits_undo_and_redo) {
  Walked walked;
  const std::uint64_t seeds = seed_count(200, 500);
  for (std::uint64_t seed = 1; seed <= seeds && !HasFailure(); ++seed) {
    walk(with_values(seed), seed, walked);
    walk(random_complex(seed), seed, walked);  // with rings, bridges and wires
  }
  EXPECT_GT(walked.edits, 10 * static_cast<int>(seeds)) << "the dice must find enough to do";
  EXPECT_GT(walked.creases, 10 * static_cast<int>(seeds));
  EXPECT_GT(walked.seams, 4 * static_cast<int>(seeds));
}

}  // namespace
}  // namespace ryosen
