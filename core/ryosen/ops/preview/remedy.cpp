#include "ryosen/ops/preview/remedy.h"

#include <algorithm>

#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/preview/known_answers.h"

namespace ryosen {

namespace {

constexpr std::size_t longest_remedy = 4;
// Where an operator reaches further, every trial would be costly: it asks the question again.
constexpr std::size_t most_reached = 1000;

bool has_misoriented_edge(const Mesh& m, Vertex point) {
  return any_of_copies(m, point, [&](Vertex copy) {
    for (Halfedge h : outgoing(m, copy))
      if (point_edge(m, h).is_misoriented()) return true;
    return false;
  });
}

using PointPair = std::pair<Vertex, Vertex>;

PointPair points_of(const Mesh& m, Halfedge h) { return std::minmax(point(m, m.from(h)), point(m, m.to(h))); }

// The edge that is refused for the number of its faces, by its points.
std::optional<PointPair> edge_with_many_faces(const Mesh& m, const Reason& reason) {
  const std::vector<Element>& at = reason.witnesses;
  if (reason.rule != Rule::copies) return std::nullopt;
  if (at.size() == 1 && at[0].kind == Element::Kind::edge) return points_of(m, halfedge(at[0].edge()));
  if (at.size() == 2 && at[0].kind == Element::Kind::vertex && at[1].kind == Element::Kind::vertex)
    return std::minmax(at[0].vertex(), at[1].vertex());
  return std::nullopt;
}

// All of them, ascending.
std::vector<PointPair> edges_with_many_faces(const Mesh& m, const Verdict& verdict) {
  std::vector<PointPair> found;
  for (const Reason& reason : verdict.reasons)
    if (const std::optional<PointPair> points = edge_with_many_faces(m, reason)) found.push_back(*points);
  sort_unique(found);
  return found;
}

// Whether more than `most` sheets meet at a point, or at its edge to another one.
bool has_more_sheets(std::size_t most, const Mesh& m, Vertex at, std::optional<Vertex> to, KnownSheets& known) {
  std::vector<std::uint32_t> met;
  return any_of_copies(m, at, [&](Vertex copy) {
    for (Halfedge h : outgoing(m, copy)) {
      if (to && !same_point(m, m.to(h), *to)) continue;
      for (Halfedge side : {h, twin(h)}) {
        if (m.is_outside(side)) continue;
        const std::uint32_t number = known.number(m, m.face(side));
        if (std::find(met.begin(), met.end(), number) == met.end()) met.push_back(number);
      }
    }
    return met.size() > most;
  });
}

// Whether what is refused for the faces at its own edge will be so after that many steps. A step takes one sheet away
// from an edge, and of the sheets at a point hardly ever more than two: it may join two others.
bool outlasts(std::size_t steps, const Mesh& m, const AnyOp& op, Halfedge h, KnownSheets& known) {
  if (has_more_sheets(steps + 2, m, m.from(h), m.to(h), known)) return true;
  // Two points with several fans each do not collapse, whatever their edge.
  return std::holds_alternative<CollapseEdge>(op) && has_more_sheets(2 * steps + 1, m, m.from(h), {}, known) &&
         has_more_sheets(2 * steps + 1, m, m.to(h), {}, known);
}

// How many faces stand in the way that a step takes away or divides one at a time: triangles with the same third
// vertex, and what two points to be welded have in common.
std::size_t single_obstacles(const AnyOp& op, const Verdict& verdict) {
  std::vector<Element> faces;
  std::size_t same_apexes = 0;
  for (const Reason& reason : verdict.reasons) {
    same_apexes += reason.rule == Rule::same_apex;
    if (reason.rule == Rule::common_face && std::holds_alternative<Weld>(op)) faces.push_back(reason.witnesses[0]);
  }
  sort_unique(faces);
  return same_apexes + faces.size();
}

// Whether these steps will not help: there are more single obstacles, or the operator is refused for the faces at its
// own edge and they will stay.
bool is_hopeless(std::size_t steps, const Mesh& m, const AnyOp& op, const Verdict& verdict, KnownSheets& known) {
  if (single_obstacles(op, verdict) > steps) return true;
  const Halfedge h = halfedge_of(op);
  if (!is_there(m, h)) return false;
  const std::vector<PointPair> refused = edges_with_many_faces(m, verdict);
  return std::binary_search(refused.begin(), refused.end(), points_of(m, h)) && outlasts(steps, m, op, h, known);
}

// The edges that stay refused for the number of their faces after a step: the edge itself and, of an operator on a
// cycle, those of the cycle; ascending.
std::vector<PointPair> edges_that_outlast_a_step(const Mesh& m, const AnyOp& op, const Verdict& verdict,
                                                 KnownSheets& known) {
  std::vector<PointPair> staying;
  const Halfedge h = halfedge_of(op);
  const std::vector<PointPair> refused = edges_with_many_faces(m, verdict);
  if (!is_there(m, h) || refused.empty()) return staying;
  const auto look = [&](Halfedge side) {
    const PointPair points = points_of(m, side);
    if (std::binary_search(refused.begin(), refused.end(), points) && outlasts(1, m, op, side, known))
      staying.push_back(points);
  };
  if (info_of(op).subject != Subject::cycle)
    look(h);
  else
    for (Halfedge side : loop(m, h)) look(side);
  sort_unique(staying);
  return staying;
}

bool is_slot(std::string_view word) {
  if (word.starts_with('~')) word.remove_prefix(1);
  return word.size() > 1 && (word[0] == 'h' || word[0] == 'e') && word[1] >= '0' && word[1] <= '9';
}

// Whether the line names an edge by slot (h12, e6), which may mean another edge after other edits.
bool names_a_slot(std::string_view line) {
  const std::vector<std::string_view> words = split_words(line);
  return std::any_of(words.begin(), words.end(), is_slot);
}

// The refused operator as a script line. Remedies may change slots and delete faces, so it is parsed again from its
// names.
struct Question {
  std::string line;   // as given
  std::string plain;  // with names instead of slots

