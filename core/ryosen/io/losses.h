// What would be lost by writing a mesh in a format: the table of kinds of losses.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "ryosen/base/message.h"
#include "ryosen/io/mesh_file.h"

namespace ryosen {

// What a format can represent.
enum class Holds : std::uint32_t {
  polygons = 1u << 0,          // faces with more than three corners, holes through bridges
  vertex_texcoords = 1u << 1,  // texture coordinates, one per vertex
  corner_texcoords = 1u << 2,  // texture coordinates, one per corner
  third_texcoord = 1u << 3,    // texture coordinates with three components
  vertex_normals = 1u << 4,
  corner_normals = 1u << 5,
  groups = 1u << 6,
  names = 1u << 7,            // objects, smoothing groups, materials and their libraries
  vertex_colours = 1u << 8,   // of all vertices
  missing_colours = 1u << 9,  // vertices without a colour among others with one
  weights = 1u << 10,
  face_colours = 1u << 11,      // with three or four components for all faces
  any_face_colours = 1u << 12,  // any other face colours
  elements = 1u << 13,          // lines and points; edges without a face as lines
  quarantine = 1u << 14,        // unusable faces of any size
  odd_triangles = 1u << 15,     // unusable faces with three corners, see TxtQuarantine
  flat_triangles = 1u << 16,    // unusable faces with three existing corners
  vertices = 1u << 17,          // vertices with their numbers: isolated ones, several at one position
  properties = 1u << 18,        // properties and elements not represented in the mesh
  facet_attributes = 1u << 19,  // a number from 0 to 65535 per face
  comments = 1u << 20,
  first_comment = 1u << 21,  // 80 bytes of it
  doubles = 1u << 22,
  any_vertex_colours = 1u << 23,  // vertex and face colours with any values
  free_facets = 1u << 24,         // unusable faces of any size with existing corners, if the file had such
  wide_numbers = 1u << 25,        // numbers of vertices beyond 32 bits, which are those of unusable faces
};

constexpr Holds operator|(Holds a, Holds b) {
  return static_cast<Holds>(static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b));
}
constexpr bool holds(Holds all, Holds one) {
  return (static_cast<std::uint32_t>(all) & static_cast<std::uint32_t>(one)) == static_cast<std::uint32_t>(one);
}

// The attribute with the attribute bytes of binary STL facets, of type ushort.
inline constexpr std::string_view facet_attribute = "face.attribute";

// How the sentence of a loss is made; the count is always appended.
enum class LossSentence {
  cannot_hold,  // the texts name what the format cannot hold
  own,          // the texts are a complete sentence
};

struct LossKind {
  Code code;                // kinds that never occur together may share it
  std::string_view en, ja;  // what is lost, and what happens to it
  // The number lost by a format with these capabilities. Linear in the inspected data.
  std::uint64_t (*count)(const MeshFile& file, Holds held);
  LossSentence sentence = LossSentence::cannot_hold;
  // The first vertex that would lose it; null where vertices are not what is counted.
  std::optional<std::uint64_t> (*first)(const MeshFile& file, Holds held) = nullptr;
  // The names of what is lost, where it has names.
  std::vector<std::string> (*names)(const MeshFile& file, Holds held) = nullptr;
};
const std::vector<LossKind>& loss_kinds();

struct Loss {
  const LossKind* kind;
  std::uint64_t count;
  std::optional<std::uint64_t> first = std::nullopt;  // vertex, where the kind tells it
  std::vector<std::string> names = {};                // where it tells these

  // The warning, with the name of the format.
  Message message(const Text& format) const;
};
// In table order; empty if nothing would be lost.
std::vector<Loss> find_losses(const MeshFile& file, Holds held);

}  // namespace ryosen
