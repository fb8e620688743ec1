// What would be lost of a mesh in a format: one table of kinds of losses.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/message.h"
#include "core/io/mesh_file.h"

namespace ryosen {

// What a format can hold.
enum class Holds : std::uint32_t {
  polygons = 1u << 0,          // faces with more than three corners, holes by way of bridges
  vertex_texcoords = 1u << 1,  // texture coordinates, one per vertex
  corner_texcoords = 1u << 2,  // and one per corner
  third_texcoord = 1u << 3,    // with three numbers
  vertex_normals = 1u << 4,
  corner_normals = 1u << 5,
  groups = 1u << 6,
  names = 1u << 7,            // objects, smoothing groups, materials and their libraries
  vertex_colours = 1u << 8,   // of all vertices
  missing_colours = 1u << 9,  // and vertices without one among others with one
  weights = 1u << 10,
  face_colours = 1u << 11,      // with three or four numbers for all faces
  any_face_colours = 1u << 12,  // and any other
  elements = 1u << 13,          // lines and points, edges without a face as lines
  quarantine = 1u << 14,        // faces of any corners that cannot be used
  odd_triangles = 1u << 15,     // those of three corners, as TxtQuarantine says
  flat_triangles = 1u << 16,    // those of three corners that exist
  vertices = 1u << 17,          // with their numbers: such without a face, several at one place
  properties = 1u << 18,        // properties and elements that the mesh has no place for
  facet_attributes = 1u << 19,  // a number from 0 to 65535 per face
  comments = 1u << 20,
  first_comment = 1u << 21,  // 80 bytes of it
  doubles = 1u << 22,
  any_vertex_colours = 1u << 23,  // and of faces, whatever their numbers are
  free_facets = 1u << 24,         // faces of any corners that exist, where the file came with such
};

constexpr Holds operator|(Holds a, Holds b) {
  return static_cast<Holds>(static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b));
}
constexpr bool holds(Holds all, Holds one) {
  return (static_cast<std::uint32_t>(all) & static_cast<std::uint32_t>(one)) == static_cast<std::uint32_t>(one);
}

// The property in which binary STL gives the attribute bytes of its facets.
inline constexpr std::string_view facet_attribute = "attribute";

// How a kind of loss is said, always with the count at the end.
enum class LossSentence {
  cannot_hold,  // the texts are what the format cannot hold
  own,          // the texts are a sentence; what it counts need not be a thing of the mesh
};

struct LossKind {
  Code code;                // kinds that no format has at once may share it
  std::string_view en, ja;  // what it is, with what becomes of it
  // How many of them a format that holds this much would lose. O(size of what it looks at).
  std::uint64_t (*count)(const MeshFile& file, Holds held);
  LossSentence sentence = LossSentence::cannot_hold;
  // The first vertex that would lose it; null where vertices are not what is counted.
  std::optional<std::uint64_t> (*first)(const MeshFile& file, Holds held) = nullptr;
};
const std::vector<LossKind>& loss_kinds();

struct Loss {
  const LossKind* kind;
  std::uint64_t count;
  std::optional<std::uint64_t> first = std::nullopt;  // vertex, where the kind tells it

  // The warning, with the name of the format.
  Message message(const Text& format) const;
};
// In the order of the table; empty where nothing would be lost.
std::vector<Loss> find_losses(const MeshFile& file, Holds held);

}  // namespace ryosen
