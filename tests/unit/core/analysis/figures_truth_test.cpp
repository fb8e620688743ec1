// The figures of real and constructed mesh files held against their known truth, where the folder of such files exists;
// figures_test.cpp covers every figure without it.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "core/analysis/figures.h"
#include "core/indexed/from_indexed.h"
#include "core/indexed/to_indexed.h"
#include "core/io/formats.h"

namespace ryosen {
namespace {

namespace fs = std::filesystem;

// The raw text of a value in a line of JSON without nested objects, without its quotes; empty if there is no such key.
std::string json_value(const std::string& line, const std::string& key) {
  const std::size_t found = line.find("\"" + key + "\":");
  if (found == std::string::npos) return "";
  std::size_t begin = found + key.size() + 3;
  while (line[begin] == ' ') ++begin;
  if (line[begin] == '"') return line.substr(begin + 1, line.find('"', begin + 1) - begin - 1);
  return line.substr(begin, line.find_first_of(",}", begin) - begin);
}

void expect_figures(const std::string& truth, const Figures& f) {
  const auto expect = [&](const char* key, std::int64_t found) {
    EXPECT_EQ(json_value(truth, key), std::to_string(found)) << key;
  };
  const auto expect_flag = [&](const char* key, bool found) {
    EXPECT_EQ(json_value(truth, key), found ? "true" : "false") << key;
  };
  const bool is_welded = json_value(truth, "welded") == "true";
  expect(is_welded ? "V" : "V_file", static_cast<std::int64_t>(f.vertices));
  expect("F_file", static_cast<std::int64_t>(f.faces));
  expect("F", static_cast<std::int64_t>(f.faces - f.quarantined));
  expect("E", static_cast<std::int64_t>(f.edges));
  expect("tri", static_cast<std::int64_t>(f.triangles));
  expect("quad", static_cast<std::int64_t>(f.quads));
  expect("poly5plus", static_cast<std::int64_t>(f.polygons));
  expect("deg_repeat", static_cast<std::int64_t>(f.degenerate_repeat));
  expect("deg_zero_area", static_cast<std::int64_t>(f.degenerate_area));
  expect("dup_faces", static_cast<std::int64_t>(f.duplicate_faces));
  expect("nonfinite_v", static_cast<std::int64_t>(f.nonfinite_vertices));
  expect("boundary_edges", static_cast<std::int64_t>(f.boundary_edges));
  expect("boundary_loops", static_cast<std::int64_t>(f.boundary_loops));
  expect("nm_edges", static_cast<std::int64_t>(f.nonmanifold_edges));
  expect("max_edge_faces", static_cast<std::int64_t>(f.max_edge_faces));
  expect("nm_vertices", static_cast<std::int64_t>(f.nonmanifold_vertices));
  expect("bowtie_vertices", static_cast<std::int64_t>(f.bowtie_vertices));
  expect("inconsistent_edges", static_cast<std::int64_t>(f.misoriented_edges));
  expect("isolated_v", static_cast<std::int64_t>(f.isolated_vertices));
  expect("components", static_cast<std::int64_t>(f.components));
  expect("chi", f.euler_characteristic);
  expect_flag("manifold", f.manifold);
  expect_flag("closed", f.closed);
  expect_flag("orientable", f.orientable);
  EXPECT_EQ(json_value(truth, "genus"), f.genus ? std::to_string(*f.genus) : "null");
}

void expect_truth(const fs::path& folder, const fs::path& list) {
  if (!fs::exists(folder / list)) return;
  std::ifstream stream(folder / list);
  int compared = 0;
  for (std::string line; std::getline(stream, line);) {
    const fs::path path = folder / json_value(line, "file");
    if (json_value(line, "status") != "ok" || !fs::exists(path) || !format_of_extension(path)) continue;
    SCOPED_TRACE(path.string());
    const Result<MeshFile> file = read_mesh_file(path);
    ASSERT_TRUE(file.ok()) << file.failure().message.text.en;
    const IndexedMesh& source = file->mesh;
    const Mesh mesh = from_indexed(source);
    const Figures figures = compute_figures(mesh, source.quarantine);
    expect_figures(line, figures);
    // Written and read again, they are the same.
    const IndexedMesh back = to_indexed(mesh, file_tables(source)).mesh;
    EXPECT_EQ(back.corners, source.corners);
    EXPECT_EQ(back.face_offsets, source.face_offsets);
    const Figures again = compute_figures(from_indexed(back), back.quarantine);
    EXPECT_EQ(again.boundary_loops, figures.boundary_loops);
    EXPECT_EQ(again.faces, figures.faces);
    EXPECT_EQ(again.area, figures.area);
    EXPECT_EQ(again.volume, figures.volume);
    ++compared;
  }
  EXPECT_GT(compared, 0);
}

TEST(figures_truth, of_constructed_meshes) {
  expect_truth(fs::path(RYOSEN_SHARED_DIR) / "meshes" / "known", "truth.jsonl");
}

TEST(figures_truth, of_real_meshes) { expect_truth(fs::path(RYOSEN_SHARED_DIR) / "meshes", "truth.jsonl"); }

}  // namespace
}  // namespace ryosen
