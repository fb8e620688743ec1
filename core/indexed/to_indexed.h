// The way back from a mesh to the polygon list that a file holds.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/indexed/indexed.h"
#include "core/mesh/mesh.h"

namespace ryosen {

// The corner list of a face with bridges as the file has it, for as long as its loops are the same.
struct BridgedFace {
  std::uint32_t face = 0;
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> texcoords, normals;  // as in CornerValues::index; empty when the file has none
};

// What a file gives and the mesh does not carry. Numbers are those of the file, which never change while it is open.
struct FileTables {
  std::vector<QuarantinedFace> quarantine;  // ascending by face; without those that the user dropped
  std::vector<BridgedFace> bridged;         // ascending by face
  std::vector<std::uint32_t> face_lines;
  std::vector<double> vertex_weights;
  FaceColours face_colours;
  std::vector<std::string> materials, groups, objects, smoothing;  // the names that the face columns number
  int texcoord_components = 3;
  int normal_components = 3;
  int colour_components = 3;
};
// Copies them, so ask before from_indexed takes the list.
FileTables file_tables(const IndexedMesh& source);
// The same, but takes the quarantine away, which from_indexed does without.
FileTables take_file_tables(IndexedMesh& source);

struct CompactMesh {
  IndexedMesh mesh;
  // Number in the list by slot, no_index for what is not in it. All copies of a point have the point's number, a
  // quarantined face has one.
  std::vector<std::uint32_t> vertex_number;
  std::vector<std::uint32_t> face_number;
  std::size_t kept_vertices = 0;  // that are gone from the mesh and stand in the list all the same
};

// Live points (isolated ones too) and live and quarantined faces in the order of their numbers without gaps; each face
// from its first corner; pools as they are. A face with rings is written
// with bridges: as the file had it while its loops are unchanged, else with the shortest visible ones. Face lines are
// left out. from_indexed gives the same polygons again.
// A quarantined face keeps its cause and its polygon: a corner follows its vertex; a number past the end is written as
// far past the new end; a negative one as it was. A vertex of the file that is gone although a quarantined face names it
// or `used_beside` does stays in the list, at its last place and without a face of the mesh. Where a live point stands
// at just that place that comes before it or is new, or is a copy of it, that point is used instead.
// O(corners), and a sort of the points when such a vertex is gone.
CompactMesh to_indexed(const Mesh& mesh, const FileTables& tables = {}, std::span<const Vertex> used_beside = {});

}  // namespace ryosen
