// Simplification that closes handles and joins parts: what becomes of the topology is counted, and nothing else does.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "ryosen/algo/simplify/simplify.h"
#include "ryosen/analysis/self_intersections.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/live_elements.h"
#include "tests/support/core/asset_mesh.h"
#include "tests/support/core/holed_shapes.h"
#include "tests/support/core/seamed_meshes.h"
#include "tests/support/core/shapes.h"
#include "tests/support/core/simplified.h"

namespace ryosen::test {
namespace {

struct ChangedTopology {
  std::size_t closed = 0, joined = 0;
};

// By a simplifier itself, on a copy.
ChangedTopology counts_of_change(Mesh mesh, std::size_t faces) {
  Simplifier simplifier(mesh, {}, {.faces = faces, .changes_topology = true});
  Progress unheard;
  EXPECT_TRUE(simplifier.run(unheard));
  return {simplifier.closed_handles(), simplifier.joined_parts()};
}

// Nothing but handles and parts has changed, by as many as were counted; and it is undone to the byte.
void expect_counted(const Mesh& before, Mesh& mesh, Journal& journal, const ChangedTopology& changed,
                    const std::string& name) {
  const auto broken = check_invariants(mesh);
  ASSERT_FALSE(broken) << name << ": " << broken->sentence;
  const Figures was = compute_figures(before), is = compute_figures(mesh);
  EXPECT_EQ(is[ProblemKind::nonmanifold_edge], was[ProblemKind::nonmanifold_edge]) << name;
  EXPECT_EQ(is[ProblemKind::misoriented_edge], was[ProblemKind::misoriented_edge]) << name;
  EXPECT_EQ(is[ProblemKind::nonmanifold_vertex], was[ProblemKind::nonmanifold_vertex]) << name;
  EXPECT_EQ(is.boundary_loops, was.boundary_loops) << name;
  EXPECT_LE(is[ProblemKind::duplicate_face], was[ProblemKind::duplicate_face]) << name;
  EXPECT_EQ(is.components, was.components - changed.joined) << name;
  EXPECT_EQ(is.euler_characteristic, was.euler_characteristic + 2 * static_cast<std::int64_t>(changed.closed) -
                                         2 * static_cast<std::int64_t>(changed.joined))
      << name;
  if (!journal.can_undo()) return;
  const MeshColumns after = mesh.columns();
  journal.undo(mesh);
  EXPECT_EQ(mesh.columns(), before.columns()) << name;
  journal.redo(mesh);
  EXPECT_EQ(mesh.columns(), after) << name;
}

AlgorithmResult expect_change(const Mesh& before, Mesh& mesh, std::size_t faces, const std::string& name) {
  Journal journal;
  AlgorithmResult result =
      run_algorithm(mesh, journal, "simplify topology=change force=on faces=" + std::to_string(faces));
  expect_counted(before, mesh, journal, counts_of_change(before, faces), name);
  return result;
}

TEST(simplify_topology, makes_a_sphere_of_a_torus) {
  const IndexedMesh tori[] = {torus_at_places(48, 24, 2, 0.7), torus_at_places(64, 12, 2, 0.15),
                              torus_at_places(30, 30, 1, 0.8), torus_at_places(12, 8, 3, 1),
                              torus_at_places(7, 9, 5, 0.5)};
  for (const IndexedMesh& source : tori) {
    const Mesh before = from_indexed(source);
    const std::string name = std::to_string(before.live().faces);
    Mesh kept = before, mesh = before;
    const AlgorithmResult stopped = test::simplified(kept, "faces=8 force=on");
    EXPECT_EQ(stopped.goal_report->stopped, Stop::blocked) << name;
    EXPECT_GE(kept.live().faces, 14u) << "a torus has no fewer";
    EXPECT_EQ(*compute_figures(kept).genus, 1) << name;
    EXPECT_NE(stopped.text.en.find("One handle is left; topology=change closes it."), std::string::npos)
        << stopped.text.en;
    const AlgorithmResult result = expect_change(before, mesh, 8, name);
    EXPECT_EQ(result.goal_report->stopped, Stop::goal) << name;
    EXPECT_LE(mesh.live().faces, 8u) << name;
    EXPECT_EQ(surface_name(compute_figures(mesh))->en, "sphere") << name;
    EXPECT_NE(result.text.en.find("One handle was closed."), std::string::npos) << result.text.en;
  }
}

TEST(simplify_topology, closes_every_hole_of_a_plate) {
  for (const std::uint32_t holes : {1u, 2u, 3u, 5u, 8u}) {
    const Mesh before = from_indexed(plate_with_holes(holes));
    Mesh mesh = before;
    const AlgorithmResult result = expect_change(before, mesh, 8, std::to_string(holes) + " holes");
    EXPECT_EQ(result.goal_report->stopped, Stop::goal) << holes;
    const std::int64_t genus = *compute_figures(mesh).genus;
    EXPECT_EQ(counts_of_change(before, 8).closed, holes - static_cast<std::uint32_t>(genus)) << holes;
    EXPECT_LE(genus, 1) << "eight faces have no room for more";
  }
}

TEST(simplify_topology, closes_no_more_than_is_needed) {
  const Mesh before = from_indexed(plate_with_holes(5));
  Mesh kept = before;
  test::simplified(kept, "faces=0 force=on");
  const std::size_t least = kept.live().faces;
  for (const std::size_t faces : {least + 20, least}) {
    Mesh mesh = before;
    expect_change(before, mesh, faces, std::to_string(faces));
    EXPECT_EQ(*compute_figures(mesh).genus, 5) << faces;
  }
  Mesh mesh = before;
  expect_change(before, mesh, least - 6, "a little fewer");
  EXPECT_GE(*compute_figures(mesh).genus, 2);
}

TEST(simplify_topology, joins_parts_that_lie_near_each_other) {
  const std::uint32_t counts[] = {2, 5, 20, 50, 100};
  for (const std::uint32_t count : counts) {
    const Mesh before = from_indexed(rows_of_spheres(count, 2.5));
    Mesh kept = before, mesh = before;
    const AlgorithmResult stopped = test::simplified(kept, "faces=" + std::to_string(2 * count));
    EXPECT_NE(stopped.goal_report->stopped, Stop::goal) << count;
    EXPECT_GE(kept.live().faces, 4 * count) << "each part has four";
    EXPECT_NE(stopped.text.en.find(std::to_string(count) + " parts are left; topology=change joins closed ones"),
              std::string::npos)
        << stopped.text.en;
    const AlgorithmResult result = expect_change(before, mesh, 2 * count, std::to_string(count));
    EXPECT_EQ(result.goal_report->stopped, Stop::goal) << count;
    EXPECT_LE(mesh.live().faces, 2 * count);
    EXPECT_LT(compute_figures(mesh).components, count);
    EXPECT_NE(result.text.en.find("joined"), std::string::npos) << result.text.en;
  }
}

TEST(simplify_topology, joins_each_part_once_however_they_lie) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Mesh before = from_indexed(scattered_spheres(40, seed));
    for (const std::size_t faces : {120u, 60u, 4u}) {
      Mesh mesh = before;
      const AlgorithmResult result = expect_change(before, mesh, faces, "seed " + std::to_string(seed));
      EXPECT_EQ(result.goal_report->stopped, Stop::goal) << seed << " " << faces;
      EXPECT_EQ(*compute_figures(mesh).genus, 0) << seed << " " << faces;
    }
  }
}

