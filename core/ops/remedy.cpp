#include "core/ops/remedy.h"

#include "core/mesh/circulate.h"
#include "core/mesh/copies.h"

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

// Cuts through the faces named as witnesses.
void add_triangulations(const Reason& reason, std::vector<AnyOp>& candidates) {
  for (const Element& witness : reason.witnesses)
    if (witness.kind == Element::Kind::face) candidates.push_back(Triangulate{witness.face()});
}

// Turning faces helps only where some edge at the points of the witnesses is misoriented.
bool is_beside_misoriented_edge(const Mesh& m, const Reason& reason) {
  for (const Element& witness : reason.witnesses) {
    const Vertex v = witness.kind == Element::Kind::vertex ? witness.vertex()
                     : witness.kind == Element::Kind::edge ? m.from(halfedge(witness.edge()))
                                                           : Vertex();
    if (!v) continue;
    bool found = false;
    for_each_copy(m, v, [&](Vertex copy) {
      for (Halfedge h : outgoing(m, copy)) found = found || point_edge(m, h).is_misoriented();
    });
    if (found) return true;
  }
  return false;
}

// What may help against a reason; each is tried before it is named.
std::vector<AnyOp> candidates_for(const Mesh& m, const Reason& reason) {
  std::vector<AnyOp> candidates;
  switch (reason.rule) {
    case Rule::copies:
      if (is_beside_misoriented_edge(m, reason)) candidates.push_back(Orient{});
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
    case Rule::has_rings:
      add_triangulations(reason, candidates);
      break;
    default:
      break;
  }
  return candidates;
}

// The reasons against the operator that a script line names, as the mesh is now; none when it names none any more.
std::optional<std::size_t> reasons_against(const Mesh& mesh, const std::string& line) {
  const Parsed<AnyOp> parsed = parse_line(mesh, line);
  if (!parsed.op) return std::nullopt;
  return check(mesh, *parsed.op).reasons.size();
}

bool helps(Mesh& mesh, const std::string& line, const AnyOp& candidate, std::size_t reasons) {
  if (!check(mesh, candidate).legal()) return false;
  Journal scratch;
  Edit trial(mesh, &scratch);
  apply(trial, candidate);
  const auto left = reasons_against(mesh, line);
  return left && *left < reasons;
}

}  // namespace

std::vector<std::string> find_remedy(Mesh& mesh, const AnyOp& op) {
  // Remedies may renumber edges, so the operator is spoken of by its script line.
  const std::string line = command_of(mesh, op);
  Journal steps;
  std::vector<std::string> commands;
  const auto take_one_step = [&](const Verdict& verdict) {
    for (const Reason& reason : verdict.reasons) {
      for (const AnyOp& candidate : candidates_for(mesh, reason)) {
        if (!helps(mesh, line, candidate, verdict.reasons.size())) continue;
        commands.push_back(command_of(mesh, candidate));
        Edit edit(mesh, &steps);
        apply(edit, candidate);
        edit.commit();
        return true;
      }
    }
    return false;
  };
  bool legal = false;
  while (!legal && commands.size() < longest_remedy) {
    const Parsed<AnyOp> now = parse_line(mesh, line);
    if (!now.op || !take_one_step(check(mesh, *now.op))) break;
    legal = reasons_against(mesh, line) == 0u;
  }
  while (steps.can_undo()) steps.undo(mesh);
  return legal ? commands : std::vector<std::string>();
}

}  // namespace ryosen
