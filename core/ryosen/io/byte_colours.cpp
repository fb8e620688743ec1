#include "ryosen/io/byte_colours.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
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

// Whether reading restores the component from the byte.
bool is_byte_exact(double component) { return as_byte(component) / byte_scale == component || std::isnan(component); }

bool is_whole_byte(double component) {
  constexpr double whole_limit = 9007199254740992.0;  // whole numbers below it are exact doubles
  const double byte = as_byte(component);
  return std::trunc(byte) == byte && std::abs(byte) < whole_limit && !(byte == 0 && std::signbit(byte)) &&
         is_byte_exact(component);
}

std::uint64_t count_rounded_faces(const FaceColours& colours) {
  std::uint64_t count = 0;
  for (std::size_t face = 0; face < colours.count.size(); ++face) {
    const int numbers = colours.count[face];
    if (numbers < 3 || form_of_face_colour(colours, face) != ColourForm::large_bytes) continue;
    count += any_component(colours.values[face], numbers, [](double c) { return !is_byte_exact(c); }) ? 1 : 0;
  }
  return count;
}

}  // namespace

double as_byte(double component) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double scaled = component * byte_scale;
  for (const double candidate : {std::nearbyint(scaled), scaled, std::nextafter(scaled, infinity)})
    if (candidate / byte_scale == component) return candidate;
  return std::nextafter(scaled, -infinity);
}

std::optional<std::uint8_t> byte_meant(double component) {
  if (!(component >= 0 && component <= 1)) return std::nullopt;
  const double byte = std::nearbyint(component * byte_scale), exact = byte / byte_scale;
  if (exact == component) return static_cast<std::uint8_t>(byte);
  if (byte == 0) return std::nullopt;  // 0 is exact, and what is smaller may have hundreds of decimals
  char text[32];
  char* const end = text + sizeof text;
  const char* stop = std::to_chars(text, end, component, std::chars_format::fixed).ptr;
  const char* const point = std::find(static_cast<const char*>(text), stop, '.');
  constexpr std::ptrdiff_t least_decimals = 4;
  const std::ptrdiff_t decimals = std::max(point == stop ? 0 : stop - point - 1, least_decimals);
  stop = std::to_chars(text, end, exact, std::chars_format::fixed, static_cast<int>(decimals)).ptr;
  double printed = 0;
  std::from_chars(text, stop, printed);
  return printed == component ? std::optional(static_cast<std::uint8_t>(byte)) : std::nullopt;
}

bool are_byte_colours(const MeshFile& file) {
  if (count_colours(file.mesh, [](double component) { return component > 1; }) > 0) return true;
  return file.byte_colours && count_colours(file.mesh, [](double component) { return as_byte(component) > 1; }) > 0;
}

std::uint64_t count_rounded_colours(const MeshFile& file) {
  const std::uint64_t faces = count_rounded_faces(file.mesh.face_colours);
  if (!are_byte_colours(file)) return faces;
  return faces + count_colours(file.mesh, [](double component) { return !is_byte_exact(component); });
}

ColourForm form_of_face_colour(const FaceColours& colours, std::size_t face) {
  const glm::dvec4& colour = colours.values[face];
  const int numbers = colours.count[face];
  const bool are_whole = !any_component(colour, numbers, [](double c) { return !is_whole_byte(c); });
  if (colours.are_bytes && are_whole) return ColourForm::bytes;
  return any_component(colour, numbers, [](double c) { return c > 1; }) ? ColourForm::large_bytes : ColourForm::reals;
}

}  // namespace ryosen
