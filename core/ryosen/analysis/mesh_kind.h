// What a mesh is, in one word, and why.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "ryosen/analysis/problem_sets.h"
#include "ryosen/base/message.h"

namespace ryosen {

// The first that fits.
enum class MeshKind : std::uint8_t {
  non_manifold,  // three or more faces on an edge, or several fans of faces at a point
  one_sided,     // the faces cannot be turned to agree
  misoriented,   // they could, and do not
  surface,       // a boundary, a coordinate that is not finite, a shell without volume, or shells that cross or touch
  inside_out,    // closed; a shell inside an even number of others looks inwards, or one inside an odd number outwards
  solid,         // closed, and every shell looks the right way
  wires,         // no faces, but edges, or lines beside the mesh
  points,        // nothing but vertices
  empty,
};

struct MeshKindRow {
  MeshKind kind;
  std::string_view id;  // as in reports
  std::string_view name_en, name_ja;
};
std::span<const MeshKindRow> mesh_kind_table();
const MeshKindRow& row_of(MeshKind kind);

struct KindOfMesh {
  MeshKind kind = MeshKind::empty;
  Text reason;  // a sentence that names the element
};

// `sets` are those of the mesh as it is, `lines` how many lines its file keeps beside it. Takes next to nothing where
// is_kind_evident, else as much as find_shells (shells.h).
KindOfMesh find_kind(const Mesh& mesh, const ProblemSets& sets, std::uint64_t lines = 0);
// Whether the sets alone tell.
bool is_kind_evident(const Mesh& mesh, const ProblemSets& sets);

}  // namespace ryosen
