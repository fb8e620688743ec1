// Commands on meshes with many copies of a point, within a limit of processor time that a cost of their square would
// break. How costs grow is measured by tests/bench/bench_growth.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdlib>

#include "ryosen/io/formats.h"
#include "tests/support/app/program.h"
#include "tests/support/core/ugly_meshes.h"

namespace ryosen::test {
namespace {

class Growth : public testing::Test {
 protected:
  // The exit code of the program, or -1 where the limit ended it.
  int run_within(int seconds, const IndexedMesh& mesh, const std::string& command, const std::string& flags) {
    MeshFile file;
    file.mesh = mesh;
    const std::string path = folder_.at("mesh.ply");
    EXPECT_TRUE(write_mesh_file(path, file));
    const std::string line = "ulimit -t " + std::to_string(seconds) + "; " + shell_program() + " " + command + " " +
                             path + " " + flags + " >/dev/null 2>&1";
    const int status = std::system(line.c_str());
    return WIFEXITED(status) && WEXITSTATUS(status) < 128 ? WEXITSTATUS(status) : -1;
  }

  TemporaryFolder folder_;
};

constexpr int seconds = 4;

glm::dvec3 on_circle(double turns) { return {std::cos(2 * 3.14159265 * turns), std::sin(2 * 3.14159265 * turns), 0}; }

TEST_F(Growth, verdicts_on_every_edge) {
  for (const std::string op : {"collapse", "swap"}) {
    EXPECT_EQ(run_within(seconds, equal_triangles(200), "why", "--op " + op + " --all"), 0) << op;
    EXPECT_EQ(run_within(seconds, book(150), "why", "--op " + op + " --all"), 0) << op;
  }
  EXPECT_EQ(run_within(seconds, voxel_block(128), "why", "--op collapse --all"), 0);
}

TEST_F(Growth, remedies) {
  EXPECT_EQ(run_within(seconds, equal_triangles(4000), "edit", "--do 'weld 0 1'"), 6);
  EXPECT_EQ(run_within(seconds, flat_chain(4000), "why", "--op make_loop --all"), 0);  // turned it has one long cycle
}

TEST_F(Growth, repairs_at_many_copies) {
  EXPECT_EQ(run_within(seconds, equal_triangles(2000), "repair", ""), 0);
  EXPECT_EQ(run_within(seconds, book(2000), "repair", ""), 0);
}

// A command on all elements of a kind, and its undo.
struct OnAll {
  IndexedMesh (*mesh)(std::uint32_t n);
  std::uint32_t n;
  const char *mode, *op;
  int exit_code = 0;
  const char* flags = "";
};

class GrowthOnAll : public Growth, public testing::WithParamInterface<OnAll> {};

TEST_P(GrowthOnAll, is_as_quick_as_its_elements_by_themselves) {
  const auto& [mesh, n, mode, op, exit_code, flags] = GetParam();
  const std::string line = std::string("mode ") + mode + "; select all; " + op + " selected; undo";
  EXPECT_EQ(run_within(seconds, mesh(n), "edit", "--do '" + line + "' " + flags), exit_code) << line;
}

INSTANTIATE_TEST_SUITE_P(
    , GrowthOnAll,
    testing::Values(OnAll{book, 8000, "face", "delete"}, OnAll{equal_triangles, 8000, "face", "delete"},
                    OnAll{apex_soup, 8000, "face", "delete"}, OnAll{apex_soup, 8000, "edge", "delete"},
                    OnAll{book, 16000, "face", "weld", 6}, OnAll{book, 4000, "edge", "weld", 6},
                    OnAll{equal_triangles, 4000, "face", "weld"}, OnAll{apex_soup, 8000, "vertex", "weld"},
                    OnAll{book, 16000, "edge", "extrude_edges"}, OnAll{equal_triangles, 24000, "face", "poke", 6},
                    OnAll{equal_triangles, 16000, "face", "delete_loop"},
                    OnAll{large_face, 20000, "vertex", "unite_edge"}, OnAll{book, 20000, "vertex", "unite_edge", 6},
                    OnAll{fan, 12000, "vertex", "dissolve"}, OnAll{fan, 10000, "edge", "unite_loop"},
                    OnAll{clean_grid, 16000, "edge", "unite_loop"}, OnAll{bipyramid, 16000, "edge", "dissolve"},
                    OnAll{bipyramid, 16000, "vertex", "dissolve"}, OnAll{book_of_squares, 16000, "face", "triangulate"},
                    OnAll{bipyramid, 16000, "face", "delete", 0, "--strict"},
                    OnAll{apex_soup, 8000, "edge", "delete", 0, "--strict"}, OnAll{book, 20000, "edge", "weld", 6},
                    OnAll{large_face, 40000, "vertex", "weld"}, OnAll{book_of_squares, 16000, "face", "weld"},
                    OnAll{fan, 32000, "edge", "collapse"}, OnAll{bipyramid, 32000, "edge", "collapse"}),
    [](const auto& info) {
      return std::string(info.param.op) + "_every_" + info.param.mode + "_" + std::to_string(info.index);
    });

// n triangles over each other, tilted alike, so that the box of each meets those of all.
IndexedMesh tilted_pile(std::uint32_t n) {
  IndexedMesh mesh;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double z = i / 8192.0;
    mesh.positions.insert(mesh.positions.end(), {{0, 0, z}, {1, 0, z + 1}, {0, 1, z + 1}});
    mesh.corners.insert(mesh.corners.end(), {3 * i, 3 * i + 1, 3 * i + 2});
    mesh.face_offsets.push_back(3 * i + 3);
  }
  return mesh;
}

// Faces that cross or lie on each other, of which one pair is enough, and two repairs.
TEST_F(Growth, refusals_and_repairs_on_many_overlaps) {
  EXPECT_EQ(run_within(seconds, equal_triangles(4000), "simplify", "--ratio 0.1 --no-self-intersections"), 1);
  EXPECT_EQ(run_within(seconds, equal_triangles(4000), "remesh", "--length 20%"), 0);
  for (const auto family : {equal_triangles, book, fan, apex_soup, spokes_on_a_line})
    EXPECT_GE(run_within(seconds, family(4000), "repair", "--kinds stitch"), 0);
  EXPECT_GE(run_within(seconds, seams_at_a_point(32000), "repair", "--kinds stitch"), 0);
  for (const auto family : {book, apex_soup})
    EXPECT_GE(run_within(seconds, family(8000), "repair", "--kinds orient"), 0);
  EXPECT_GE(run_within(seconds, tilted_pile(16000), "repair", "--kinds orient"), 0);
}

// Faces on each other, with points of their own: in turned directions, with four corners, moved a little, each larger
// than the one before, turned in their plane.
TEST_F(Growth, refusals_on_soups_of_alike_faces) {
  using Place = glm::dvec3 (*)(double face, double corner);
  constexpr std::uint32_t faces = 16000;
  const std::pair<std::uint32_t, Place> soups[] = {
      {3, [](double f, double c) { return on_circle(std::fmod(f, 2) == 0 ? c / 3 : -c / 3); }},
      {4, [](double, double c) { return on_circle(c / 4); }},
      {3, [](double f, double c) { return on_circle(c / 3) + glm::dvec3(f * 1e-6, 0, 0); }},
      {3, [](double f, double c) { return on_circle(c / 3) * (1 + f * 1e-4); }},
      {3, [](double f, double c) { return on_circle(c / 3 + f * 0.1); }}};
  for (const auto& [corners, place] : soups) {
    IndexedMesh mesh;
    for (std::uint32_t i = 0; i < corners * faces; ++i) {
      mesh.corners.push_back(i);
      mesh.positions.push_back(place(i / corners, i % corners));
    }
    for (std::uint32_t f = 1; f <= faces; ++f) mesh.face_offsets.push_back(corners * f);
    EXPECT_EQ(run_within(seconds, mesh, "simplify", "--ratio 0.1 --no-self-intersections"), corners == 3 ? 1 : 6);
    EXPECT_GE(run_within(seconds, mesh, "simplify", "--ratio 0.1"), 0);
  }
}

}  // namespace
}  // namespace ryosen::test
