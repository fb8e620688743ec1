// Random walks of edits, undos and redos: every state is sound, every way back exact.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <random>

#include "ryosen/indexed/from_indexed.h"
#include "ryosen/io/formats.h"
#include "ryosen/mesh/invariants.h"
#include "ryosen/ops/all.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/random_ops.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

// A random operator with random arguments. Those that look at the whole mesh are rare on a large one.
AnyOp random_op(const Mesh& mesh, std::mt19937& random) {
  Dice dice(random());
  const AnyOp op = test::random_op(mesh, dice);
  const bool is_slow = std::holds_alternative<Orient>(op) || std::holds_alternative<Reverse>(op) ||
                       std::holds_alternative<Detach>(op) || std::holds_alternative<Triangulate>(op);
  const bool is_large = mesh.halfedge_slots() > 2000;
  return is_large && is_slow && random() % 100 != 0 ? random_op(mesh, random) : op;
}

struct WalkCount {
  std::size_t done = 0, refused = 0, undone = 0, redone = 0;
  std::map<std::string_view, std::pair<std::size_t, std::size_t>> by_operator;  // done, refused
  std::string last;                                                             // the line of the last that was done
};

void expect_sound(const Mesh& mesh, const std::string& what) {
  const auto broken = check_invariants(mesh);
  ASSERT_FALSE(broken) << what << ": " << broken->rule << ": " << broken->sentence;
}

// One step of the walk; a refused operator must leave no trace.
void step(Mesh& mesh, Journal& journal, std::mt19937& random, WalkCount& count) {
  const auto dice = static_cast<std::uint32_t>(random() % 10);
  if (dice == 0 && journal.can_undo()) {
    journal.undo(mesh);
    ++count.undone;
  } else if (dice == 1 && journal.can_redo()) {
    journal.redo(mesh);
    ++count.redone;
  } else {
    const AnyOp op = random_op(mesh, random);
    // The hash costs the whole mesh: on a large one every hundredth refusal is looked at.
    const bool is_looked_at = mesh.halfedge_slots() <= 2000 || random() % 100 == 0;
    const std::uint64_t before = is_looked_at ? mesh.hash() : 0;
    if (!check(mesh, op).legal()) {
      ++count.refused;
      ++count.by_operator[info_of(op).id].second;
      if (!is_looked_at) return;
      ASSERT_EQ(mesh.hash(), before);
      return;
    }
    count.last = command_of(mesh, op);
    Edit edit(mesh, &journal);
    apply(edit, op);
    if (random() % 8 == 0) return;  // rolled back
    edit.commit();
    ++count.done;
    ++count.by_operator[info_of(op).id].first;
  }
}

void walk(Mesh mesh, const std::string& name, std::uint32_t seed, std::size_t steps, std::uint32_t checked_size,
          WalkCount& count) {
  std::mt19937 random(seed);
  Journal journal;
  const MeshColumns start = mesh.columns();
  for (std::size_t i = 0; i < steps; ++i) {
    ASSERT_NO_FATAL_FAILURE(step(mesh, journal, random, count));
    if (mesh.halfedge_slots() > checked_size && i % 1000 != 0) continue;
    ASSERT_NO_FATAL_FAILURE(
        expect_sound(mesh, name + " seed " + std::to_string(seed) + " step " + std::to_string(i) + " " + count.last));
  }
  ASSERT_NO_FATAL_FAILURE(expect_sound(mesh, name));
  while (journal.can_redo()) journal.redo(mesh);
  const MeshColumns end = mesh.columns();
  while (journal.can_undo()) journal.undo(mesh);
  EXPECT_EQ(mesh.columns(), start) << name << " seed " << seed;
  while (journal.can_redo()) journal.redo(mesh);
  EXPECT_EQ(mesh.columns(), end) << name << " seed " << seed;
}

void report(const WalkCount& count) {
  std::cout << "done " << count.done << ", refused " << count.refused << ", undone " << count.undone << ", redone "
            << count.redone << "\n";
  EXPECT_GT(count.done, 0u);
  EXPECT_GT(count.refused, 0u);
  for (const auto& [id, times] : count.by_operator)
    std::cout << "  " << id << ": done " << times.first << ", refused " << times.second << "\n";
}

TEST(walk, named_shapes) {
  WalkCount count;
  for (std::uint32_t seed = 1; seed <= seed_count(4, 40); ++seed)
    for (const Polygons& faces : {tetrahedron(), cube(), torus_grid(5, 4), two_quads(), closed_fan(6), bow_tie(), fin(),
                                  moebius_strip(), two_tetrahedra_on_an_edge()})
      walk(make_mesh(faces), "shape", seed, is_sample() ? 100 : 400, 2000, count);
  report(count);
}

TEST(walk, random_polygon_meshes) {
  WalkCount count;
  for (std::uint32_t seed = 1; seed <= seed_count(600, 20000); ++seed) {
    const SeededMesh random = seeded_mesh(seed);
    walk(make_mesh(random.faces, random.points), "random", seed, 60, 2000, count);
  }
  report(count);
}

// Meshes with rings, bridges, wires and fans from the start, so that every operator finds something to do.
TEST(walk, random_complexes) {
  WalkCount count;
  for (std::uint32_t seed = 1; seed <= seed_count(600, 20000); ++seed)
    walk(random_complex(seed), "complex", seed, 60, 2000, count);
  report(count);
  if (is_sample()) return;
  for (const OpInfo& info : all_ops()) EXPECT_GT(count.by_operator[info.id].first, 0u) << info.id << " was never done";
}

TEST(walk, real_meshes) {
  WalkCount count;
  std::vector<std::filesystem::path> files{RYOSEN_SOURCE_DIR "/assets/stanford_bunny.obj"};
  const std::filesystem::path shared = RYOSEN_SHARED_DIR "/meshes";
  if (std::filesystem::exists(shared))
    for (const auto& entry : std::filesystem::recursive_directory_iterator(shared))
      if (entry.path().extension() == ".off" || entry.path().extension() == ".obj") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  const std::size_t steps = (is_long_run() ? 1000000 : 40000) / files.size();
  for (const auto& path : files) {
    Result<MeshFile> file = read_mesh_file(path);
    if (!file || file->mesh.corners.empty()) continue;
    walk(from_indexed(std::move(file->mesh)), path.string(), 7, steps, 1000, count);
  }
  report(count);
}

}  // namespace
}  // namespace ryosen
