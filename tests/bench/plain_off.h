// OFF files of triangles for programs that are compared with Ryosen and must share nothing with it.
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace plain {

struct Triangles {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> faces;
  std::vector<std::array<double, 3>> colours = {};  // by point, from 0 to 1; of a COFF alone
};

// Leaves out faces of another number of corners, and what is behind the places and colours of vertices. Ends the
// program where the file is no OFF.
inline Triangles read_off(const char* path) {
  std::ifstream file(path, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const std::size_t header = text.find("OFF");  // STOFF, COFF ...
  if (header > 4) {
    std::fprintf(stderr, "%s is no OFF\n", path);
    std::exit(2);
  }
  const char* at = text.c_str() + header + 3;
  char* end = nullptr;
  const auto number = [&] {
    while (*at == '#' || *at == ' ' || *at == '\n' || *at == '\r')
      if (*at == '#')
        while (*at != '\n' && *at != '\0') ++at;
      else
        ++at;
    const double value = std::strtod(at, &end);
    at = end;
    return value;
  };
  Triangles mesh;
  mesh.points.resize(static_cast<std::size_t>(number()));
  const auto faces = static_cast<std::size_t>(number());
  number();
  const auto end_line = [&] {
    while (*at != '\n' && *at != '\0') ++at;
  };
  const bool has_colours = text.compare(0, header, "C") == 0;
  if (has_colours) mesh.colours.resize(mesh.points.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    for (double& x : mesh.points[i]) x = number();
    if (has_colours)
      for (double& x : mesh.colours[i]) x = number();
    end_line();
  }
  for (std::size_t f = 0; f < faces; ++f) {
    const auto corners = static_cast<std::size_t>(number());
    std::array<std::uint32_t, 3> face{};
    for (std::size_t i = 0; i < corners; ++i) {
      const auto corner = static_cast<std::uint32_t>(number());
      if (i < 3) face[i] = corner;
    }
    if (corners == 3) mesh.faces.push_back(face);
    end_line();  // colours
  }
  return mesh;
}

inline void write_off(const char* path, const Triangles& mesh) {
  std::FILE* const file = std::fopen(path, "w");
  if (!file) std::exit(5);
  const bool has_colours = !mesh.colours.empty();
  std::fprintf(file, "%sOFF\n%zu %zu 0\n", has_colours ? "C" : "", mesh.points.size(), mesh.faces.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const auto& p = mesh.points[i];
    std::fprintf(file, "%.17g %.17g %.17g", p[0], p[1], p[2]);
    if (has_colours)
      std::fprintf(file, " %.9g %.9g %.9g 1", mesh.colours[i][0], mesh.colours[i][1], mesh.colours[i][2]);
    std::fprintf(file, "\n");
  }
  for (const auto& f : mesh.faces) std::fprintf(file, "3 %u %u %u\n", f[0], f[1], f[2]);
  std::fclose(file);
}

}  // namespace plain
