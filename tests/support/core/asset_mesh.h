// The meshes of the assets folder, and those of people's reports.
#pragma once

#include <string>

#include "ryosen/indexed/indexed.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen::test {

// What a file of assets holds; a test that asks for one that is not there fails.
Mesh asset_mesh(const std::string& name);
// What a file of tests/data/reports holds.
Mesh report_mesh(const std::string& name);
// The polygon list of such a file.
IndexedMesh report_list(const std::string& name);

}  // namespace ryosen::test
