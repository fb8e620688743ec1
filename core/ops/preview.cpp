#include "core/ops/preview.h"

#include "core/mesh/circulate.h"

namespace ryosen {

Preview preview(Mesh& mesh, Journal& journal, const AnyOp& op, std::size_t face_limit) {
  Preview result;
  result.verdict = check(mesh, op);
  if (!result.verdict.legal()) return result;
  result.warnings = warnings(mesh, op);
  Edit edit(mesh, &journal);
  OpEffect effect = apply(edit, op);
  result.created = std::move(effect.created);
  result.deleted = std::move(effect.deleted);
  result.outline_only = effect.changed.size() > face_limit;
  if (result.outline_only) return result;
  result.faces.reserve(effect.changed.size());
  for (Face f : effect.changed) {
    result.faces.push_back({f, {}});
    for (Vertex v : vertices_around(mesh, f)) result.faces.back().corners.push_back(mesh.position(v));
  }
  return result;
}

}  // namespace ryosen
