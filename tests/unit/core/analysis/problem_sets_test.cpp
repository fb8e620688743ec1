#include "ryosen/analysis/problem_sets.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "ryosen/analysis/boundary_loops.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/all.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/random_edits.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

using Numbers = std::vector<std::uint32_t>;

TEST(problem_sets, are_the_same_for_any_number_of_threads) {
  for (std::uint64_t seed = 1; seed <= 600 && !HasFailure(); ++seed) {
    const Mesh mesh = random_kernel_mesh(seed);
    const ProblemSets sets(mesh, 1);
    for (const unsigned threads : {2u, 5u}) EXPECT_EQ(sets, ProblemSets(mesh, threads)) << seed << " " << threads;
  }
}

// The sets by asking every element for itself, each with a neighbourhood of its own.
template <class Handle, class Predicate>
void expect_set(const Mesh& mesh, const ProblemRow& row, Predicate predicate, std::uint32_t slots,
                const IndexSet& set) {
  if (!predicate) return;
  for (std::uint32_t i = 0; i < slots; ++i) {
    Neighbourhood around(mesh);
    ASSERT_EQ(set.contains(i), mesh.is_alive(Handle(i)) && predicate(around, Handle(i))) << row.id << " " << i;
  }
}

TEST(problem_sets, are_what_the_predicates_say_of_each_element) {
  for (std::uint64_t seed = 1; seed <= 1500 && !HasFailure(); ++seed) {
    const Mesh mesh = random_kernel_mesh(seed);
    const ProblemSets sets(mesh);
    for (const ProblemRow& row : problem_table()) {
      expect_set<Vertex>(mesh, row, row.vertex, mesh.vertex_slots(), sets.of(row.kind));
      expect_set<Edge>(mesh, row, row.edge, mesh.edge_slots(), sets.of(row.kind));
      expect_set<Face>(mesh, row, row.face, mesh.face_slots(), sets.of(row.kind));
    }
  }
}

TEST(problem_sets, hold_an_edge_of_several_sheets_once) {
  const Mesh mesh = make_mesh(fin());
  const ProblemSets sets(mesh);
  const Numbers edges = sets.of(ProblemKind::nonmanifold_edge).to_vector();
  ASSERT_EQ(edges.size(), 1u);
  const auto [a, b] = ends(mesh, Edge(edges[0]));
  EXPECT_EQ(sheets_between(mesh, a, b).size(), 3u);
  EXPECT_EQ(sets.of(ProblemKind::nonmanifold_vertex).to_vector(), (Numbers{0, 1}));
  EXPECT_EQ(sets.count(ProblemKind::boundary_loop), 6u);
}

TEST(problem_sets, mark_the_later_face_of_a_pair) {
  const ProblemSets sets(make_mesh({{0, 2, 1}, {0, 1, 3}, {0, 1, 2}}));
  EXPECT_EQ(sets.of(ProblemKind::duplicate_face).to_vector(), (Numbers{2}));
  EXPECT_EQ(sets.of(ProblemKind::hanging_pair).to_vector(), (Numbers{2}));
}

TEST(problem_sets, rows_have_stable_ids_and_one_predicate) {
  for (const ProblemRow& row : problem_table()) {
    EXPECT_EQ(find_problem_row(row.id), &row);
    EXPECT_EQ((row.vertex != nullptr) + (row.edge != nullptr) + (row.face != nullptr) + (row.quarantined != nullptr) +
                  row.is_found_whole() + row.is_on_request(),
              1)
        << row.id;
    EXPECT_FALSE(row.name_en.empty() || row.name_ja.empty()) << row.id;
    EXPECT_NE(row.many_en.find('#'), std::string_view::npos) << row.id;
    EXPECT_NE(row.many_ja.find('#'), std::string_view::npos) << row.id;
    EXPECT_EQ(row.sentence(12).en.find('#'), std::string::npos) << row.id;
    EXPECT_NE(row.sentence(12).ja.find("12"), std::string::npos) << row.id;
    EXPECT_NE(row.name_of(1).en, row.name_of(2).en) << row.id;
    EXPECT_EQ(row.name_of(0).en, row.several_en) << row.id;
    EXPECT_TRUE(row.name_of(2).en[0] >= 'a' && row.name_of(2).en[0] <= 'z') << row.id;
  }
  EXPECT_EQ(row_of(ProblemKind::misoriented_edge).name_of(1).en, "misoriented edge");
  EXPECT_EQ(row_of(ProblemKind::misoriented_edge).name_of(2).en, "misoriented edges");
  EXPECT_EQ(find_problem_row("no_such_kind"), nullptr);
}

