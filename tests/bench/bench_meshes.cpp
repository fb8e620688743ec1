#include "tests/bench/bench_meshes.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <sstream>

#include "ryosen/io/formats.h"

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

IndexedMesh littered(std::uint32_t side) {
  IndexedMesh mesh;
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.corners.insert(mesh.corners.end(), {a, b, c});
    mesh.face_offsets.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
  };
  const auto add_point = [&](double x, double y, double z) {
    mesh.positions.emplace_back(x, y, z);
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
  };
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x) add_point(x, y, 0.3 * std::sin(0.7 * x) * std::cos(0.9 * y));
  for (std::uint32_t y = 0; y + 1 < side; ++y) {
    for (std::uint32_t x = 0; x + 1 < side; ++x) {
      const std::uint32_t a = y * side + x, b = a + 1, c = b + side, d = a + side;
      add(a, b, c);
      add(a, c, d);
      if (x % 3 == 1 && y % 3 == 1) add(a, c, add_point(x + 0.5, y + 0.5, 1));
      if (x % 3 == 2 && y % 3 == 2) {
        const std::uint32_t p = add_point(x, y, 2), q = add_point(x + 0.5, y, 2);
        add(p, q, add_point(x, y + 0.5, 2));
      }
    }
  }
  return mesh;
}

// Without the volatile g++ 12 drops the rounding.
double rounded(double value) {
  const volatile auto number = static_cast<float>(value);
  return number;
}

}  // namespace

IndexedMesh in_floats(IndexedMesh mesh) {
  for (glm::dvec3& p : mesh.positions) p = {rounded(p.x), rounded(p.y), rounded(p.z)};
  return mesh;
}

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

const IndexedMesh& littered_70k() {
  static const IndexedMesh mesh = littered(178);
  return mesh;
}

const IndexedMesh& littered_830k() {
  static const IndexedMesh mesh = littered(612);
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
