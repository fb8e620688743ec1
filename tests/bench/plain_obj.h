// OBJ files of triangles with texture coordinates, for programs that measure and must share nothing with Ryosen.
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tests/bench/plain_off.h"

namespace plain {

struct TexturedTriangles {
  Triangles triangles;
  std::vector<std::array<std::array<double, 2>, 3>> texture;  // by face the coordinates of its corners
};

// Leaves out faces of another number of corners, and those without texture coordinates.
inline TexturedTriangles read_obj(const char* path) {
  std::ifstream file(path);
  TexturedTriangles mesh;
  std::vector<std::array<double, 2>> values;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      std::array<double, 3> p{};
      words >> p[0] >> p[1] >> p[2];
      mesh.triangles.points.push_back(p);
    } else if (kind == "vt") {
      std::array<double, 2> value{};
      words >> value[0] >> value[1];
      values.push_back(value);
    } else if (kind == "f") {
      std::vector<std::array<std::size_t, 2>> corners;
      for (std::string word; words >> word;)
        if (const std::size_t slash = word.find('/'); slash != std::string::npos)
          corners.push_back({static_cast<std::size_t>(std::atoll(word.c_str())),
                             static_cast<std::size_t>(std::atoll(word.c_str() + slash + 1))});
      if (corners.size() != 3) continue;
      std::array<std::uint32_t, 3> face{};
      std::array<std::array<double, 2>, 3> texture{};
      for (std::size_t i = 0; i < 3; ++i) {
        face[i] = static_cast<std::uint32_t>(corners[i][0] - 1);
        texture[i] = values.at(corners[i][1] - 1);
      }
      mesh.triangles.faces.push_back(face);
      mesh.texture.push_back(texture);
    }
  }
  return mesh;
}

// Corners with equal coordinates share a row of them.
inline void write_obj(const char* path, const TexturedTriangles& mesh) {
  std::FILE* const file = std::fopen(path, "w");
  if (!file) std::exit(5);
  for (const auto& p : mesh.triangles.points) std::fprintf(file, "v %.17g %.17g %.17g\n", p[0], p[1], p[2]);
  std::map<std::array<double, 2>, std::size_t> rows;
  for (const auto& corners : mesh.texture)
    for (const auto& value : corners)
      if (rows.try_emplace(value, rows.size() + 1).second) std::fprintf(file, "vt %.17g %.17g\n", value[0], value[1]);
  for (std::size_t f = 0; f < mesh.texture.size(); ++f) {
    std::fprintf(file, "f");
    for (std::size_t i = 0; i < 3; ++i)
      std::fprintf(file, " %u/%zu", mesh.triangles.faces[f][i] + 1, rows.at(mesh.texture[f][i]));
    std::fprintf(file, "\n");
  }
  std::fclose(file);
}

}  // namespace plain
