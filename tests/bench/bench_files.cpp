// From a file to a connected mesh, against CGAL in the same run. RYOSEN_DRAGON=FILE.ply.gz adds the dragon.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "core/build/from_indexed.h"
#include "core/io/formats.h"
#include "tests/bench/bench_meshes.h"
#include "tests/bench/peer_cgal.h"

namespace ryosen::bench {
namespace {

namespace fs = std::filesystem;

template <class Work>
double milliseconds(Work work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

// One file of a mesh in a format; a bar of 0 stands for none.
void compare(const std::string& mesh, const IndexedMesh& source, std::string_view id, double bar_ms) {
  const WriteOptions target = *find_target(id);
  const fs::path path = fs::temp_directory_path() /
                        ("ryosen_bench_" + mesh + "_" + std::string(id) + std::string(target.format->extensions[0]));
  MeshFile file;
  file.mesh = source;
  for (glm::dvec3& p : file.mesh.positions) p = glm::dvec3(glm::vec3(p));  // as the usual files have them
  if (!write_mesh_file(path, file, target)) return;
  std::vector<double> read, whole, peer, ratios;
  constexpr int turns = 9;
  for (int i = 0; i <= turns; ++i) {
    double reading = 0;
    std::size_t faces = 0;
    const double ours = milliseconds([&] {
      Result<MeshFile> result = MeshFile();
      reading = milliseconds([&] { result = read_mesh_file(path); });
      faces = from_indexed(std::move(result->mesh)).live().faces;
    });
    const double theirs = milliseconds([&] { CgalMesh::read(path.string()); });
    if (i == 0 || faces == 0) continue;  // warm up
    read.push_back(reading);
    whole.push_back(ours);
    peer.push_back(theirs);
    ratios.push_back(theirs / ours);
  }
  fs::remove(path);
  if (whole.empty()) return;
  std::printf("%-28s %9.1f %9.1f %9.1f %7.1fx", (mesh + " " + std::string(id)).c_str(), median(read), median(whole),
              median(peer), median(ratios));
  if (bar_ms > 0) std::printf(" %9.0f %s", bar_ms, median(whole) <= bar_ms ? "reached" : "short");
  std::printf("\n");
  std::fflush(stdout);
}

void run() {
  std::printf("%-28s %9s %9s %9s %8s %9s\n", "file to connected mesh, ms", "read", "connected", "CGAL", "ratio", "bar");
  for (const char* id : {"ply-little", "stl-binary", "obj", "off"}) compare("bunny", bunny(), id, 0);
  if (dragon().positions.empty()) return;
  compare("dragon", dragon(), "ply-little", 60);
  compare("dragon", dragon(), "stl-binary", 120);
  compare("dragon", dragon(), "obj", 220);
}

}  // namespace
}  // namespace ryosen::bench

int main() { ryosen::bench::run(); }
