#include "ryosen/ops/preview/known_answers.h"

#include <algorithm>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/rings.h"
#include "ryosen/ops/preview/preview.h"

namespace ryosen {

namespace {

constexpr std::size_t most_faces_looked_at = 400;

bool name(const std::vector<Reason>& reasons, Edge e) {
  return std::any_of(reasons.begin(), reasons.end(), [&](const Reason& reason) {
    return std::find(reason.witnesses.begin(), reason.witnesses.end(), Element(e)) != reason.witnesses.end();
  });
}

// Along a cycle several reasons come in the order from the edge that was asked about, and warnings from its start.
bool holds_for_all(const Answer& answer, const AnyOp& op) {
  const Edge asked = edge(halfedge_of(op));
  const bool is_cycle = info_of(op).subject == Subject::cycle;
  return !name(answer.verdict.reasons, asked) &&
         (is_cycle ? answer.verdict.reasons.size() <= 1 : !name(answer.warnings, asked));
}

bool has_higher_valence(const Mesh& m, Vertex v, std::size_t most) {
  std::size_t valence = 0;
  return any_of_copies(m, v, [&](Vertex copy) {
    for ([[maybe_unused]] Halfedge h : outgoing(m, copy))
      if (++valence > most) return true;
    return false;
  });
}

bool is_longer_cycle(const Mesh& m, Halfedge h, std::size_t most) {
  std::size_t length = 0;
  for ([[maybe_unused]] Halfedge side : loop(m, h))
    if (++length > most) return true;
  return false;
}

}  // namespace

bool reaches_further(const Mesh& m, const AnyOp& op, std::size_t most) {
  const Halfedge h = halfedge_of(op);
  if (!is_there(m, h)) return false;
  if (is_longer_cycle(m, h, most) || is_longer_cycle(m, twin(h), most)) return true;
  return (std::holds_alternative<CollapseEdge>(op) || std::holds_alternative<ExtrudeEdges>(op)) &&
         (has_higher_valence(m, m.from(h), most) || has_higher_valence(m, m.to(h), most));
}

Halfedge KnownAnswers::first_of_cycle(const Mesh& mesh, Halfedge h) {
  if (const auto known = first_of_cycle_.find(h); known != first_of_cycle_.end()) return known->second;
  for (Halfedge side : loop(mesh, h)) first_of_cycle_[side] = h;
  return h;
}

// None if the edge shares its subject with no other one.
std::optional<std::uint64_t> KnownAnswers::subject(const Mesh& mesh, const AnyOp& op) {
  const Halfedge h = halfedge_of(op);
  const OpInfo& info = info_of(op);
  if (!is_there(mesh, h)) return std::nullopt;
  if (info.subject == Subject::cycle && mesh.is_outside(h)) return first_of_cycle(mesh, h).index;
  if (info.subject != Subject::points || is_bridge(mesh, h) || !is_cut_on_points(mesh, h)) return std::nullopt;
  return std::uint64_t{point(mesh, mesh.from(h)).index} << 32u | point(mesh, mesh.to(h)).index;
}

// Calls add_warnings(answer, whether it is about more than the edge) for a new answer that is legal.
template <class Warn>
Answer KnownAnswers::ask(const Mesh& mesh, const AnyOp& op, const Warn& add_warnings) {
  const std::optional<std::uint64_t> about = subject(mesh, op);
  if (about)
    if (const auto known = answers_.find(*about); known != answers_.end()) return known->second;
  Answer answer{check(mesh, op, facts_), {}};
  if (answer.verdict.legal()) add_warnings(answer, about.has_value());
  if (about && holds_for_all(answer, op)) answers_.emplace(*about, answer);
  return answer;
}

Answer KnownAnswers::ask(Mesh& mesh, const AnyOp& op, bool geometry) {
  return ask(mesh, op, [&](Answer& answer, bool is_shared) {
    if (!geometry) return;
    answer.warnings = !is_shared && reaches_further(mesh, op, most_faces_looked_at)
                          ? std::vector<Reason>{{Rule::shape_unseen, {}}}
                          : preview(mesh, journal_, op).warnings;
  });
}

Answer KnownAnswers::ask(const Mesh& mesh, const AnyOp& op) {
  return ask(mesh, op, [](Answer&, bool) {});
}

}  // namespace ryosen
