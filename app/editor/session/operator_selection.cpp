#include "app/editor/session/operator_selection.h"

#include <algorithm>
#include <optional>

#include "app/editor/document/findings.h"
#include "app/editor/session/selecting.h"
#include "ryosen/document/outcome.h"
#include "ryosen/mesh/mesh.h"
#include "ryosen/ops/all.h"
#include "ryosen/ops/each.h"
#include "ryosen/scene/selection/selectors.h"

namespace ryosen {

namespace {

constexpr std::size_t few = 64;  // with more, nobody waits for what each of them would say

Offer offer_of(const Mesh& mesh, const OpInfo& op, std::span<const Element> elements) {
  const ParsedOp parsed = parse_op(mesh, op.id, op_arguments(elements));
  if (!parsed.op) return {false, {parsed.sentence}};
  const Verdict verdict = check(mesh, *parsed.op);
  return {verdict.legal(), describe_first(mesh, verdict.reasons)};
}

// All of a kind but what is hidden, points in place of vertices.
Elements all_seen(const Findings& findings, Element::Kind kind) {
  Elements all = find_selector("all")->find(findings.mesh(), {}, kind, {});
  findings.drop_hidden(all);
  return all;
}

// Whether that is selected. A look at the numbers where nothing is hidden and no point has copies.
bool is_all_selected(const Findings& findings, const Selecting& selecting, Element::Kind kind) {
  const Mesh& mesh = findings.mesh();
  const ElementCounts live = mesh.live();
  const std::size_t selected = selecting.selection.count(kind);
  if (selected == 0) return false;
  const bool is_vertex = kind == Element::Kind::vertex, is_face = kind == Element::Kind::face;
  if (!findings.hidden().empty() || (is_vertex && mesh.has_copies()))
    return selected >= all_seen(findings, kind).size();
  return selected == (is_vertex ? live.vertices
                      : is_face ? live.faces
                                : live.edges) ||
         (kind == Element::Kind::halfedge && selected == 2 * std::size_t{live.edges});
}

// The kind that an operator takes in place of the selection; none where that stands.
std::optional<Element::Kind> kind_in_place(const Findings& findings, const Selecting& selecting, const OpInfo& op,
                                           std::span<const std::string_view> arguments) {
  constexpr Element::Kind kinds[] = {Element::Kind::face, Element::Kind::edge, Element::Kind::halfedge,
                                     Element::Kind::vertex};
  const Selection& selected = selecting.selection;
  if (selected.empty() || op.on_selection == OnSelection::none) return std::nullopt;
  std::optional<Element::Kind> taken;
  bool is_all = false;
  for (const Element::Kind kind : kinds) {
    if (takes(op, kind, arguments)) {
      if (selected.count(kind) > 0) return std::nullopt;
      if (!taken) taken = kind;
    }
  }
  if (!taken || (op.in_place_of && op.in_place_of->elements(findings.mesh(), selected).size() >= least_taken(op)))
    return std::nullopt;
  for (const Element::Kind kind : kinds) is_all = is_all || is_all_selected(findings, selecting, kind);
  return is_all ? taken : std::nullopt;
}

}  // namespace

Elements worked_on(const Findings& findings, const Selecting& selecting, const OpInfo& op,
                   std::span<const std::string_view> arguments) {
  const auto kind = kind_in_place(findings, selecting, op, arguments);
  return kind ? all_seen(findings, *kind) : static_cast<const Elements&>(selecting.selection);
}

Elements elements_taken(const OpInfo& op, const Elements& elements, std::span<const std::string_view> arguments) {
  Elements taken;
  for (const Element& e : elements)
    if (takes(op, e.kind, arguments)) taken.push_back(e);
  return taken.empty() ? elements : taken;
}

ParsedOp op_on_selection(const Findings& findings, const Selecting& selecting, const OpInfo& op,
                         std::span<const std::string_view> arguments) {
  Elements taken;
  if (op.on_selection == OnSelection::all)
    taken = elements_taken(op, worked_on(findings, selecting, op, arguments), arguments);
  return parse_op(findings.mesh(), op.id, op_arguments(taken, arguments));
}

bool fits_selection(const Findings& findings, const Selecting& selecting, const OpInfo& op,
                    std::span<const std::string_view> arguments) {
  if (selecting.selection.empty() || op.on_selection == OnSelection::none) return false;
  const auto kind = kind_in_place(findings, selecting, op, arguments);
  if (kind && selecting.selection.size() > few) return true;
  const Elements in_place = kind ? all_seen(findings, *kind) : Elements();
  const Elements& selected = kind ? in_place : static_cast<const Elements&>(selecting.selection);
  const auto is_taken = [&](const Element& e) { return takes(op, e.kind, {}); };
  if (op.on_selection != OnSelection::all)
    return called_with(findings.mesh(), op, selected, arguments).taken.size() >= least_taken(op);
  if (selected.size() > few) return std::any_of(selected.begin(), selected.end(), is_taken);
  return !fault_of_arguments(op.id, op_arguments(elements_taken(op, selected, {})));
}

Offer offer_on_selection(const Findings& findings, const Selecting& selecting, const OpInfo& op) {
  if (selecting.selection.size() > few || !fits_selection(findings, selecting, op)) return {};
  const Elements selected = worked_on(findings, selecting, op, {});
  if (selected.size() > few) return {};
  if (op.on_selection == OnSelection::all) return offer_of(findings.mesh(), op, elements_taken(op, selected, {}));
  const CalledWith with = called_with(findings.mesh(), op, selected, {});
  if (with.is_in_place || (op.on_selection == OnSelection::into_last && selected.size() > 1)) return {};
  std::optional<Offer> first;
  for (const Element& e : with.taken) {
    Offer offer = offer_of(findings.mesh(), op, {&e, 1});
    if (offer.may_be) return {};
    if (!first) first = std::move(offer);
  }
  return first.value_or(Offer());
}

}  // namespace ryosen
