#include "tests/support/core/asset_mesh.h"

#include <gtest/gtest.h>

#include "ryosen/indexed/from_indexed.h"
#include "ryosen/io/formats.h"

namespace ryosen::test {

namespace {

IndexedMesh list_of_file(const std::string& path) {
  Result<MeshFile> file = read_mesh_file(path);
  EXPECT_TRUE(file) << path;
  return file ? std::move(file->mesh) : IndexedMesh();
}

std::string report_path(const std::string& name) { return RYOSEN_SOURCE_DIR "/tests/data/reports/" + name; }

}  // namespace

Mesh asset_mesh(const std::string& name) { return from_indexed(list_of_file(RYOSEN_SOURCE_DIR "/assets/" + name)); }

Mesh report_mesh(const std::string& name) { return from_indexed(report_list(name)); }

IndexedMesh report_list(const std::string& name) { return list_of_file(report_path(name)); }

}  // namespace ryosen::test
