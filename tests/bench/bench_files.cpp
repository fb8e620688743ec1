// From a file to a connected mesh, against CGAL in the same run. RYOSEN_DRAGON=FILE.ply.gz adds the dragon.
#include <tiny_obj_loader.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <istream>
#include <limits>
#include <streambuf>
#include <string>
#include <string_view>
#include <vector>

#include "ryosen/base/parallel.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/io/formats.h"
#include "ryosen/io/input_file.h"
#include "ryosen/io/obj.h"
#include "tests/bench/bench_meshes.h"
#include "tests/bench/cost.h"
#include "tests/bench/peer_cgal.h"

namespace ryosen::bench {
namespace {

namespace fs = std::filesystem;

constexpr int turns = 9;

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
    print_row(mesh + (threads == 1 ? " obj, bare callbacks" : " obj, bare, in pieces"), costs);
  }
}

// One file of a mesh in a format.
void compare(const std::string& mesh, const IndexedMesh& source, std::string_view id, double bar_ms) {
  const WriteOptions target = *find_target(id);
  const fs::path path = fs::temp_directory_path() /
                        ("ryosen_bench_" + mesh + "_" + std::string(id) + std::string(target.format->extensions[0]));
  MeshFile file;
  // The usual binary files have floats; decimals stay as short as they are.
  file.mesh = target.format->id == "obj" ? source : in_floats(source);
  if (!write_mesh_file(path, file, target)) return;
  Costs read, whole, peer;
  for (int i = 0; i <= turns; ++i) {
    Mesh connected;
    Result<MeshFile> result = MeshFile();
    CgalMesh theirs;
    const Cost reading = cost_of([&] { result = read_mesh_file(path); });
    const Cost connecting = cost_of([&] { connected = from_indexed(std::move(result->mesh)); });
    const Cost cgal = cost_of([&] { theirs = CgalMesh::read(path.string()); });
    if (i == 0 || connected.live().faces == 0) continue;  // warm up
    read.add(reading);
    whole.add({reading.wall + connecting.wall, reading.cpu + connecting.cpu});
    peer.add(cgal);
  }
  if (!whole.empty()) {
    print_row(mesh + " " + std::string(id), whole, peer, bar_ms);
    print_row("  of this reading", read);
  }
  if (id == "obj") print_bare_callbacks(mesh, path);
  fs::remove(path);
}

void run() {
  print_head("file to connected mesh, ms");
  for (const char* id : {"ply-little", "stl-binary", "obj", "off"}) compare("bunny", bunny(), id, 0);
  if (dragon().positions.empty()) return;
  compare("dragon", dragon(), "ply-little", 60);
  compare("dragon", dragon(), "stl-binary", 120);
  compare("dragon", dragon(), "obj", 220);
}

}  // namespace
}  // namespace ryosen::bench

int main() { ryosen::bench::run(); }
