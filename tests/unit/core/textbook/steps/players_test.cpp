// What is played on a mesh: every row plays on the small meshes and refuses what does not fit.
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "ryosen/textbook/steps/all.h"
#include "tests/support/core/asset_mesh.h"
#include "tests/support/core/played_steps.h"
#include "tests/support/core/shapes.h"
#include "tests/support/core/step_checks.h"

namespace ryosen {
namespace {

using namespace test;

TEST(steps, every_row_plays_on_the_small_meshes) {
  std::map<std::string, int> count;
  for (const char* const name :
       {"tetrahedron.off", "fan.obj", "cube.obj", "two_quads.obj", "three_tri_edge.off", "bow_tie.obj", "moebius.off",
        "isolated_vertex.obj", "hanging_pair.obj", "torus.off", "misoriented.obj", "collinear.obj",
        "figures/000-4b.obj", "figures/000-5b.obj", "figures/000-14.obj", "figures/000-15.obj",
        "figures/003-image24.obj", "projective_plane.off"}) {
    const Mesh mesh = asset_mesh(name);
    for (const steps::StepsRow& row : steps::all_steps()) {
      for (const std::vector<std::string>& arguments : row.choices(mesh, {})) {
        SCOPED_TRACE(std::string(name) + " " + std::string(row.id) + (arguments.empty() ? "" : " " + arguments[0]));
        const auto sequence = row.make(mesh, arguments);
        ASSERT_TRUE(sequence.ok()) << sequence.failure().message.text.en;
        expect_plays(**sequence);
        EXPECT_TRUE((*sequence)->edits() || (*sequence)->mesh_at(0).hash() == mesh.hash());
        ++count[std::string(row.id)];
      }
    }
  }
  for (const steps::StepsRow& row : steps::all_steps())
    EXPECT_GE(count[std::string(row.id)], row.plays_script ? 0 : 4) << row.id;
}

TEST(steps, arguments_that_do_not_fit_are_usage_in_both_languages) {
  const Mesh mesh = make_mesh(tetrahedron());
  const std::vector<std::pair<std::string, PlayArguments>> wrong = {{"build", {"x"}},
                                                                    {"pair", {}},
                                                                    {"pair", {"sort"}},
                                                                    {"pair", {"nonsense"}},
                                                                    {"collapse", {}},
                                                                    {"collapse", {"0-9"}},
                                                                    {"swap", {"x"}},
                                                                    {"split3", {}},
                                                                    {"split3", {"x"}},
                                                                    {"split3", {"12"}},
                                                                    {"split3", {"1,"}},
                                                                    {"walk", {}},
                                                                    {"walk", {"v9"}},
                                                                    {"loop", {"f9"}},
                                                                    {"loop", {"f0", "f1"}},
                                                                    {"relation", {"vertex_faces"}},
                                                                    {"relation", {"x", "v0"}},
                                                                    {"relation", {"edge_faces", "v0"}},
                                                                    {"relation", {"vertex_faces", "f0"}},
                                                                    {"hull", {"x"}},
                                                                    {"hull", {"random", "x"}},
                                                                    {"hull", {"farthest", "1"}},
                                                                    {"hull", {"project=w"}},
                                                                    {"hull", {"project=x", "random"}}};
  for (const auto& [id, arguments] : wrong) {
    const auto sequence = play_or_refuse(id, mesh, arguments);
    ASSERT_FALSE(sequence.ok()) << id;
    EXPECT_EQ(sequence.failure().exit_code, ExitCode::usage) << id;
    EXPECT_NE(sequence.failure().message.text.en, sequence.failure().message.text.ja) << id;
  }
  for (const auto& [id, arguments] : std::vector<std::pair<std::string, PlayArguments>>{
           {"collapse", {"0-1"}}, {"swap", {"0-1"}}, {"split3", {"1"}}}) {
    const auto sequence = play_or_refuse(id, make_mesh(cube()), arguments);
    ASSERT_FALSE(sequence.ok()) << id;
    EXPECT_EQ(sequence.failure().exit_code, ExitCode::refused) << id;
  }
  EXPECT_EQ(play_or_refuse("build", Mesh(), {}).failure().exit_code, ExitCode::refused);
}

}  // namespace
}  // namespace ryosen
