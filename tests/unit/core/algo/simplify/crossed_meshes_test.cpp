// Simplification that keeps faces apart, of meshes in which some meet: against a comparison of all faces with each
// other after every collapse.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "ryosen/algo/simplify/simplify.h"
#include "ryosen/base/parallel.h"
#include "ryosen/io/formats.h"
#include "ryosen/ops/triangulate.h"
#include "tests/support/core/met_faces.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/simplified.h"

namespace ryosen::test {
namespace {

struct CrossedMesh {
  const char* name;
  Mesh mesh;
};

void cut_all(Mesh& mesh) {
  Edit edit(mesh, nullptr);
  Triangulate{}.apply(edit);
  edit.commit();
}

Mesh made_of(std::initializer_list<const char*> lines) {
  Mesh mesh;
  Journal journal;
  for (const char* const line : lines) run_algorithm(mesh, journal, line);
  cut_all(mesh);
  return mesh;
}

// A tube along a curve in the shape of an 8, which lies a little higher the one way than the other.
Mesh tube_through_itself(std::uint32_t around, std::uint32_t along, double height) {
  IndexedMesh source;
  const auto at = [](double turns) { return 2 * std::numbers::pi * turns; };
  for (std::uint32_t i = 0; i < along; ++i)
    for (std::uint32_t k = 0; k < around; ++k) {
      const double t = at(i / double(along)), s = at(k / double(around));
      const glm::dvec3 tangent = glm::normalize(glm::dvec3(std::cos(t), std::cos(2 * t), 0)),
                       side(-tangent.y, tangent.x, 0), middle(std::sin(t), std::sin(2 * t) / 2, height * std::cos(t));
      source.positions.push_back(middle + 0.15 * (std::cos(s) * side + glm::dvec3(0, 0, std::sin(s))));
    }
  const auto corner = [&](std::uint32_t i, std::uint32_t k) { return i % along * around + k % around; };
  for (std::uint32_t i = 0; i < along; ++i)
    for (std::uint32_t k = 0; k < around; ++k) {
      const std::uint32_t a = corner(i, k), b = corner(i + 1, k), c = corner(i + 1, k + 1), d = corner(i, k + 1);
      for (const auto& triangle : {std::array{a, b, c}, std::array{a, c, d}}) {
        source.corners.insert(source.corners.end(), triangle.begin(), triangle.end());
        source.face_offsets.push_back(static_cast<std::uint32_t>(source.corners.size()));
      }
    }
  return from_indexed(std::move(source));
}

// Sheets of side by side squares, each of them with points of its own at place(sheet, x, y).
template <class Place>
Mesh sheets(std::uint32_t count, std::uint32_t side, const Place& place) {
  IndexedMesh source;
  for (std::uint32_t n = 0; n < count; ++n) {
    const auto first = static_cast<std::uint32_t>(source.positions.size());
    for (std::uint32_t y = 0; y <= side; ++y)
      for (std::uint32_t x = 0; x <= side; ++x) source.positions.push_back(place(n, double(x), double(y)));
    for (std::uint32_t i = 0; i < side * side; ++i) {
      const std::uint32_t a = first + i / side * (side + 1) + i % side, c = a + side + 2;
      for (const std::uint32_t corner : {a, a + 1, c, a, c, c - 1}) source.corners.push_back(corner);
      for (int triangle = 0; triangle < 2; ++triangle) source.face_offsets.push_back(source.face_offsets.back() + 3);
    }
  }
  return from_indexed(std::move(source));
}

std::vector<CrossedMesh> crossed_meshes() {
  using Place = glm::dvec3;
  const auto hill = [](double x, double y) { return 0.3 * std::sin(1.3 * x) * std::cos(0.9 * y); };
  std::vector<CrossedMesh> all;
  all.push_back({"two spheres", made_of({"sphere segments=10 bands=7", "sphere segments=10 bands=7 at=0.7,0.3,0.2"})});
  all.push_back({"three spheres", made_of({"sphere segments=8 bands=6", "sphere segments=8 bands=6 at=0.9,0.1,0",
                                           "sphere segments=8 bands=6 at=0.4,0.8,0.2"})});
  all.push_back({"a tube", tube_through_itself(5, 24, 0.08)});
  all.push_back({"a flat tube", tube_through_itself(5, 30, 0)});
  all.push_back({"equal sheets", sheets(2, 6, [&](auto, double x, double y) { return Place(x, y, hill(x, y)); })});
  all.push_back({"sheets in one plane", sheets(2, 6, [](std::uint32_t n, double x, double y) {
                   return Place(x + 0.37 * n, y + 0.21 * n, 0);
                 })});
  all.push_back({"turned sheets in one plane", sheets(2, 6, [](std::uint32_t n, double x, double y) {
                   return n == 0 ? Place(x, y, 0) : Place(3.5 + 0.6 * (x - y), 0.6 * (x + y), 0);
                 })});
  all.push_back({"a boundary through a sheet", sheets(2, 7, [&](std::uint32_t n, double x, double y) {
                   return n == 0 ? Place(x, y, hill(x, y)) : Place(x + 0.3, 4.1 + 0.1 * x, y - 0.6);
                 })});
  all.push_back({"a boundary on a sheet", sheets(2, 7, [](std::uint32_t n, double x, double y) {
                   return n == 0 ? Place(x, y, 0) : Place(x, 3.5, y);
                 })});
  all.push_back({"rough sheets", sheets(3, 5, [](std::uint32_t n, double x, double y) {
                   return Place(x, y, 0.2 * n + 0.1 * (int(5 * x + 3 * y + 11 * n) % 7));
                 })});
  return all;
}

ParameterValues simplify_values(const Mesh& mesh, const std::string& line) {
  return *read_values(find_algorithm("simplify")->parameters, split_words(line)).values->on(mesh).values;
}

// The faces of the input from which a face comes.
using Origins = std::map<Face, std::set<Face>>;

void follow_origins(Origins& origins, const MetFaces& before, const MetFaces& after) {
  for (const auto& [gone, heirs] : heirs_by_sides(before, after)) {
    const std::set<Face> own = origins[gone];
    for (const Face heir : heirs) origins[heir].insert(own.begin(), own.end());
  }
}

// After each collapse no more pairs meet than before it, and each comes from one that did; so it does from one of the
// input. Tells how many met in the end.
std::size_t expect_inherited(const Mesh& input, const std::string& line, MetFaces (*look)(const Mesh&)) {
  Progress unheard;
  const BuiltLevels built = build_levels(input, {simplify_values(input, line)}, unheard);
  EXPECT_TRUE(built.levels);
  if (!built.levels) return 0;
  DetailLevels& levels = *built.levels;
  MetFaces before = look(levels.mesh());
  const std::set<FacePair> first = before.pairs;
  EXPECT_FALSE(first.empty());
  Origins origins;
  for (const auto& [face, corners] : before.corners) origins[face] = {face};
  for (std::size_t level = 1; level <= levels.last(); ++level) {
    levels.go_to(level);
    MetFaces after = look(levels.mesh());
    EXPECT_LE(after.pairs.size(), before.pairs.size()) << level;
    EXPECT_EQ(pairs_from_nowhere(before, after).size(), 0u) << level;
    follow_origins(origins, before, after);
    before = std::move(after);
  }
  for (const FacePair& pair : before.pairs) {
    bool is_of_input = false;
    for (const Face a : origins[pair.first])
      for (const Face b : origins[pair.second])
        is_of_input = is_of_input || first.count({std::min(a, b), std::max(a, b)}) > 0;
    EXPECT_TRUE(is_of_input) << pair.first.index << " " << pair.second.index;
  }
  return before.pairs.size();
}

TEST(simplify_crossed, lets_no_pair_meet_that_comes_from_none_and_never_more) {
  for (const CrossedMesh& one : crossed_meshes()) {
    SCOPED_TRACE(one.name);
    expect_inherited(one.mesh, "faces=0 no_self_intersections=on", met_faces);
    expect_inherited(one.mesh, "ratio=0.2 no_self_intersections=on boundary=free effort=0 remove_small=on", met_faces);
  }
}

TEST(simplify_crossed, goes_on_although_faces_meet) {
  std::size_t free = 0;
  for (const CrossedMesh& one : crossed_meshes()) {
    SCOPED_TRACE(one.name);
    Mesh kept = one.mesh, plain = one.mesh;
    const std::size_t before = met_faces(one.mesh).pairs.size();
    const AlgorithmResult result = simplified(kept, "ratio=0.4 no_self_intersections=on");
    EXPECT_TRUE(result.goal_report->is_reached) << result.text.en;
    const std::size_t after = met_faces(kept).pairs.size();
    EXPECT_LE(after, before);
    const std::string was = " " + std::to_string(before) + " pairs of faces crossed, ";
    const std::string is = after == 0   ? "none still does."
                           : after == 1 ? "one still does."
                                        : std::to_string(after) + " still do.";
    EXPECT_NE(result.text.en.find(was + is), std::string::npos) << result.text.en << after;
    EXPECT_NE(
        result.text.ja.find("交わる面は " + std::to_string(before) + " 組から " + std::to_string(after) + " 組へ"),
        std::string::npos)
        << result.text.ja;
    // The same rule does not hold by itself.
    DetailLevels levels(one.mesh);
    Progress unheard;
    ASSERT_TRUE(levels.build({}, {.faces = one.mesh.live().faces / 3}, unheard));
    MetFaces last = met_faces(levels.mesh());
    bool is_broken = false;
    for (std::size_t level = 1; level <= levels.last() && !is_broken; ++level) {
      levels.go_to(level);
      MetFaces next = met_faces(levels.mesh());
      is_broken = next.pairs.size() > last.pairs.size() || !pairs_from_nowhere(last, next).empty();
      last = std::move(next);
    }
    free += is_broken ? 1 : 0;
  }
  EXPECT_GE(free, 6u) << "or the guard is asked nothing";
}

TEST(simplify_crossed, is_undone_to_the_byte_and_the_same_by_any_number_of_threads) {
  const std::array<std::string, 3> ways{"effort=1", "effort=2", "effort=0 boundary=free"};
  std::size_t way = 0;
  for (const CrossedMesh& one : crossed_meshes()) {
    SCOPED_TRACE(one.name);
    const std::string line = "simplify ratio=0.3 no_self_intersections=on " + ways[way++ % ways.size()];
    std::optional<MeshColumns> first;
    for (const unsigned threads : {1u, 3u}) {
      const ThreadCount count(threads);
      Mesh mesh = one.mesh;
      Journal journal;
      run_algorithm(mesh, journal, line);
      if (threads == 1) first = mesh.columns();
      EXPECT_EQ(mesh.columns(), *first);
      ASSERT_TRUE(journal.can_undo());
      journal.undo(mesh);
      EXPECT_EQ(mesh.columns(), one.mesh.columns());
      journal.redo(mesh);
      EXPECT_EQ(mesh.columns(), *first);
    }
  }
}

TEST(simplify_crossed, leaves_the_mesh_as_it_is_wherever_it_is_cancelled) {
  Dice dice(3);
  int cancelled = 0;
  const AlgorithmRow& row = *find_algorithm("simplify");
  for (const CrossedMesh& one : crossed_meshes())
    for (int i = 0; i < 6; ++i) {
      Mesh mesh = one.mesh;
      Journal journal;
      int left = i < 2 ? i : dice.below(25);
      Progress cancelling([&](double) { return left-- > 0; }, Progress::Clock::duration::zero());
      Edit edit(mesh, &journal);
      const AlgorithmResult result =
          row.run(edit, {simplify_values(mesh, "ratio=0.2 no_self_intersections=on")}, cancelling);
      if (result.goal_report && result.goal_report->stopped != Stop::cancelled) continue;
      ++cancelled;
      EXPECT_EQ(result.changed, 0u) << one.name;
      EXPECT_EQ(mesh.columns(), one.mesh.columns()) << one.name;
    }
  EXPECT_GT(cancelled, 20);
}

// Two sheets that cross all over, of n squares each.
TEST(simplify_crossed, looks_at_no_more_for_each_face_of_a_larger_mesh) {
  const auto looks = [](std::uint32_t side) {
    Mesh mesh = sheets(2, side, [](std::uint32_t n, double x, double y) {
      return glm::dvec3(x, y, 0.3 * std::sin(x + n) * std::cos(y));
    });
    const CollapseLimits limits;
    const SimplifyGoal goal{
        .faces = mesh.live().faces / 5, .no_self_intersections = true, .has_self_intersections = true};
    Simplifier simplifier(mesh, limits, goal);
    Progress unheard;
    simplifier.run(unheard);
    EXPECT_TRUE(simplifier.is_at_goal());
    return static_cast<double>(simplifier.looked_at());
  };
  const double one = looks(20), two = looks(28), four = looks(40);
  EXPECT_LT(two, 2.6 * one) << one << " " << two << " " << four;
  EXPECT_LT(four, 2.6 * two) << one << " " << two << " " << four;
}

// Meshes that nobody here made, where they are there.
TEST(simplify_crossed, holds_on_meshes_of_others) {
  const std::filesystem::path folder = RYOSEN_SHARED_DIR "/meshes";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "without the folder";
  for (const char* const name :
       {"known/klein.off", "cgal/data/meshes/spheres_intersecting.off", "common3d/data/suzanne.obj",
        "cgal/data/meshes/oblong-shuffled.off", "admesh/test/conveyor/basic.stl"}) {
    SCOPED_TRACE(name);
    const Result<MeshFile> file = read_mesh_file(folder / name);
    ASSERT_TRUE(file);
    Mesh mesh = from_indexed(file->mesh);
    cut_all(mesh);
    expect_inherited(mesh, "faces=0 no_self_intersections=on", searched_faces);
  }
}

}  // namespace
}  // namespace ryosen::test
