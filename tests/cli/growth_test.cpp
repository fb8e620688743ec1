// Commands on meshes with many copies of a point, within a limit of processor time that a cost of their square would
// break. How costs grow is measured by tests/bench/bench_growth.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>

#include "core/io/formats.h"
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

}  // namespace
}  // namespace ryosen::test
