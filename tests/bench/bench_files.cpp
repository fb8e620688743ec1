// From a file to a connected mesh, against CGAL in the same run. RYOSEN_DRAGON=FILE.ply.gz adds the dragon.
#include <sys/resource.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <istream>
#include <limits>
#include <streambuf>
#include <string>
#include <string_view>
#include <vector>

#include "core/build/from_indexed.h"
#include "core/build/parallel.h"
#include "core/io/formats.h"
#include "core/io/input_file.h"
#include "core/io/obj_pieces.h"
#include "tests/bench/bench_meshes.h"
#include "tests/bench/peer_cgal.h"

namespace ryosen::bench {
namespace {

namespace fs = std::filesystem;

struct Cost {
  double wall = 0, cpu = 0;  // milliseconds; cpu is that of all threads, user and system
};

double cpu_milliseconds() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  const auto of = [](const timeval& t) {
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_usec);
  };
  return of(usage.ru_utime) + of(usage.ru_stime);
}

template <class Work>
Cost cost_of(Work work) {
  const double cpu = cpu_milliseconds();
  const auto start = std::chrono::steady_clock::now();
  work();
  const double wall = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return {wall, cpu_milliseconds() - cpu};
}

// What several turns cost. Other programs on the machine only add, so the least is nearest to the truth.
class Costs {
 public:
  void add(Cost cost) {
    wall_.push_back(cost.wall);
    least_cpu_ = std::min(least_cpu_, cost.cpu);
  }
  bool empty() const { return wall_.empty(); }
  double least() const { return *std::min_element(wall_.begin(), wall_.end()); }
  double least_cpu() const { return least_cpu_; }
  double median() const {
    std::vector<double> values = wall_;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  }

 private:
  std::vector<double> wall_;
  double least_cpu_ = std::numeric_limits<double>::infinity();
};

// A row; a bar of 0 stands for none.
void print(const std::string& name, double read, const Costs& ours, const Costs& peer, double bar_ms) {
  std::printf("%-24s %8.1f %8.1f %8.1f %8.1f", name.c_str(), read, ours.median(), ours.least(), ours.least_cpu());
  if (!peer.empty()) std::printf(" %8.1f %8.1f %6.1fx", peer.least(), peer.least_cpu(), peer.least() / ours.least());
  if (bar_ms > 0) std::printf(" %8.0f %s", bar_ms, ours.least() <= bar_ms ? "reached" : "short");
  std::printf("\n");
  std::fflush(stdout);
}

constexpr int turns = 9;

// To the nearest float. Without the volatile g++ 12 drops the rounding.
double rounded(double value) {
  const volatile auto number = static_cast<float>(value);
  return number;
}

// A stream over bytes in memory.
class BytesBuffer : public std::streambuf {
 public:
  explicit BytesBuffer(std::string_view bytes) {
    char* const begin = const_cast<char*>(bytes.data());  // only read
    setg(begin, begin, begin + bytes.size());
  }
};

// tinyobjloader's callbacks alone, which do nothing: what reading an OBJ file through them cannot undercut.
void bare_callbacks(std::string_view bytes) {
  BytesBuffer buffer(bytes);
  std::istream stream(&buffer);
  std::size_t lines = 0;
  tinyobj::callback_t callbacks;
  callbacks.vertex_cb = [](void* count, auto...) { ++*static_cast<std::size_t*>(count); };
  callbacks.index_cb = [](void* count, tinyobj::index_t*, int) { ++*static_cast<std::size_t*>(count); };
  tinyobj::LoadObjWithCallback(stream, callbacks, &lines, nullptr, nullptr, nullptr);
}

void print_bare_callbacks(const std::string& mesh, const fs::path& path) {
  const Result<FileBytes> bytes = read_whole_file(path);
  if (!bytes) return;
  for (const unsigned threads : {1u, 2u}) {
    const auto pieces = cut_obj(bytes->view(), threads == 1 ? bytes->size : std::size_t{1} << 20);
    Costs costs;
    for (int i = 0; i < turns; ++i)
      costs.add(cost_of([&] {
        for_each_task(static_cast<unsigned>(pieces.size()), threads, [&](unsigned k) { bare_callbacks(pieces[k]); });
      }));
    print(mesh + (threads == 1 ? " obj, bare" : " obj, bare, pieces"), 0, costs, {}, 0);
  }
}

// One file of a mesh in a format.
void compare(const std::string& mesh, const IndexedMesh& source, std::string_view id, double bar_ms) {
  const WriteOptions target = *find_target(id);
  const fs::path path = fs::temp_directory_path() /
                        ("ryosen_bench_" + mesh + "_" + std::string(id) + std::string(target.format->extensions[0]));
  MeshFile file;
  file.mesh = source;
  if (target.format->id != "obj")  // the usual binary files have floats; decimals stay as short as they are
    for (glm::dvec3& p : file.mesh.positions) p = {rounded(p.x), rounded(p.y), rounded(p.z)};
  if (!write_mesh_file(path, file, target)) return;
  Costs whole, peer;
  double read = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= turns; ++i) {
    Mesh connected;
    Result<MeshFile> result = MeshFile();
    CgalMesh theirs;
    const Cost reading = cost_of([&] { result = read_mesh_file(path); });
    const Cost connecting = cost_of([&] { connected = from_indexed(std::move(result->mesh)); });
    const Cost cgal = cost_of([&] { theirs = CgalMesh::read(path.string()); });
    if (i == 0 || connected.live().faces == 0) continue;  // warm up
    read = std::min(read, reading.wall);
    whole.add({reading.wall + connecting.wall, reading.cpu + connecting.cpu});
    peer.add(cgal);
  }
  if (!whole.empty()) print(mesh + " " + std::string(id), read, whole, peer, bar_ms);
  if (id == "obj") print_bare_callbacks(mesh, path);
  fs::remove(path);
}

void run() {
  std::printf("%-24s %8s %8s %8s %8s %8s %8s %7s %8s\n", "file to connected, ms", "read", "median", "least", "cpu",
              "CGAL", "its cpu", "ratio", "bar");
  for (const char* id : {"ply-little", "stl-binary", "obj", "off"}) compare("bunny", bunny(), id, 0);
  if (dragon().positions.empty()) return;
  compare("dragon", dragon(), "ply-little", 60);
  compare("dragon", dragon(), "stl-binary", 120);
  compare("dragon", dragon(), "obj", 220);
}

}  // namespace
}  // namespace ryosen::bench

int main() { ryosen::bench::run(); }
