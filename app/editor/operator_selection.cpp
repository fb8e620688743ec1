#include "app/editor/operator_selection.h"

#include <algorithm>
#include <optional>

#include "app/editor/outcome.h"
#include "app/editor/session.h"
#include "core/ops/each.h"
#include "core/ops/lines/syntax.h"

namespace ryosen {

namespace {

constexpr std::size_t few = 64;  // with more, nobody waits for what each of them would say

Offer offer_of(const Mesh& mesh, const std::string& line) {
  const Parsed<AnyOp> parsed = parse_line(mesh, line);
  if (!parsed.op) return {false, {parsed.sentence}};
  const Verdict verdict = check(mesh, *parsed.op);
  return {verdict.legal(), describe_first(mesh, verdict.reasons)};
}

}  // namespace

std::vector<std::string> names_taken(const Session& session, const OpInfo& op,
                                     std::span<const std::string_view> arguments) {
  Elements taken;
  for (const Element& e : session.selection)
    if (takes(op, e.kind, arguments)) taken.push_back(e);
  return session.names_of(taken.empty() ? session.selection : taken);
}

bool fits_selection(const Session& session, const OpInfo& op, std::span<const std::string_view> arguments) {
  const Elements& selected = session.selection;
  const auto is_taken = [&](const Element& e) { return takes(op, e.kind, {}); };
  if (selected.empty() || op.on_selection == OnSelection::none) return false;
  if (op.on_selection != OnSelection::all)
    return called_with(session.mesh(), op, selected, arguments).taken.size() >= least_taken(op);
  if (selected.size() > few) return std::any_of(selected.begin(), selected.end(), is_taken);
  const std::vector<std::string> names = names_taken(session, op, {});
  return !fault_of_arguments(op.id, std::vector<std::string_view>(names.begin(), names.end()));
}

Offer offer_on_selection(const Session& session, const OpInfo& op) {
  const Elements& selected = session.selection;
  if (selected.size() > few || !fits_selection(session, op)) return {};
  const std::string id(op.id);
  if (op.on_selection == OnSelection::all) {
    std::string line = id;
    for (const std::string& name : names_taken(session, op, {})) line += " " + name;
    return offer_of(session.mesh(), line);
  }
  const CalledWith with = called_with(session.mesh(), op, selected, {});
  if (with.is_in_place || (op.on_selection == OnSelection::into_last && selected.size() > 1)) return {};
  std::optional<Offer> first;
  for (const std::string& name : session.names_of(with.taken)) {
    Offer offer = offer_of(session.mesh(), id + " " + name);
    if (offer.may_be) return {};
    if (!first) first = std::move(offer);
  }
  return first.value_or(Offer());
}

}  // namespace ryosen
