// Many vertices welded into one: the same as by one call after another.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/invariants.h"
#include "ryosen/ops/each.h"
#include "ryosen/ops/rules/sheets.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/random_ops.h"
#include "tests/support/core/shapes.h"
#include "tests/support/core/ugly_meshes.h"

namespace ryosen {
namespace {

using namespace test;

struct Done {
  std::size_t done = 0, gone = 0;
  std::map<Rule, std::vector<Element>> refused;

  friend bool operator==(const Done&, const Done&) = default;
};

// In an edit of its own; the first rule that is broken, if any.
std::optional<Rule> call(Mesh& mesh, const AnyOp& op) {
  const Verdict verdict = check(mesh, op);
  if (!verdict.legal()) return verdict.reasons[0].rule;
  Edit edit(mesh, nullptr);
  apply(edit, op);
  edit.commit();
  return std::nullopt;
}

// The vertex that stands for the last one after it was called with another: where both have gone, what is left of their
// points.
void hand_on(const Mesh& mesh, Vertex& last, std::initializer_list<Vertex> heirs) {
  for (const Vertex heir : heirs)
    if (!mesh.is_alive(last)) last = heir;
}

bool is_joined_as_itself(const Mesh& mesh, Vertex v, Vertex last) {
  bool is_joined = false;
  for_each_copy(mesh, last, [&](Vertex copy) {
    if (mesh.is_isolated(copy)) return;
    for (const Halfedge h : outgoing(mesh, copy)) is_joined |= mesh.to(h) == v || point(mesh, mesh.to(h)) == v;
  });
  return is_joined;
}

// Along the edges that lead to the last one, those with the lowest number first; what may not be is asked again when
// there is no other and something was done since.
std::size_t collapsed_into(Mesh& mesh, std::vector<Element>& left, Vertex& last) {
  std::size_t done = 0, before = 0;
  std::vector<Element> refused;
  while (true) {
    const auto next = std::find_if(left.begin(), left.end(), [&](const Element& e) {
      return std::find(refused.begin(), refused.end(), e) == refused.end() && mesh.is_alive(e.vertex()) &&
             is_joined_as_itself(mesh, e.vertex(), last);
    });
    if (next == left.end()) {
      if (done == before) return done;
      before = done;
      refused.clear();
      continue;
    }
    const Vertex v = next->vertex(), points[] = {point(mesh, last), point(mesh, v)};
    if (call(mesh, CollapseEdge{sheets_between(mesh, v, last).front()})) {
      refused.push_back(*next);
      continue;
    }
    left.erase(next);
    hand_on(mesh, last, {v, points[0], points[1]});
    ++done;
  }
}

// Into the last: first along edges, then by welding; where that may not be and an edge joins the two, along the edge.
Done one_after_another(Mesh& mesh, std::vector<Element> selected) {
  Vertex last = selected.back().vertex();
  selected.pop_back();
  std::sort(selected.begin(), selected.end());
  Done done;
  done.done = collapsed_into(mesh, selected, last);
  for (const Element& e : selected) {
    const Vertex v = e.vertex();
    if (!mesh.is_alive(v)) {
      ++done.gone;
      continue;
    }
    const Vertex points[] = {point(mesh, last), point(mesh, v)};
    std::optional<Rule> rule = call(mesh, Weld{last, v, {}, {}});
    if (rule)
      if (const auto sheets = sheets_between(mesh, v, last); !sheets.empty())
        rule = call(mesh, CollapseEdge{sheets.front()});
    if (rule)
      done.refused[*rule].push_back(e);
    else
      ++done.done;
    hand_on(mesh, last, {v, points[0], points[1]});
  }
  return done;
}

Done at_once(Mesh& mesh, Journal& journal, const std::vector<Element>& selected) {
  Edit edit(mesh, &journal);
  Progress unheard;
  const EachResult result = apply_to_each(edit, Weld::info, selected, {}, false, unheard);
  edit.commit();
  Done done{result.done, result.gone, {}};
  for (const EachResult::Refused& refused : result.refused) done.refused[refused.rule] = refused.elements;
  return done;
}

void expect_same(const Mesh& start, Dice& dice) {
  std::vector<Element> selected;
  const int share = 1 + dice.below(3);
  for (std::uint32_t i = 0; i < start.vertex_slots(); ++i)
    if (start.is_alive(Vertex(i)) && dice.one_in(share)) selected.emplace_back(Vertex(i));
  if (selected.size() < 2) return;
  std::swap(selected[static_cast<std::size_t>(dice.below(static_cast<int>(selected.size())))], selected.back());
  Mesh single = start, many = start;
  Journal journal;
  const Done expected = one_after_another(single, selected), done = at_once(many, journal, selected);
  EXPECT_EQ(done, expected);
  EXPECT_EQ(many.hash(), single.hash());
  EXPECT_EQ(many.live(), single.live());
  const auto broken = check_invariants(many);
  EXPECT_FALSE(broken) << broken->sentence;
  journal.undo(many);
  EXPECT_EQ(many.hash(), start.hash());
}

TEST(weld_many, is_the_same_as_one_after_another) {
  for (std::uint64_t seed = 1; seed <= seed_count(600, 1500); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const SeededMesh seeded = seeded_mesh(seed);
    expect_same(seed % 3 == 0 ? make_mesh(seeded.faces, seeded.points) : random_complex(seed), dice);
    if (HasFailure()) return;
  }
}

// What has come together several times over: faces apart, strips with slits between them, a torus cut along its edges.
TEST(weld_many, of_faces_that_lie_apart) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    Polygons faces = torus_grid(4, 5);
    std::uint32_t points = 20;
    for (auto& face : faces)
      for (auto& corner : face)
        if (dice.one_in(3)) corner = points++;
    expect_same(make_mesh(faces, points), dice);
    if (HasFailure()) return;
  }
}

