#include "ryosen/ops/each.h"

#include <algorithm>
#include <memory>
#include <set>
#include <unordered_map>
#include <utility>

#include "ryosen/base/index_set.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/find_element.h"
#include "ryosen/ops/op_series.h"
#include "ryosen/ops/rules/surgery.h"
#include "ryosen/ops/unite_series.h"

namespace ryosen {

namespace {

using Words = std::span<const std::string_view>;

// An edge as the halfedge from the lower point to the higher one, by the numbers that the series gives them.
Element directed(const Mesh& mesh, const OpSeries& series, const Element& e) {
  if (e.kind != Element::Kind::edge) return e;
  const auto number = [&](Vertex v) { return series.number(point(mesh, v)); };
  const Halfedge h = halfedge(e.edge(), 0);
  return number(mesh.from(h)) > number(mesh.to(h)) ? twin(h) : h;
}

// The halfedges that an element may be asked about at. Both sides of a wire lie along cycles of their own.
std::vector<Halfedge> asked_at(const Mesh& mesh, const Element& e) {
  if (e.kind == Element::Kind::edge) return {halfedge(e.edge(), 0), halfedge(e.edge(), 1)};
  if (e.kind != Element::Kind::halfedge) return {};
  const Halfedge h = e.halfedge();
  return mesh.is_outside(h) ? std::vector{h} : std::vector{h, twin(h)};
}

// What became of the subjects (op.h) that were asked about and are shared by several halfedges, so that many of one
// cost no more than one.
class AskedSubjects {
 public:
  bool is_done(std::span<const Halfedge> at) const {
    return std::any_of(at.begin(), at.end(), [&](Halfedge h) { return done_.contains(h.index); });
  }
  // The rule by which the subject was refused, if nothing has changed since then.
  const Rule* refused(std::span<const Halfedge> at) const {
    for (const Halfedge h : at)
      if (const auto found = refused_.find(h.index); found != refused_.end()) return &found->second;
    return nullptr;
  }
  void done(std::span<const Halfedge> subject) {
    for (const Halfedge h : subject) done_.insert(h.index);
    refused_.clear();
  }
  void refuse(std::span<const Halfedge> subject, Rule rule) {
    for (const Halfedge h : subject) refused_.emplace(h.index, rule);
  }

 private:
  IndexSet done_;
  std::unordered_map<std::uint32_t, Rule> refused_;
};

// The halfedges that share the subject of one; none if it has its own.
std::vector<Halfedge> with_same_subject(const Mesh& mesh, Subject subject, Halfedge h) {
  std::vector<Halfedge> same;
  if (subject == Subject::points) {
    for (const Halfedge sheet : sheets_between(mesh, mesh.from(h), mesh.to(h)))
      same.insert(same.end(), {sheet, twin(sheet)});
  } else if (subject == Subject::cycle) {
    for (const Halfedge other : loop(mesh, h)) same.push_back(other);
  }
  return same;
}

// Halfedges between two vertices, on points, one after another, at the cost of one where the first is one of many
// copies.
class HalfedgesBetween {
 public:
  // None where no edge joins them. Between two points that both have copies nothing may collapse, by whichever sheet.
  Halfedge find(const Mesh& mesh, Vertex from, Vertex to) {
    if (same_point(mesh, from, to)) return Halfedge();
    if (has_copies(mesh, from) && has_copies(mesh, to)) return any_between(mesh, point(mesh, from), point(mesh, to));
    if (has_copies(mesh, from) && is_asked_again(point(mesh, from), to)) return from_copy(mesh, from, to);
    const std::vector<Halfedge> sheets = sheets_between(mesh, from, to);
    return sheets.empty() ? Halfedge() : sheets.front();
  }
  bool are_joined(const Mesh& mesh, Vertex a, Vertex b) {
    const bool are_known = has_copies(mesh, a) && has_copies(mesh, b);
    return are_known ? bool(find(mesh, a, b)) : ryosen::are_joined(mesh, a, b);
  }
  // Call when the mesh has changed.
  void forget() {
    places_.clear();
    any_from_ = asked_from_ = {};
  }

