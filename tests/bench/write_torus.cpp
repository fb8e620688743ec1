// Writes a torus of about so many million triangles as binary PLY: write_torus MILLIONS FILE.
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "ryosen/io/formats.h"
#include "tests/bench/generated_meshes.h"

int main(int argc, char** argv) {
  const double millions = argc == 3 ? std::atof(argv[1]) : 0;
  if (!(millions > 0 && millions <= 100)) {
    std::fputs("write_torus MILLIONS FILE\n", stderr);
    return 2;
  }
  const auto columns = static_cast<std::uint32_t>(std::lround(std::sqrt(millions * 1e6 / 4)));
  ryosen::MeshFile file;
  file.mesh = ryosen::bench::torus(2 * columns, columns);
  for (glm::dvec3& p : file.mesh.positions) p = glm::dvec3(glm::vec3(p));  // as files of this size mostly are
  const auto written = ryosen::write_mesh_file(argv[2], file, *ryosen::find_target("ply-little"));
  if (!written) std::fprintf(stderr, "%s\n", written.failure().message.text.en.c_str());
  return written ? 0 : 1;
}
