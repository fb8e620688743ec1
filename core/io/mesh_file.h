// A mesh as it was read from a file, with what belongs to the file rather than to the mesh.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/base/handle.h"
#include "core/base/message.h"
#include "core/indexed/indexed.h"
#include "core/io/properties.h"
#include "core/io/reporter.h"

namespace ryosen {

struct Format;

// A polyline or a list of points between the faces of a file (`l` and `p` of OBJ). The last four are entries of the
// name tables of the mesh, no_index for none.
struct LineElement {
  bool is_points = false;
  std::uint32_t before_face = 0;  // how many faces of the file come before it
  std::uint32_t first = 0;        // its range in ElementList::vertices
  std::uint32_t count = 0;
  std::uint32_t line = 0;  // in the file, from 1
  std::uint32_t object = no_index, group = no_index, material = no_index, smoothing = no_index;
};

struct ElementList {
  std::vector<LineElement> items;        // in the order of the file
  std::vector<std::int64_t> vertices;    // from 0; numbers out of range are kept as they are
  std::vector<std::uint32_t> texcoords;  // one per vertex above, no_index for none; empty when unused
};

struct MeshFile {
  IndexedMesh mesh;
  const Format* format = nullptr;               // how it was read; null for a mesh that comes from no file
  std::vector<std::string> head_comments;       // lines of the comment at the head, with their #
  std::vector<std::string> material_libraries;  // what stands after each mtllib, without repetitions
  ElementList elements;
  PropertyTables properties;  // PLY: its layout and what the mesh has no place for; STL: attributes of facets
  Encoding encoding = Encoding::automatic;  // how it was read and will be written
  // Edges without a face that the mesh had, by the numbers of their ends in `mesh`, ascending. Formats with lines hold
  // them as such; reading gives lines, never edges.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> wires;
  // Vertices that were removed from the mesh and are written all the same, as something beside the mesh uses them.
  std::uint64_t kept_vertices = 0;
  LeftOut left_out;      // what reading did not take over
  std::string stl_head;  // the 80 bytes at the beginning of binary STL, where head_comments do not give them back
  bool has_free_facets = false;  // ascii STL: some facets have other than three corners
  bool byte_colours = false;     // OFF: the file gives vertex colours as 0..255
  std::vector<Message> messages;
};

}  // namespace ryosen
