// The contents of a mesh file: the mesh, and the data that belong to the file rather than to the mesh.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "ryosen/base/handle.h"
#include "ryosen/base/message.h"
#include "ryosen/indexed/indexed.h"
#include "ryosen/io/properties.h"
#include "ryosen/io/reporter.h"

namespace ryosen {

struct Format;

// A polyline or a list of points between the faces of a file (`l` and `p` of OBJ). The last four are indices into the
// name tables of the mesh, no_index for none.
struct LineElement {
  bool is_points = false;
  std::uint32_t before_face = 0;  // number of faces of the file before it
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
  const Format* format = nullptr;               // the format read; null for a mesh not from a file
  std::vector<std::string> head_comments;       // lines of the leading comment, including #
  std::vector<std::string> material_libraries;  // the rest of each mtllib line, without duplicates
  ElementList elements;
  PropertyTables properties;                // PLY: layout and data not in the mesh
  Encoding encoding = Encoding::automatic;  // as read, and as it will be written
  // Edges without a face of the edited mesh, by the numbers of their ends in `mesh`, ascending. Formats with lines
  // write them as lines; reading gives lines, never edges.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> wires;
  // Number of vertices removed from the mesh but still written, because other data reference them.
  std::uint64_t kept_vertices = 0;
  LeftOut left_out;              // what reading ignored
  std::string stl_head;          // the 80-byte header of binary STL, if head_comments do not reproduce it
  bool has_free_facets = false;  // ascii STL: some facets have other than three corners
  bool byte_colours = false;     // OFF: the file gives vertex colours as 0..255
  std::vector<Message> messages;
};

// A file that has been read, with what there is to say of it.
inline MeshFile finished(MeshFile& file, Reporter& reporter) {
  warn_of_missing_elements(reporter, file.mesh.positions.size(), file.mesh.face_count());
  file.left_out = reporter.left_out();
  file.messages = reporter.take();
  return std::move(file);
}

}  // namespace ryosen
