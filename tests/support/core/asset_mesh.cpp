#include "tests/support/core/asset_mesh.h"

#include <gtest/gtest.h>

#include "core/indexed/from_indexed.h"
#include "core/io/formats.h"

namespace ryosen::test {

namespace {

Mesh mesh_of_file(const std::string& path) {
  Result<MeshFile> file = read_mesh_file(path);
  EXPECT_TRUE(file) << path;
  return file ? from_indexed(std::move(file->mesh)) : Mesh();
}

}  // namespace

Mesh asset_mesh(const std::string& name) { return mesh_of_file(RYOSEN_SOURCE_DIR "/assets/" + name); }

Mesh report_mesh(const std::string& name) { return mesh_of_file(RYOSEN_SOURCE_DIR "/tests/data/reports/" + name); }

}  // namespace ryosen::test