 private:
  bool is_asked_again(Vertex from, Vertex to) {
    return std::exchange(asked_from_, from) == from && std::exchange(asked_to_, to) == to;
  }
  Halfedge any_between(const Mesh& mesh, Vertex from, Vertex to) {
    if (from != any_from_ || to != any_to_) any_ = any_sheet_between(mesh, from, to);
    any_from_ = from;
    any_to_ = to;
    return any_;
  }

  // The first one that is met from there on.
  Halfedge from_copy(const Mesh& mesh, Vertex from, Vertex to) {
    if (places_.empty() || !same_point(mesh, from, first_) || to != to_) {
      places_.clear();
      first_ = from;
      to_ = to;
      for_each_copy(mesh, from, [&](Vertex copy) { places_.emplace(copy, places_.size()); });
      sheets_ = sheets_between(mesh, from, to);
    }
    if (sheets_.empty()) return Halfedge();
    const auto is_before = [&](Halfedge h, std::size_t place) { return places_.at(mesh.from(h)) < place; };
    const auto found = std::lower_bound(sheets_.begin(), sheets_.end(), places_.at(from), is_before);
    return found == sheets_.end() ? sheets_.front() : *found;
  }

  Vertex first_, to_;
  std::unordered_map<Vertex, std::size_t> places_;    // of the copies, in their cycle from the first one
  std::vector<Halfedge> sheets_;                      // in this order
  Vertex any_from_, any_to_, asked_from_, asked_to_;  // points
  Halfedge any_;
};

class Calls {
 public:
  Calls(Edit& edit, const OpInfo& op, std::vector<OpArgument> arguments, bool strict)
      : edit_(edit), op_(op), arguments_(std::move(arguments)), strict_(strict), series_(series_of(op, edit)) {}

  // False where the arguments cannot be.
  bool call(const Element& e, const Element* with) {
    if (!is_alive(mesh(), e)) return ++result_.gone, true;
    const std::vector<Halfedge> at = asked_at(mesh(), e);
    if (subjects_.is_done(at)) return ++result_.done, true;
    if (const Rule* const rule = subjects_.refused(at)) return refuse(e, *rule), true;
    ParsedOp parsed = read(e, with);
    if (!parsed.op) {
      result_.error = parsed.error;
      result_.sentence = parsed.sentence;
      return false;
    }
    auto rule = broken_rule(*parsed.op);
    if (const auto along = rule && with ? read_along_edge(e, *with) : std::nullopt) {
      parsed.op = along;
      rule = broken_rule(*along);
    }
    Halfedge side = halfedge_of(*parsed.op);
    if (op_.subject == Subject::cycle && !rule && !mesh().is_outside(side)) side = twin(side);
    std::vector<Halfedge> same;
    if (!at.empty() && (op_.subject != Subject::cycle || mesh().is_outside(side)))
      same = with_same_subject(mesh(), op_.subject, side);
    if (rule) {
      subjects_.refuse(same, *rule);
      refuse(e, *rule);
      return true;
    }
    apply(*parsed.op);
    subjects_.done(same);
    return true;
  }

  bool are_joined(const Element& e, const Element& with) {
    return between_.are_joined(mesh(), e.vertex(), with.vertex());
  }
  // The operator that does the same along the edge between them; none where it may not or there is none.
  std::optional<AnyOp> legal_along_edge(const Element& e, const Element& with) {
    const auto along = read_along_edge(e, with);
    return along && !broken_rule(*along) ? along : std::nullopt;
  }
  // After it was found to be legal.
  void apply(const AnyOp& op) {
    series_->apply(op);
    between_.forget();
    ++result_.done;
    ++result_.calls;
  }

  void arguments(std::vector<OpArgument> arguments) { arguments_ = std::move(arguments); }
  // What was refused, to be asked again.
  std::vector<Element> take_refused() {
    std::vector<Element> all;
    for (const EachResult::Refused& refused : result_.refused)
      all.insert(all.end(), refused.elements.begin(), refused.elements.end());
    result_.refused.clear();
    subjects_ = {};
    std::sort(all.begin(), all.end());
    return all;
  }
  const Mesh& mesh() const { return edit_.mesh(); }
  EachResult& result() { return result_; }
  // After the last call.
  void finish() { series_->finish(); }

