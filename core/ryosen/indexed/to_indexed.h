// Conversion of a mesh back to a polygon list for writing.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "ryosen/indexed/indexed.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// The corner list of a face with bridges as in the file; used while the face's loops are unchanged.
struct BridgedFace {
  std::uint32_t face = 0;
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> texcoords, normals;  // as in CornerValues::index; empty when the file has none
  std::vector<AttributeColumn> values;            // the attributes of these corners
};

// File contents that the mesh does not store. Numbers are those of the file, which do not change while it is open.
struct FileTables {
  std::vector<QuarantinedFace> quarantine;  // ascending by face; without those that the user dropped
  std::vector<BridgedFace> bridged;         // ascending by face
  std::vector<std::uint32_t> face_lines;
  std::vector<std::string> materials, groups, objects, smoothing;  // name tables indexed by the face columns
  std::vector<AttributeColumn> quarantined_attributes;             // those of QuarantinedFace::values, without values
  int texcoord_components = 3;
  int normal_components = 3;
  int colour_components = 3;
  bool face_colours_are_bytes = false;  // as FaceColours::are_bytes
};
// Copies; call it before from_indexed consumes the list.
FileTables file_tables(const IndexedMesh& source);
// The same, but moves the quarantine out of `source`; from_indexed does not need it.
FileTables take_file_tables(IndexedMesh& source);

struct CompactMesh {
  IndexedMesh mesh;
  // By slot the number in the list, no_index if not in it. All copies of a point have the point's number; quarantined
  // faces have one too.
  std::vector<std::uint32_t> vertex_number;
  std::vector<std::uint32_t> face_number;
  std::size_t kept_vertices = 0;  // deleted from the mesh but kept in the list
};

// How file vertices that were deleted from the mesh but are still referenced from outside it are written: kept, or
// replaced by a live point.
struct LostVertices {
  std::vector<Vertex> kept;                             // ascending
  std::vector<std::pair<Vertex, Vertex>> replacements;  // deleted vertex, live point that replaces it
};

// Considers the vertices referenced by the quarantine in `tables` and by `used_beside`; see to_indexed for which points
// replace them. Linear in the references, plus a sort of the points if one of them was deleted.
LostVertices find_lost(const Mesh& mesh, const FileTables& tables, std::span<const Vertex> used_beside);

// Live points (isolated ones too) and live and quarantined faces, renumbered without gaps in order; each face starts at
// its first corner; pools are unchanged. Edges are listed that the file listed, in its order, and behind them, by their
// ends, those with a value other than the default. A face with rings is written with bridges: those of the file while
// its loops are unchanged, else the shortest visible ones. Face lines are omitted. from_indexed of the result gives the
// same polygons. A quarantined face keeps its cause and polygon: corners are renumbered with their vertices, a number
// past the end is written equally far past the new end, a negative one unchanged. A deleted file vertex that a
// quarantined face or `used_beside` references stays in the list, at its last position and without a face; but a live
// point at exactly that position that precedes it or is new, or is a copy of it, is used instead. O(corners), plus a
// sort of the points if such a vertex exists.
CompactMesh to_indexed(const Mesh& mesh, const FileTables& tables = {}, std::span<const Vertex> used_beside = {});

}  // namespace ryosen
