#include "core/io/byte_colours.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ryosen {
namespace {

template <class Test>
bool any_component(const glm::dvec4& colour, int components, Test test) {
  for (int i = 0; i < components; ++i)
    if (test(colour[i])) return true;
  return false;
}

template <class Test>
std::uint64_t count_colours(const IndexedMesh& mesh, Test test) {
  const auto& colours = mesh.vertex_colours;
  return static_cast<std::uint64_t>(std::count_if(colours.begin(), colours.end(), [&](const glm::dvec4& colour) {
    return !std::isnan(colour.x) && any_component(colour, mesh.colour_components == 4 ? 4 : 3, test);
  }));
}

}  // namespace

double as_byte(double component) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double scaled = component * byte_scale;
  for (const double candidate : {std::nearbyint(scaled), scaled, std::nextafter(scaled, infinity)})
    if (candidate / byte_scale == component) return candidate;
  return std::nextafter(scaled, -infinity);
}

bool are_byte_colours(const MeshFile& file) {
  if (count_colours(file.mesh, [](double component) { return component > 1; }) > 0) return true;
  return file.byte_colours && count_colours(file.mesh, [](double component) { return as_byte(component) > 1; }) > 0;
}

std::uint64_t count_rounded_colours(const MeshFile& file) {
  if (!are_byte_colours(file)) return 0;
  return count_colours(file.mesh, [](double component) {
    return as_byte(component) / byte_scale != component && !std::isnan(component);
  });
}

}  // namespace ryosen