  // The operator on the current mesh; none if a name no longer exists or the two lines mean different elements.
  std::optional<AnyOp> in(const Mesh& mesh) const {
    const ParsedOp asked = parse_line(mesh, line);
    if (!asked.op || line == plain) return asked.op;
    const ParsedOp named = parse_line(mesh, plain);
    return named.op && command_of(mesh, *named.op) == command_of(mesh, *asked.op) ? asked.op : std::nullopt;
  }

  // Whether a name is by a face that the candidate deletes (0-1@f5): it would mean nothing afterwards.
  bool loses_its_name(const AnyOp& candidate) const {
    Face face;
    if (const auto* loop = std::get_if<DeleteLoop>(&candidate)) face = loop->face;
    if (const auto* any = std::get_if<Delete>(&candidate); any && any->element.kind == Element::Kind::face)
      face = any->element.face();
    if (face.is_none()) return false;
    const std::string suffix = "@f" + std::to_string(face.index);
    const std::vector<std::string_view> words = split_words(plain);
    return std::any_of(words.begin(), words.end(), [&](std::string_view word) { return word.ends_with(suffix); });
  }

  // Misoriented strips that are turned may have one long cycle where there were many.
  bool reaches_further(const Mesh& mesh) const {
    const std::optional<AnyOp> op = in(mesh);
    return op && ryosen::reaches_further(mesh, *op, most_reached);
  }

