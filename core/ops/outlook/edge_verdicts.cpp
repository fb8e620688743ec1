#include "core/ops/outlook/edge_verdicts.h"

#include "core/ops/outlook/known_answers.h"

namespace ryosen {

std::vector<EdgeVerdict> edge_verdicts(const Mesh& mesh, const OpInfo& op) {
  std::vector<EdgeVerdict> verdicts(mesh.edge_slots(), EdgeVerdict::none);
  if (op.target != OpTargetKind::edge) return verdicts;
  KnownAnswers answers;
  for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
    if (!mesh.is_alive(Edge(i))) continue;
    const bool is_legal = answers.ask(mesh, op_at(mesh, op.id, {halfedge(Edge(i))})).verdict.legal();
    verdicts[i] = is_legal ? EdgeVerdict::legal : EdgeVerdict::refused;
  }
  return verdicts;
}

}  // namespace ryosen