 private:
  ParsedOp read(const Element& e, const Element* with) const {
    std::vector<OpArgument> all;
    if (with) all.emplace_back(directed(mesh(), *series_, *with));
    all.emplace_back(directed(mesh(), *series_, e));
    all.insert(all.end(), arguments_.begin(), arguments_.end());
    return parse_op(mesh(), op_.id, all);
  }
  // The operator that does the same along the edge between the two, if there is one and the row names such an operator.
  std::optional<AnyOp> read_along_edge(const Element& e, const Element& with) {
    if (op_.along_edge.empty() || e.kind != Element::Kind::vertex || with.kind != Element::Kind::vertex)
      return std::nullopt;
    const Halfedge h = between_.find(mesh(), e.vertex(), with.vertex());
    if (!h) return std::nullopt;
    std::vector<OpArgument> all{Element(h)};
    all.insert(all.end(), arguments_.begin(), arguments_.end());
    return parse_op(mesh(), op_.along_edge, all).op;
  }
  std::optional<Rule> broken_rule(const AnyOp& op) {
    const auto rule = series_->broken_rule(op);
    return rule || !strict_ ? rule : series_->doubt(op);
  }
  void refuse(const Element& e, Rule rule) {
    const auto same = [&](const EachResult::Refused& r) { return r.rule == rule; };
    auto found = std::find_if(result_.refused.begin(), result_.refused.end(), same);
    if (found == result_.refused.end()) found = result_.refused.insert(found, {rule, {}});
    found->elements.push_back(e);
  }

