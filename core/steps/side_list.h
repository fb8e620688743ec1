// The sides of the first faces of a mesh as a file lists them: by points, so that copies are one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/forms/form.h"
#include "core/mesh/mesh.h"
#include "core/steps/step.h"

namespace ryosen::steps {

struct SideList {
  static constexpr std::size_t most_faces = 1000;

  // The mesh must have no rings.
  explicit SideList(const Mesh& mesh);

  struct OneSide {
    std::uint32_t from, to;  // points, by the slot of their first copy
    std::uint32_t face;      // in the list
    Halfedge halfedge;       // of the mesh
  };
  std::vector<OneSide> sides;          // by corner: 3i+j where all faces are triangles
  std::vector<std::uint32_t> offsets;  // faces + 1 entries
  std::vector<Face> faces;
  std::vector<Vertex> points;  // used by these faces, ascending
  bool all_triangles = true;
  std::size_t all_faces = 0;  // of the mesh

  std::string name(std::uint32_t side) const;
  bool are_opposite(std::uint32_t a, std::uint32_t b) const {
    return sides[a].from == sides[b].to && sides[a].to == sides[b].from;
  }
  std::uint32_t next(std::uint32_t side) const;
  std::uint32_t prev(std::uint32_t side) const;
  // That only the first faces are played; empty where these are all.
  Text remark() const;
};

// Why a mesh has no such list.
std::optional<Text> why_no_side_list(const Mesh& mesh);

}  // namespace ryosen::steps
