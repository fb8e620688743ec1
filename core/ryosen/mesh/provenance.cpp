#include "ryosen/mesh/provenance.h"

#include "ryosen/mesh/descent.h"

#ifdef RYOSEN_PROVENANCE
namespace ryosen {

std::optional<std::string> Provenance::untold(const Mesh& mesh) const {
  if (replacement_) return replacement_;
  for (const ElementKind kind : {ElementKind::vertex, ElementKind::edge, ElementKind::corner, ElementKind::face}) {
    const auto k = static_cast<std::size_t>(kind);
    for (const std::uint32_t index : created_[k])
      if (is_there(mesh.columns(), kind, index) && !told_[k].contains(index))
        return name_of(kind, index) + " was created without saying what its values come from";
    for (const std::uint32_t index : removed_[k]) {
      // A corner goes with its edge; one that lies outside now has the defaults.
      const bool is_gone = kind == ElementKind::corner
                               ? mesh.is_alive(Halfedge(index)) && mesh.is_outside(Halfedge(index))
                               : !is_there(mesh.columns(), kind, index) && !created_[k].contains(index);
      if (is_gone && !ended_[k].contains(index) && !(kind == ElementKind::corner && told_[k].contains(index)))
        return name_of(kind, index) + " was removed without saying what it is united with";
    }
  }
  return std::nullopt;
}

}  // namespace ryosen
#endif
