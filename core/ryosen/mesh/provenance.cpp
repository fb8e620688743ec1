#include "ryosen/mesh/provenance.h"

#include "ryosen/mesh/mesh.h"

#ifdef RYOSEN_PROVENANCE
namespace ryosen {

namespace {

constexpr const char* letters[] = {"v", "e", "corner h", "f"};

bool is_there(const Mesh& mesh, ElementKind kind, std::uint32_t index) {
  switch (kind) {
    case ElementKind::vertex:
      return mesh.is_alive(Vertex(index));
    case ElementKind::edge:
      return mesh.is_alive(Edge(index));
    case ElementKind::corner:
      return mesh.is_alive(Halfedge(index)) && !mesh.is_outside(Halfedge(index));
    default:
      return mesh.is_alive(Face(index));
  }
}

}  // namespace

std::optional<std::string> Provenance::untold(const Mesh& mesh) const {
  for (const ElementKind kind : {ElementKind::vertex, ElementKind::edge, ElementKind::corner, ElementKind::face}) {
    const auto k = static_cast<std::size_t>(kind);
    for (const std::uint32_t index : created_[k])
      if (is_there(mesh, kind, index) && !told_[k].contains(index))
        return letters[k] + std::to_string(index) + " was created without saying what its values come from";
    for (const std::uint32_t index : removed_[k]) {
      // A corner goes with its edge; one that lies outside now has the defaults.
      const bool is_gone = kind == ElementKind::corner
                               ? mesh.is_alive(Halfedge(index)) && mesh.is_outside(Halfedge(index))
                               : !is_there(mesh, kind, index) && !created_[k].contains(index);
      if (is_gone && !ended_[k].contains(index) && !(kind == ElementKind::corner && told_[k].contains(index)))
        return letters[k] + std::to_string(index) + " was removed without saying what it is united with";
    }
  }
  return std::nullopt;
}

}  // namespace ryosen
#endif
