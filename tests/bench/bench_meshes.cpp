#include "tests/bench/bench_meshes.h"

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <sstream>

#include "core/io/formats.h"

namespace ryosen::bench {

namespace {

std::string unzipped(const std::string& path) {
  std::string bytes;
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(("gzip -dc '" + path + "'").c_str(), "r"), &pclose);
  char buffer[1 << 16];
  while (const std::size_t n = pipe ? std::fread(buffer, 1, sizeof buffer, pipe.get()) : 0) bytes.append(buffer, n);
  return bytes;
}

// Vertices as three numbers first, faces as "3 a b c": what this one file holds.
IndexedMesh read_ascii_ply(const std::string& bytes) {
  IndexedMesh mesh;
  std::size_t vertices = 0, faces = 0, body = bytes.find("end_header\n");
  if (body == std::string::npos) return mesh;
  std::istringstream header(bytes.substr(0, body));
  for (std::string line; std::getline(header, line);) {
    std::sscanf(line.c_str(), "element vertex %zu", &vertices);
    std::sscanf(line.c_str(), "element face %zu", &faces);
  }
  const char* at = bytes.c_str() + body + sizeof "end_header";
  const auto next_line = [&] {
    while (*at != '\n' && *at != 0) ++at;
    if (*at == '\n') ++at;
  };
  for (std::size_t i = 0; i < vertices; ++i, next_line()) {
    char* end = nullptr;
    glm::dvec3 p;
    p.x = std::strtod(at, &end);
    p.y = std::strtod(end, &end);
    p.z = std::strtod(end, &end);
    mesh.positions.push_back(p);
  }
  for (std::size_t i = 0; i < faces; ++i, next_line()) {
    char* end = nullptr;
    for (unsigned long n = std::strtoul(at, &end, 10); n > 0; --n)
      mesh.corners.push_back(static_cast<std::uint32_t>(std::strtoul(end, &end, 10)));
    mesh.face_offsets.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
  }
  return mesh;
}

}  // namespace

const IndexedMesh& bunny() {
  static const IndexedMesh mesh = [] {
    Result<MeshFile> file = read_mesh_file(RYOSEN_SOURCE_DIR "/assets/stanford_bunny.obj");
    if (!file) {
      std::cerr << file.failure().message.text.en << "\n";
      std::exit(3);
    }
    IndexedMesh plain;
    plain.positions = std::move(file->mesh.positions);
    plain.corners = std::move(file->mesh.corners);
    plain.face_offsets = std::move(file->mesh.face_offsets);
    return plain;
  }();
  return mesh;
}

const IndexedMesh& dragon() {
  static const IndexedMesh mesh = [] {
    const char* path = std::getenv("RYOSEN_DRAGON");
    return path ? read_ascii_ply(unzipped(path)) : IndexedMesh();
  }();
  return mesh;
}

}  // namespace ryosen::bench
