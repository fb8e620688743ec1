// The sides of the first faces of a mesh as a file lists them: by points, so that copies are one. The rings of a face
// follow its outer loop.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ryosen/mesh/mesh.h"
#include "ryosen/textbook/forms/form.h"
#include "ryosen/textbook/steps/step.h"

namespace ryosen::steps {

struct SideList {
  static constexpr std::size_t most_faces = 1000;

  explicit SideList(const Mesh& mesh);

  struct OneSide {
    std::uint32_t from, to;  // points, by the slot of their first copy
    std::uint32_t face;      // in the list
    Halfedge halfedge;       // of the mesh
    std::uint32_t next, prev;
  };
  std::vector<OneSide> sides;          // by corner: 3i+j where all faces are triangles
  std::vector<std::uint32_t> offsets;  // of faces, with all their loops; faces + 1 entries
  std::vector<Face> faces;
  std::vector<Vertex> points;  // used by these faces, ascending
  bool all_triangles = true;
  std::size_t all_faces = 0;  // of the mesh
  bool has_rings = false;

  std::string name(std::uint32_t side) const;
  bool are_opposite(std::uint32_t a, std::uint32_t b) const {
    return sides[a].from == sides[b].to && sides[a].to == sides[b].from;
  }
  std::uint32_t next(std::uint32_t side) const { return sides[side].next; }
  std::uint32_t prev(std::uint32_t side) const { return sides[side].prev; }
  // The first sides of the rings of a face.
  std::vector<std::uint32_t> rings_of(std::uint32_t face) const;
  // That only the first faces are played, and where rings are; usually empty.
  Text remark() const;

 private:
  void add_loop(const Mesh& mesh, Halfedge start);
};

// Why a mesh has no such list: it has no face.
std::optional<Text> why_no_side_list(const Mesh& mesh);

}  // namespace ryosen::steps
