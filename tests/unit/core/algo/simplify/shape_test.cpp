// Simplification that stops before the shape is lost, and what goes on.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "ryosen/algo/simplify/simplify.h"
#include "ryosen/analysis/measure/distance.h"
#include "ryosen/ops/orient.h"
#include "tests/support/core/asset_mesh.h"
#include "tests/support/core/holed_shapes.h"
#include "tests/support/core/simplified.h"

namespace ryosen::test {
namespace {

struct NamedMesh {
  std::string name;
  Mesh mesh;
};

// Meshes whose handles keep more faces than is asked for.
std::vector<NamedMesh> handled_meshes() {
  std::vector<NamedMesh> meshes;
  for (const std::uint32_t holes : {1u, 2u, 3u, 4u, 5u})
    meshes.push_back({std::to_string(holes) + " holes", from_indexed(plate_with_holes(holes))});
  return meshes;
}

double rms_share(const Mesh& input, const Mesh& made) {
  Progress unheard;
  const SurfaceDistance distance = *surface_distance(input, made, {.gap = 1}, unheard);
  return distance.rms / distance.diagonal;
}

double input_diagonal(const Mesh& mesh) {
  const auto bounds = *compute_figures(mesh).bounds;
  return glm::length(bounds[1] - bounds[0]);
}

TEST(simplify_shape, stops_while_handles_still_look_like_the_input) {
  for (const auto& [name, input] : handled_meshes()) {
    Mesh kept = input, forced = input;
    Journal journal;
    const AlgorithmResult result = run_algorithm(kept, journal, "simplify faces=8");
    EXPECT_EQ(result.goal_report->stopped, Stop::shape) << name;
    EXPECT_FALSE(result.goal_report->is_reached) << name;
    EXPECT_GT(count_of(result, EdgeRule::error), 0u) << name;
    EXPECT_EQ(count_of(result, EdgeRule::free), 0u) << name;
    EXPECT_NE(result.text.en.find("lose the shape"), std::string::npos) << result.text.en;
    EXPECT_NE(result.text.en.find("force"), std::string::npos) << result.text.en;
    EXPECT_NE(result.text.ja.find("force"), std::string::npos) << result.text.ja;
    test::expect_kept(input, kept, journal, name);
    EXPECT_LT(rms_share(input, kept), 0.04) << name;
    EXPECT_LT(kept.live().faces, input.live().faces / 3) << name;
    const AlgorithmResult further = simplified(forced, "faces=8 force=on");
    EXPECT_EQ(further.goal_report->stopped, Stop::blocked) << name;
    EXPECT_LT(forced.live().faces, kept.live().faces) << name;
    EXPECT_GT(*further.goal_report->error_max, *result.goal_report->error_max) << name;
    EXPECT_GT(*further.goal_report->error_max, JumpLimit::share_of_size * input_diagonal(input)) << name;
  }
}

TEST(simplify_shape, goes_on_where_nothing_holds_handles_or_parts) {
  const NamedMesh meshes[] = {{"bunny", asset_mesh("stanford_bunny.obj")},
                              {"ball", asset_mesh("ball.off")},
                              {"thick torus", from_indexed(torus_at_places(48, 24, 2, 0.7))},
                              {"sheet", sheet(20, wave)},
                              {"spheres", from_indexed(rows_of_spheres(20, 3))}};
  for (const auto& [name, input] : meshes)
    for (const char* const ratio : {"0.5", "0.1", "0.02"}) {
      Mesh mesh = input, forced = input;
      const AlgorithmResult result = simplified(mesh, std::string("ratio=") + ratio + " triangulate=on");
      EXPECT_NE(result.goal_report->stopped, Stop::shape) << name << " " << ratio;
      simplified(forced, std::string("ratio=") + ratio + " triangulate=on force=on");
      EXPECT_EQ(mesh.columns(), forced.columns()) << name << " " << ratio;
    }
}

TEST(simplify_shape, does_not_matter_to_a_goal_by_error) {
  for (const auto& [name, input] : handled_meshes()) {
    Mesh by_error = input, forced = input;
    const AlgorithmResult result = simplified(by_error, "faces=8 error=1000");
    EXPECT_EQ(result.goal_report->stopped, Stop::blocked) << name;
    simplified(forced, "faces=8 force=on");
    EXPECT_EQ(by_error.columns(), forced.columns()) << name;
    Mesh by_share = input;
    const AlgorithmResult alone = simplified(by_share, "error=20%");
    EXPECT_NE(alone.goal_report->stopped, Stop::shape) << name;
  }
}

TEST(simplify_shape, stops_at_a_cube_whose_next_collapse_costs_all_at_once) {
  Mesh mesh = made_by("cube");
  Journal journal;
  run_algorithm(mesh, journal, "subdivide scheme=midpoint steps=3");
  const AlgorithmResult result = run_algorithm(mesh, journal, "simplify faces=6 triangulate=on");
  EXPECT_EQ(result.goal_report->stopped, Stop::shape);
  EXPECT_EQ(mesh.live().faces, 12u) << "a cube needs no more";
  EXPECT_LT(*result.goal_report->error_max, 1e-6);
}

TEST(simplify_shape, leaves_a_mesh_most_of_which_is_misoriented_to_orient) {
  for (const std::uint32_t side : {3u, 4u, 5u, 8u, 13u}) {
    Mesh mesh = from_indexed(checkered_sheet(side));
    const MeshColumns before = mesh.columns();
    const Figures figures = compute_figures(mesh);
    ASSERT_GT(2 * figures[ProblemKind::misoriented_edge], figures.edges) << side;
    const AlgorithmResult result = simplified(mesh, "faces=4");
    EXPECT_EQ(result.goal_report->stopped, Stop::shape) << side;
    EXPECT_FALSE(result.goal_report->is_reached) << side;
    EXPECT_EQ(result.changed, 0u) << side;
    EXPECT_EQ(mesh.columns(), before) << side;
    const std::vector<std::size_t>& remaining = result.goal_report->remaining;
    EXPECT_EQ(std::accumulate(remaining.begin(), remaining.end(), std::size_t{0}), figures.edges) << side;
    const std::string counts = std::to_string(figures[ProblemKind::misoriented_edge]) + " of " +
                               std::to_string(figures.edges) + " edges are misoriented";
    EXPECT_NE(result.text.en.find(counts), std::string::npos) << result.text.en;
    EXPECT_NE(result.text.en.find("orient turns"), std::string::npos) << result.text.en;
    EXPECT_NE(result.text.ja.find("orient"), std::string::npos) << result.text.ja;
    EXPECT_EQ(simplified(mesh, "faces=4 error=1").goal_report->stopped, Stop::blocked) << side;
    EXPECT_EQ(simplified(mesh, "faces=4 force=on").goal_report->stopped, Stop::blocked) << side;
    Edit edit(mesh, nullptr);
    Orient{}.apply(edit);
    edit.commit();
    EXPECT_EQ(simplified(mesh, "faces=4").goal_report->stopped, Stop::goal) << side;
    EXPECT_LE(mesh.live().faces, 4u) << side;
  }
}

TEST(simplify_shape, is_no_question_of_a_few_misoriented_edges) {
  IndexedMesh source = torus_at_places(24, 12, 2, 0.7);
  for (std::size_t corner = 0; corner < 30; corner += 6) std::swap(source.corners[corner], source.corners[corner + 1]);
  Mesh mesh = from_indexed(source);
  const AlgorithmResult result = simplified(mesh, "faces=4");
  EXPECT_GT(result.changed, 0u);
  EXPECT_LT(mesh.live().faces, 120u);
  EXPECT_NE(result.goal_report->stopped, Stop::goal);
  if (result.goal_report->stopped != Stop::shape) return;
  EXPECT_NE(result.text.en.find("misoriented; orient may mend"), std::string::npos) << result.text.en;
}

}  // namespace
}  // namespace ryosen::test
