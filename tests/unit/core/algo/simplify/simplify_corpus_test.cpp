// Simplification of many meshes that nobody here made, each to no faces or as far as it goes.
#include <gtest/gtest.h>

#include <filesystem>

#include "ryosen/algo/algorithm_table.h"
#include "ryosen/algo/simplify/simplifier.h"
#include "ryosen/algo/simplify/simplify.h"
#include "ryosen/io/formats.h"
#include "ryosen/ops/all.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/simplified.h"

namespace ryosen::test {
namespace {

// Every hundred collapses; and back to the bytes of the beginning.
void expect_sound_on_the_way(const Mesh& mesh, const std::string& name) {
  const ParameterValues values =
      *read_values(find_algorithm("simplify")->parameters, split_words("faces=0")).values->on(mesh).values;
  Progress unheard;
  const BuiltLevels built = build_levels(mesh, {values}, unheard);
  if (!built.levels) return;
  const MeshColumns before = built.levels->mesh().columns();
  for (std::size_t level = 100; level < built.levels->last(); level += 100) {
    built.levels->go_to(level);
    const auto broken = check_invariants(built.levels->mesh());
    ASSERT_FALSE(broken) << name << " after " << level << ": " << broken->sentence;
  }
  built.levels->go_to(0);
  EXPECT_EQ(built.levels->mesh().columns(), before) << name;
}

void expect_unchanged_where_cancelled(Mesh mesh, int reports, const std::string& name) {
  const MeshColumns before = mesh.columns();
  Journal journal;
  Progress cancelling([&](double) { return reports-- > 0; }, Progress::Clock::duration::zero());
  const AlgorithmRow& row = *find_algorithm("simplify");
  {
    Edit edit(mesh, &journal);
    row.run(edit, {*read_values(row.parameters, split_words("faces=0")).values->on(mesh).values}, cancelling);
  }
  EXPECT_EQ(mesh.columns(), before) << name;
}

// What is blocked is refused where its quadrics are lowest, too, by the kernel and its warnings.
void expect_refused_where_lowest(Mesh mesh, const std::string& name) {
  const Mesh input = mesh;
  Simplifier simplifier(mesh, {}, {.lets_boundaries_go = true}, nullptr, &input);
  Progress unheard;
  ASSERT_TRUE(simplifier.run(unheard)) << name;
  const CollapseSurface::Standstill still = simplifier.standstill();
  for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
    const Edge e(i);
    if (!mesh.is_alive(e) || mesh.is_wire(e)) continue;
    const Halfedge h = halfedge(e);
    // A point with copies stays where it is, and what has no place too.
    if (has_copies(mesh, mesh.from(h)) || has_copies(mesh, mesh.to(h))) continue;
    if (!is_finite(mesh.position(mesh.from(h))) || !is_finite(mesh.position(mesh.to(h)))) continue;
    for (const Halfedge way : {h, twin(h)}) {
      const CollapseEdge op{way, CollapseEdge::Place::point, simplifier.lowest_place(e)};
      EXPECT_TRUE(is_refused_plainly(mesh, op)) << name << ": " << command_of(mesh, op);
    }
  }
}

// Of the folder of meshes beside the project, where it is there.
TEST(simplify_corpus, goes_as_far_on_every_mesh_and_is_sound_on_the_way) {
  const std::filesystem::path folder = RYOSEN_SHARED_DIR "/meshes";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "without the folder";
  std::size_t meshes = 0, large_files = 0;
  Dice dice(7);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    // A short run takes one of eight large files.
    constexpr std::uintmax_t large = 40'000;
    if (!entry.is_regular_file() || (entry.file_size() > large && !is_long_run() && large_files++ % 8 != 0)) continue;
    const Result<MeshFile> file = read_mesh_file(entry.path());
    if (!file) continue;
    // The kernel only warns of a seam, which here holds its tip.
    const bool has_seams = !file->mesh.texcoords.index.empty() || !file->mesh.normals.index.empty();
    const Mesh mesh = from_indexed(file->mesh);
    const std::string name = entry.path().string();
    go_all_the_way(mesh, name, !has_seams);
    if (!has_seams) expect_refused_where_lowest(mesh, name);
    expect_sound_on_the_way(mesh, name);
    expect_unchanged_where_cancelled(mesh, dice.below(50), name);
    ++meshes;
  }
  EXPECT_GT(meshes, 100u);
}

}  // namespace
}  // namespace ryosen::test
