#include "core/ops/remedy.h"

#include "core/mesh/circulate.h"

namespace ryosen {

namespace {

constexpr std::size_t longest_remedy = 4;
constexpr std::size_t most_sides_tried = 12;

// Splits of the sides of faces named as witnesses.
void add_splits_of_sides(const Mesh& m, const Reason& reason, std::vector<AnyOp>& candidates) {
  for (const Element& witness : reason.witnesses) {
    if (witness.kind != Element::Kind::face) continue;
    std::size_t tried = 0;
    for (Halfedge h : halfedges_around(m, witness.face()))
      if (tried++ < most_sides_tried) candidates.push_back(SplitEdge{h});
  }
}

// Splits of the edges named as witnesses.
void add_splits_of_edges(const Reason& reason, std::vector<AnyOp>& candidates) {
  for (const Element& witness : reason.witnesses)
    if (witness.kind == Element::Kind::edge) candidates.push_back(SplitEdge{halfedge(witness.edge())});
}

// What may help against a reason; each is tried before it is named.
std::vector<AnyOp> candidates_for(const Mesh& m, const Reason& reason) {
  std::vector<AnyOp> candidates;
  switch (reason.rule) {
    case Rule::copies:
      candidates.push_back(Orient{});
      break;
    case Rule::closes_hole:
    case Rule::common_neighbour:
    case Rule::edge_exists:
      add_splits_of_edges(reason, candidates);
      break;
    case Rule::isolated_apex:
    case Rule::vanishes:
    case Rule::duplicate_face:
    case Rule::corner_twice:
    case Rule::loses_duplicate:
      add_splits_of_sides(m, reason, candidates);
      break;
    default:
      break;
  }
  return candidates;
}

// Whether the candidate leaves fewer reasons; the edge that the operator is about must stay as it is.
bool helps(Mesh& mesh, Journal& scratch, const AnyOp& op, const AnyOp& candidate, std::size_t reasons) {
  const auto* split = std::get_if<SplitEdge>(&candidate);
  const auto about = std::visit(
      [](const auto& o) {
        if constexpr (requires { o.halfedge; })
          return edge(o.halfedge);
        else
          return Edge();
      },
      op);
  if (split && edge(split->halfedge) == about) return false;
  if (!check(mesh, candidate).legal()) return false;
  Edit trial(mesh, &scratch);
  apply(trial, candidate);
  return check(mesh, op).reasons.size() < reasons;
}

}  // namespace

std::vector<std::string> find_remedy(Mesh& mesh, const AnyOp& op) {
  Journal steps;
  std::vector<std::string> commands;
  Verdict verdict = check(mesh, op);
  bool found = true;
  while (!verdict.legal() && found && commands.size() < longest_remedy) {
    found = false;
    for (const Reason& reason : verdict.reasons) {
      for (const AnyOp& candidate : candidates_for(mesh, reason)) {
        if (!helps(mesh, steps, op, candidate, verdict.reasons.size())) continue;
        commands.push_back(command_of(mesh, candidate));
        Edit edit(mesh, &steps);
        apply(edit, candidate);
        edit.commit();
        found = true;
        break;
      }
      if (found) break;
    }
    verdict = check(mesh, op);
  }
  const bool legal = verdict.legal();
  while (steps.can_undo()) steps.undo(mesh);
  return legal ? commands : std::vector<std::string>();
}

}  // namespace ryosen