TEST(simplify_topology, leaves_boundaries_and_what_is_locked) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Mesh before = from_indexed(torn_torus(12, seed));
    Mesh mesh = before, locked = before;
    expect_change(before, mesh, 0, "seed " + std::to_string(seed));
    test::simplified(locked, "faces=0 topology=change force=on lock=v3,v50,v77,v120,v160");
    for (const Vertex v : {Vertex(3), Vertex(50), Vertex(77), Vertex(120), Vertex(160)}) {
      ASSERT_TRUE(locked.is_alive(v)) << seed;
      EXPECT_EQ(locked.position(v), before.position(v)) << seed;
    }
    EXPECT_FALSE(check_invariants(locked)) << seed;
  }
}

TEST(simplify_topology, joins_nothing_farther_apart_than_the_shape_allows) {
  const Mesh before = from_indexed(rows_of_spheres(2, 40));
  Mesh kept = before, forced = before;
  const AlgorithmResult result = test::simplified(kept, "faces=6 topology=change");
  EXPECT_EQ(result.goal_report->stopped, Stop::shape);
  EXPECT_NE(result.text.en.find("parts that are left lie too far"), std::string::npos) << result.text.en;
  EXPECT_EQ(compute_figures(kept).components, 2u);
  EXPECT_EQ(test::simplified(forced, "faces=6 topology=change force=on").goal_report->stopped, Stop::goal);
  EXPECT_EQ(compute_figures(forced).components, 1u);
  Mesh by_error = before;
  test::simplified(by_error, "error=3 topology=change");
  EXPECT_EQ(compute_figures(by_error).components, 2u) << "half of their distance is more";
}