TEST(problem_sets, are_kept_current_through_edits_undo_and_redo) {
  int edits = 0, other_loops = 0, kept_loops = 0;
  const std::uint64_t seeds = seed_count(300, 800);
  for (std::uint64_t seed = 1; seed <= seeds && !HasFailure(); ++seed) {
    Dice dice(seed);
    Mesh mesh = random_kernel_mesh(seed);
    Journal journal;
    ProblemSets sets(mesh);
    BoundaryLoopCount loops;
    {
      Neighbourhood around(mesh);
      loops.search(around, sets.of(ProblemKind::boundary_loop));
    }
    for (int step = 0; step < 25; ++step) {
      const ProblemSets before = sets;
      const auto transaction =
          random_step(mesh, journal, dice, 4, [&](int) { return edit_at_random(mesh, journal, dice); });
      if (!transaction) continue;
      ++edits;
      sets.update(mesh, journal, *transaction);
      const ProblemSets fresh(mesh);
      Neighbourhood around(mesh);
      for (const ProblemRow& row : problem_table())
        ASSERT_EQ(sets.of(row.kind).to_vector(), fresh.of(row.kind).to_vector())
            << row.id << ", seed " << seed << " step " << step;
      ASSERT_EQ(sets.counts_on_points(mesh), counts_on_points(mesh)) << "seed " << seed << " step " << step;
      if (sets.changed_everything()) {
        loops.search(around, sets.of(ProblemKind::boundary_loop));
        continue;
      }
      const std::uint32_t loops_before = loops.count();
      const std::uint64_t revision_before = loops.revision();
      loops.update(around, sets.of(ProblemKind::boundary_loop), sets.edges_asked());
      const BoundaryLoops found = find_boundary_loops(around, sets.of(ProblemKind::boundary_loop));
      ASSERT_EQ(loops.has_open_chain(), found.has_open_chain) << "seed " << seed << " step " << step;
      ASSERT_EQ(loops.count(), found.size()) << "seed " << seed << " step " << step;
      other_loops += loops.count() != loops_before;
      kept_loops += loops.count() > 0 && loops.revision() == revision_before;
      // What is listed leads from the sets before to those after.
      std::array<Numbers, most_problem_kinds> members;
      for (const ProblemRow& row : problem_table()) {
        Numbers& set = members[static_cast<std::size_t>(row.kind)];
        set = before.of(row.kind).to_vector();
        for (const ProblemSets::Change& change : sets.changes()) {
          if (change.kind != row.kind) continue;
          const auto place = std::lower_bound(set.begin(), set.end(), change.index);
          ASSERT_EQ(place != set.end() && *place == change.index, !change.is_member);
          if (change.is_member)
            set.insert(place, change.index);
          else
            set.erase(place);
        }
        ASSERT_EQ(set, fresh.of(row.kind).to_vector());
      }
    }
  }
  EXPECT_GT(edits, 10 * static_cast<int>(seeds)) << "the dice must find enough to do";
  EXPECT_GT(8 * other_loops, static_cast<int>(seeds));
  EXPECT_GT(8 * kept_loops, static_cast<int>(seeds));
}

TEST(problem_sets, ask_only_around_the_edit) {
  // A far bow-tie stays as it is, and no set beyond the touched points changes.
  Polygons faces = torus_grid(30, 30);
  faces.push_back({900, 901, 902});
  faces.push_back({900, 903, 904});
  Mesh mesh = make_mesh(faces);
  Journal journal;
  ProblemSets sets(mesh);
  EXPECT_TRUE(sets.changed_everything());
  Edit edit(mesh, &journal);
  move_point(edit, Vertex(500), mesh.position(Vertex(501)));
  edit.commit();
  sets.update(mesh, journal, 0);
  EXPECT_FALSE(sets.changed_everything());
  ASSERT_EQ(sets.changes().size(), 4u) << "the two faces at the edge have lost their area, and its ends lie together";
  for (const ProblemSets::Change& change : sets.changes())
    EXPECT_TRUE(change.kind == ProblemKind::degenerate_area || change.kind == ProblemKind::coincident_points);
  EXPECT_EQ(sets.of(ProblemKind::coincident_points).to_vector(), (Numbers{500, 501}));
  EXPECT_EQ(sets.count(ProblemKind::nonmanifold_vertex), 1u);
}

}  // namespace
}  // namespace ryosen