  Edit& edit_;
  const OpInfo& op_;
  std::vector<OpArgument> arguments_;  // behind the elements
  bool strict_;
  std::unique_ptr<OpSeries> series_;
  AskedSubjects subjects_;
  HalfedgesBetween between_;
  EachResult result_;
};

// Each point once, and the sum never larger than the largest of them.
glm::dvec3 middle_of_vertices(const Mesh& mesh, std::span<const Element> elements) {
  IndexSet seen;
  glm::dvec3 middle(0);
  double n = 0;
  for (const Element& e : elements) {
    if (e.kind != Element::Kind::vertex || seen.contains(point(mesh, e.vertex()).index)) continue;
    seen.insert(point(mesh, e.vertex()).index);
    ++n;
    middle = middle * ((n - 1) / n) + mesh.position(e.vertex()) / n;
  }
  return middle;
}

}  // namespace

bool takes(const OpInfo& op, Element::Kind kind, Words arguments) {
  return !first_misfit(op.line, op_arguments(kind, op.on_selection == OnSelection::into_last ? 2 : 1, arguments));
}

std::size_t least_taken(const OpInfo& op) { return op.on_selection == OnSelection::into_last ? 2 : 1; }

CalledWith called_with(const Mesh& mesh, const OpInfo& op, std::span<const Element> elements, Words arguments) {
  CalledWith with;
  for (const Element& e : elements) (takes(op, e.kind, arguments) ? with.taken : with.others).push_back(e);
  const std::size_t least = least_taken(op);
  if (!op.in_place_of || with.taken.size() >= least) return with;
  std::vector<Element> found = op.in_place_of->elements(mesh, elements);
  if (found.size() < least) return with;
  return {std::move(found), {}, true};
}

namespace {

// What may stand for the last one after it was called with another, the first that lives: itself, the other one, or
// what is left of their points, where both were bare copies.
std::vector<Element> heirs_of(const Mesh& mesh, const Element& last, const Element& other) {
  std::vector<Element> heirs{last, other};
  for (const Element& e : {last, other})
    if (e.kind == Element::Kind::vertex && is_alive(mesh, e)) heirs.emplace_back(point(mesh, e.vertex()));
  return heirs;
}

// What stands for the last one from now on.
void hand_on(const Mesh& mesh, std::span<const Element> heirs, Element& last) {
  const auto heir = std::find_if(heirs.begin(), heirs.end(), [&](const Element& e) { return is_alive(mesh, e); });
  if (heir != heirs.end()) last = *heir;
}

// Those of a set to which edges lead from the point of a vertex, as the vertices there or what stands for their points.
std::vector<Element> beside(const Mesh& mesh, const Element& e, const std::set<Element>& among) {
  std::vector<Element> found;
  for_each_copy(mesh, e.vertex(), [&](Vertex copy) {
    if (mesh.is_isolated(copy)) return;
    for (const Halfedge h : outgoing(mesh, copy))
      for (const Vertex v : {mesh.to(h), point(mesh, mesh.to(h))})
        if (among.contains(Element(v))) found.emplace_back(v);
  });
  return found;
}

// First those to which edges lead from the last one, and on from there, in ascending order as far as they are reached;
// again those that were refused, as long as anything is done. What was done is taken out. So a patch comes together
// without being pinched: joined out of turn, its vertices would keep each other apart.
void call_along_edges(Calls& calls, std::vector<Element>& taken, Element& last, Progress& progress) {
  const Mesh& mesh = calls.mesh();
  const auto is_vertex = [](const Element& e) { return e.kind == Element::Kind::vertex; };
  if (!is_vertex(last) || !std::all_of(taken.begin(), taken.end(), is_vertex)) return;
  std::set<Element> left(taken.begin(), taken.end()), next, refused;
  const std::vector<Element> first = beside(mesh, last, left);
  next.insert(first.begin(), first.end());
  for (bool has_done = false; progress.go_on(taken.size() - left.size(), taken.size());) {
    if (next.empty() && std::exchange(has_done, false)) next.swap(refused);
    if (next.empty()) break;
    const Element e = next.extract(next.begin()).value();
    if (!is_alive(mesh, e) || !calls.are_joined(e, last)) continue;
    if (const auto along = calls.legal_along_edge(e, last)) {
      const std::vector<Element> around = beside(mesh, e, left), heirs = heirs_of(mesh, last, e);
      calls.apply(*along);
      hand_on(mesh, heirs, last);
      left.erase(e);
      for (const Element& other : around)
        if (!refused.contains(other)) next.insert(other);
      has_done = true;
    } else {
      refused.insert(e);
    }
  }
  std::erase_if(taken, [&](const Element& e) { return !left.contains(e); });
}

// In ascending order; again those that were refused, as long as anything is done, where `is_in_place`.
// There `strict` does all or nothing: no selection of what was done would say the same without it.
void call_in_turn(Calls& calls, std::vector<Element> taken, bool is_in_place, bool strict, Element* last,
                  Progress& progress) {
  std::sort(taken.begin(), taken.end());
  const std::size_t all = taken.size();
  while (true) {
    const std::size_t done = calls.result().done;
    for (std::size_t i = 0; i < taken.size(); ++i) {
      if (!progress.go_on(all - taken.size() + i, all)) return;
      const std::vector<Element> heirs = last ? heirs_of(calls.mesh(), *last, taken[i]) : std::vector<Element>();
      if (!calls.call(taken[i], last)) return;
      if (last) hand_on(calls.mesh(), heirs, *last);
    }
    if (!is_in_place || calls.result().refusals() == 0 || calls.result().done == done) break;
    taken = calls.take_refused();
  }
  if (is_in_place) calls.result().done += std::exchange(calls.result().gone, 0);
  if (is_in_place && strict && calls.result().refusals() > 0) calls.result().done = 0;
}

}  // namespace

EachResult apply_to_each(Edit& edit, const OpInfo& op, std::span<const Element> elements, Words arguments, bool strict,
                         Progress& progress) {
  Calls calls(edit, op, op_arguments(arguments), strict);
  CalledWith with = called_with(edit.mesh(), op, elements, arguments);
  std::vector<Element>& taken = with.taken;
  calls.result().others = std::move(with.others);
  std::vector<Vertex> ends_left;
  if (op.takes_ends_along && !with.is_in_place) ends_left = ends_with_more_edges(edit.mesh(), taken);
  Element last;
  const bool into_last = op.on_selection == OnSelection::into_last && !taken.empty();
  // In the middle of all of them, not of two at a time.
  if (into_last && taken.back().kind == Element::Kind::vertex && arguments.size() == 1 && arguments[0] == "mid")
    calls.arguments({middle_of_vertices(edit.mesh(), taken)});
  if (into_last) {
    last = taken.back();
    taken.pop_back();
    if (!op.along_edge.empty()) call_along_edges(calls, taken, last, progress);
  }
  call_in_turn(calls, std::move(taken), with.is_in_place, strict, into_last ? &last : nullptr, progress);
  calls.finish();
  if (calls.result().done > 0) calls.result().ends = unite_ends(edit, ends_left);
  return std::move(calls.result());
}

}  // namespace ryosen