TEST(simplify_topology, leaves_surfaces_that_are_cut_apart_as_sound_as_they_were) {
  for (const char* const name :
       {"klein_bottle.off", "moebius.off", "projective_plane.off", "misoriented.obj", "fin.obj"}) {
    const Mesh before = asset_mesh(name);
    Mesh mesh = before;
    expect_change(before, mesh, 0, name);
  }
}

TEST(simplify_topology, is_counted_on_any_mesh) {
  for (std::uint64_t seed = 1; seed <= 300 && !testing::Test::HasFailure(); ++seed) {
    const SeededMesh seeded = seeded_mesh(seed);
    const Mesh before = make_mesh(seeded.faces, seeded.points);
    if (before.live().faces == 0) continue;
    Mesh mesh = before;
    expect_change(before, mesh, 0, "seed " + std::to_string(seed));
  }
}

TEST(simplify_topology, carries_values_along) {
  Mesh before = from_indexed(torus_at_places(24, 12, 2, 0.5));
  std::size_t materials = 0, weights = 0, corners = 0, edges = 0;
  {
    Edit edit(before, nullptr);
    materials = edit.add_attribute<std::int32_t>("material", ElementKind::face, ValueRule::first, 7);
    weights = edit.add_attribute<double>("weight", ElementKind::vertex, ValueRule::blend, 0.25);
    corners = edit.add_attribute<double>("corner", ElementKind::corner, ValueRule::blend, 0.5);
    edges = edit.add_attribute<std::int32_t>("crease", ElementKind::edge, ValueRule::greatest, 3);
    edit.commit();
  }
  Mesh mesh = before;
  expect_change(before, mesh, 8, "torus");
  for (const Face f : live_faces(mesh))
    EXPECT_EQ(attribute_value<std::int32_t>(mesh.attributes()[materials], f.index), 7);
  for (const Vertex v : live_vertices(mesh)) {
    EXPECT_EQ(attribute_value<double>(mesh.attributes()[weights], v.index), 0.25);
    for (const Halfedge h : outgoing(mesh, v)) {
      EXPECT_EQ(attribute_value<double>(mesh.attributes()[corners], h.index), 0.5);
      EXPECT_EQ(attribute_value<std::int32_t>(mesh.attributes()[edges], edge(h).index), 3);
    }
  }
  const Mesh textured = seamed_sphere(16);
  Mesh two = textured;
  expect_change(textured, two, 3, "seamed sphere");
}

TEST(simplify_topology, leaves_no_trace_where_it_is_cancelled) {
  Mesh mesh = from_indexed(plate_with_holes(3));
  const MeshColumns before = mesh.columns();
  const AlgorithmRow& row = *find_algorithm("simplify");
  const ParameterValues values =
      *read_values(row.parameters, split_words("faces=4 topology=change force=on")).values->on(mesh).values;
  std::size_t cancelled = 0;
  for (int reports = 0; reports < 60; ++reports) {
    int left = reports;
    Progress cancelling([&](double) { return left-- > 0; }, Progress::Clock::duration::zero());
    Journal journal;
    Edit edit(mesh, &journal);
    const AlgorithmResult result = row.run(edit, {values}, cancelling);
    if (result.goal_report->stopped != Stop::cancelled) continue;
    ++cancelled;
    EXPECT_EQ(result.changed, 0u);
    EXPECT_EQ(mesh.columns(), before);
  }
  EXPECT_GT(cancelled, 10u);
}

TEST(simplify_topology, cannot_keep_faces_apart) {
  Mesh mesh = from_indexed(torus_at_places(12, 8, 3, 1));
  const AlgorithmResult result = test::simplified(mesh, "faces=8 topology=change no_self_intersections=on");
  ASSERT_TRUE(result.fault);
  EXPECT_NE(result.fault->en.find("no_self_intersections"), std::string::npos);
  EXPECT_EQ(result.changed, 0u);
}

}  // namespace
}  // namespace ryosen::test
