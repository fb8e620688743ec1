// The figures of real and constructed mesh files, where the folder of such files exists: what is written and read again
// has the same. tests/cli/check_truth_test.cpp holds them against what is known of the files.
#include <gtest/gtest.h>

#include <filesystem>

#include "ryosen/analysis/figures.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/indexed/to_indexed.h"
#include "ryosen/io/formats.h"

namespace ryosen {
namespace {

namespace fs = std::filesystem;

void expect_same_again(const fs::path& folder) {
  if (!fs::exists(folder)) return;
  int compared = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file() || !format_of_extension(entry.path())) continue;
    SCOPED_TRACE(entry.path().string());
    const Result<MeshFile> file = read_mesh_file(entry.path());
    if (!file) continue;
    const IndexedMesh& source = file->mesh;
    const Mesh mesh = from_indexed(source);
    const IndexedMesh back = to_indexed(mesh, file_tables(source)).mesh;
    EXPECT_EQ(back.corners, source.corners);
    EXPECT_EQ(back.face_offsets, source.face_offsets);
    EXPECT_TRUE(compute_figures(mesh, source.quarantine) == compute_figures(from_indexed(back), back.quarantine));
    ++compared;
  }
  EXPECT_GT(compared, 0);
}

TEST(figures_of_files, are_the_same_once_written_and_read_again) {
  expect_same_again(fs::path(RYOSEN_SHARED_DIR) / "meshes");
}

}  // namespace
}  // namespace ryosen