// Euler operators leave sheets that reading would join; welding joins those at its points.
TEST(weld_many, of_points_that_would_be_read_otherwise) {
  std::vector<std::uint64_t> seeds(is_long_run() ? 200000 : 500);
  std::iota(seeds.begin(), seeds.end(), 1);
  if (!is_long_run()) seeds.insert(seeds.end(), {4258, 33202, 46568, 141029});  // each was a fault of its own
  for (const std::uint64_t seed : seeds) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    Mesh mesh = random_complex(seed);
    for (int i = dice.below(4); i >= 0 && mesh.live().faces > 0; --i) call(mesh, DeleteLoop{random_face(mesh, dice)});
    for (int i = dice.below(9); i > 0 && mesh.live().edges > 0; --i)
      call(mesh, DeleteEdge{random_halfedge(mesh, dice)});
    expect_same(mesh, dice);
    if (HasFailure()) return;
  }
}

// How many halfedges are looked at where a corner of each of n faces is welded into the last one.
std::uint64_t looks_of_faces_apart(std::uint32_t n) {
  Polygons faces;
  for (std::uint32_t i = 0; i < 3 * n; i += 3) faces.push_back({i, i + 1, i + 2});
  Mesh mesh = make_mesh(faces, 3 * n);
  ManifoldPoint known;
  Edit edit(mesh, nullptr);
  Vertex last(3 * n - 1);
  for (std::uint32_t i = 0; i + 3 < 3 * n; i += 3) {
    const Weld weld{last, Vertex(i), {}, {}};
    EXPECT_TRUE(weld.check(mesh).legal());
    weld.apply(edit, known);
    if (!mesh.is_alive(last)) last = Vertex(i);
  }
  edit.commit();
  EXPECT_EQ(counts_on_points(mesh).vertices, 2 * n + 1);
  return known.looks;
}

TEST(weld_many, looks_at_what_comes_to_the_point) {
  const std::uint64_t small = looks_of_faces_apart(50);
  EXPECT_GT(small, 100u);
  EXPECT_LE(looks_of_faces_apart(100), 5 * small / 2) << "twice as much";
  EXPECT_LE(looks_of_faces_apart(200), 5 * small) << "four times as much";
}

}  // namespace
}  // namespace ryosen
