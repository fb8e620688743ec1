#include "core/ops/outlook/remedy.h"

#include <algorithm>

#include "core/mesh/circulate.h"
#include "core/mesh/copies.h"

namespace ryosen {

namespace {

constexpr std::size_t longest_remedy = 4;

// Flipping faces helps only against Rule::copies, and only if an edge at the points of the witnesses is misoriented.
bool is_beside_misoriented_edge(const Mesh& m, const Reason& reason) {
  if (reason.rule != Rule::copies) return false;
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
    const Parsed<AnyOp> asked = parse_line(mesh, line);
    if (!asked.op || line == plain) return asked.op;
    const Parsed<AnyOp> named = parse_line(mesh, plain);
    return named.op && command_of(mesh, *named.op) == command_of(mesh, *asked.op) ? asked.op : std::nullopt;
  }

  std::optional<std::size_t> reasons_against(const Mesh& mesh) const {
    const std::optional<AnyOp> op = in(mesh);
    return op ? std::optional(check(mesh, *op).reasons.size()) : std::nullopt;
  }
};

// The number of reasons left after a candidate; none if it is not legal or the line no longer parses afterwards.
std::optional<std::size_t> reasons_after(Mesh& mesh, const Question& question, const AnyOp& candidate) {
  if (!check(mesh, candidate).legal()) return std::nullopt;
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
std::optional<Step> choose_step(Mesh& mesh, const Question& question, const Verdict& verdict, KnownSheets& sheets) {
  std::optional<Step> best, onward;
  for (const Reason& reason : verdict.reasons) {
    for (const AnyOp& candidate : remedy_candidates(mesh, reason, sheets)) {
      const auto left = reasons_after(mesh, question, candidate);
      if (left == 0u) return Step{candidate, true};
      if (left && *left < verdict.reasons.size() && !best) best = Step{candidate};
      const bool is_one_of_many = std::holds_alternative<Detach>(candidate) || reason.rule == Rule::has_edges;
      if (left == verdict.reasons.size() && !onward && is_one_of_many) onward = Step{candidate};
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
    const std::optional<Step> step = now ? choose_step(mesh, question, check(mesh, *now), known) : std::nullopt;
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

std::vector<std::string> RemedySearch::find(const std::string& line) {
  const Parsed<AnyOp> asked = parse_line(mesh_, line);
  if (!asked.op) return {};
  const Verdict verdict = check(mesh_, *asked.op);
  if (verdict.legal() || verdict.has(Rule::deleted)) return {};
  const Question question{line, names_a_slot(line) ? command_of(mesh_, *asked.op) : line};
  const bool may_turn = std::any_of(verdict.reasons.begin(), verdict.reasons.end(),
                                    [&](const Reason& reason) { return is_beside_misoriented_edge(mesh_, reason); });
  Mesh* const turned = may_turn ? oriented() : nullptr;
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