  std::optional<std::size_t> reasons_against(const Mesh& mesh) const {
    const std::optional<AnyOp> op = in(mesh);
    return op ? std::optional(check(mesh, *op).reasons.size()) : std::nullopt;
  }
};

// The number of reasons left after a candidate; none if it is not legal or the line no longer parses afterwards.
std::optional<std::size_t> reasons_after(Mesh& mesh, const Question& question, const AnyOp& candidate) {
  if (question.loses_its_name(candidate) || !check(mesh, candidate).legal()) return std::nullopt;
  Journal scratch;
  Edit trial(mesh, &scratch);
  apply(trial, candidate);
  return question.reasons_against(mesh);
}

struct Step {
  AnyOp op;
  bool is_last = false;  // no reason is left
};

// The first candidate that leaves no reason, else the first that leaves fewer. Else one of many equal steps: with
// several sheets at an edge or several edges at a vertex the reason stays until the last one is detached or deleted.
// None if it would have to be the last one and cannot be.
std::optional<Step> choose_step(Mesh& mesh, const Question& question, const AnyOp& op, bool must_be_last,
                                KnownSheets& sheets) {
  const Verdict verdict = check(mesh, op);
  const std::vector<PointPair> staying = edges_that_outlast_a_step(mesh, op, verdict, sheets);
  if (must_be_last && !staying.empty()) return std::nullopt;
  const auto stays = [&](const Reason& reason) {
    const std::optional<PointPair> points = edge_with_many_faces(mesh, reason);
    return points && std::binary_search(staying.begin(), staying.end(), *points);
  };
  std::optional<Step> best, onward;
  std::unordered_map<std::string, std::optional<std::size_t>> tried;  // several reasons may suggest the same
  for (const Reason& reason : verdict.reasons) {
    const bool outlasts_this = stays(reason);  // then no step against it does better than the first that leads on
    if (outlasts_this && onward) continue;
    for (const AnyOp& candidate : remedy_candidates(mesh, reason, sheets)) {
      const auto [known, is_new] = tried.try_emplace(command_of(mesh, candidate));
      if (is_new) known->second = reasons_after(mesh, question, candidate);
      const std::optional<std::size_t> left = known->second;
      if (left == 0u) return Step{candidate, true};
      if (left && *left < verdict.reasons.size() && !best) best = Step{candidate};
      const bool is_one_of_many = std::holds_alternative<Detach>(candidate) || reason.rule == Rule::has_edges;
      if (left == verdict.reasons.size() && !onward && is_one_of_many) onward = Step{candidate};
      if (outlasts_this && onward) break;
    }
  }
  return best ? best : onward;
}

// Greedy search of at most `most` steps until the operator is legal. `sheets` is the cache for the initial mesh.
std::vector<std::string> find_local_steps(Mesh& mesh, const Question& question, std::size_t most, KnownSheets& sheets) {
  Journal steps;
  std::vector<std::string> commands;
  bool legal = false;
  for (;;) {
    const std::optional<AnyOp> now = question.in(mesh);
    KnownSheets after_steps;
    KnownSheets& known = commands.empty() ? sheets : after_steps;
    const std::optional<Step> step =
        now ? choose_step(mesh, question, *now, commands.size() + 1 == most, known) : std::nullopt;
    if (!step) break;
    commands.push_back(command_of(mesh, step->op));
    legal = step->is_last;
    if (legal || commands.size() == most) break;
    Edit edit(mesh, &steps);
    apply(edit, step->op);
    edit.commit();
  }
  while (steps.can_undo()) steps.undo(mesh);
  return legal ? commands : std::vector<std::string>();
}

}  // namespace

RemedySearch::RemedySearch(Mesh& mesh) : mesh_(mesh) {}
RemedySearch::~RemedySearch() = default;

Mesh* RemedySearch::oriented() {
  if (!orient_was_tried_ && check(mesh_, Orient()).legal()) {
    oriented_ = std::make_unique<Mesh>(mesh_);
    Edit edit(*oriented_, nullptr);
    apply(edit, Orient());
    edit.commit();
  }
  orient_was_tried_ = true;
  return oriented_.get();
}

// Flipping faces helps only against Rule::copies, and only if an edge at the points of the witnesses is misoriented.
bool RemedySearch::is_beside_misoriented_edge(const Reason& reason) {
  if (reason.rule != Rule::copies) return false;
  return std::any_of(reason.witnesses.begin(), reason.witnesses.end(), [&](const Element& witness) {
    const Vertex v = witness.kind == Element::Kind::vertex ? witness.vertex()
                     : witness.kind == Element::Kind::edge ? mesh_.from(halfedge(witness.edge()))
                                                           : Vertex();
    if (!v) return false;
    const auto [known, is_new] = beside_misoriented_.try_emplace(point(mesh_, v));
    if (is_new) known->second = has_misoriented_edge(mesh_, v);
    return known->second;
  });
}

std::vector<std::string> RemedySearch::find(const std::string& line) {
  const ParsedOp asked = parse_line(mesh_, line);
  if (!asked.op || reaches_further(mesh_, *asked.op, most_reached)) return {};
  const Verdict verdict = check(mesh_, *asked.op);
  if (verdict.legal() || verdict.has(Rule::deleted)) return {};
  if (is_hopeless(longest_remedy, mesh_, *asked.op, verdict, sheets_)) return {};
  const Question question{line, names_a_slot(line) ? command_of(mesh_, *asked.op) : line};
  const bool may_turn = std::any_of(verdict.reasons.begin(), verdict.reasons.end(),
                                    [&](const Reason& reason) { return is_beside_misoriented_edge(reason); });
  Mesh* turned = may_turn ? oriented() : nullptr;
  if (turned && question.reaches_further(*turned)) turned = nullptr;
  if (turned && question.reasons_against(*turned) == 0u) return {"orient"};
  std::vector<std::string> steps = find_local_steps(mesh_, question, longest_remedy, sheets_);
  if (!steps.empty() || !turned) return steps;
  steps = find_local_steps(*turned, question, longest_remedy - 1, sheets_when_turned_);
  if (!steps.empty()) steps.insert(steps.begin(), "orient");
  return steps;
}

std::vector<std::string> find_remedy(Mesh& mesh, const AnyOp& op) {
  if (check(mesh, op).has(Rule::deleted)) return {};
  return RemedySearch(mesh).find(command_of(mesh, op));
}

}  // namespace ryosen
