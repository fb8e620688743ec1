#include "tests/support/core/asset_mesh.h"

#include <gtest/gtest.h>

#include "core/indexed/from_indexed.h"
#include "core/io/formats.h"

namespace ryosen::test {

Mesh asset_mesh(const std::string& name) {
  Result<MeshFile> file = read_mesh_file(RYOSEN_SOURCE_DIR "/assets/" + name);
  EXPECT_TRUE(file) << name;
  return file ? from_indexed(std::move(file->mesh)) : Mesh();
}

}  // namespace ryosen::test
