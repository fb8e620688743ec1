#include "app/editor/operator_selection.h"

#include <algorithm>
#include <optional>

#include "app/editor/session.h"
#include "core/ops/each.h"
#include "core/ops/lines/syntax.h"

namespace ryosen {

namespace {

Verdict verdict_on(const Mesh& mesh, const std::string& line) {
  const Parsed<AnyOp> parsed = parse_line(mesh, line);
  return parsed.op ? check(mesh, *parsed.op) : Verdict();
}

}  // namespace

std::vector<std::string> names_taken(const Session& session, const OpInfo& op,
                                     std::span<const std::string_view> arguments) {
  Elements taken;
  for (const Element& e : session.selection)
    if (takes(op, e.kind, arguments)) taken.push_back(e);
  return session.names_of(taken.empty() ? session.selection : taken);
}

bool fits_selection(const Session& session, const OpInfo& op) {
  const Elements& selected = session.selection;
  const auto is_taken = [&](const Element& e) { return takes(op, e.kind, {}); };
  if (selected.empty() || op.on_selection == OnSelection::none) return false;
  if (op.on_selection != OnSelection::all) return !called_with(session.mesh(), op, selected, {}).taken.empty();
  constexpr std::size_t most = 1000;  // with more, only those count that it takes any number of
  if (selected.size() > most) return std::any_of(selected.begin(), selected.end(), is_taken);
  const std::vector<std::string> names = names_taken(session, op, {});
  return !fault_of_arguments(op.id, std::vector<std::string_view>(names.begin(), names.end()));
}

Verdict verdict_on_selection(const Session& session, const OpInfo& op) {
  constexpr std::size_t most = 64;
  const Elements& selected = session.selection;
  if (selected.empty() || selected.size() > most || !fits_selection(session, op)) return {};
  const std::string id(op.id);
  if (op.on_selection == OnSelection::all) {
    std::string line = id;
    for (const std::string& name : names_taken(session, op, {})) line += " " + name;
    return verdict_on(session.mesh(), line);
  }
  const CalledWith with = called_with(session.mesh(), op, selected, {});
  if (with.is_in_place || (op.on_selection == OnSelection::into_last && selected.size() > 1)) return {};
  std::optional<Verdict> first;
  for (const std::string& name : session.names_of(with.taken)) {
    Verdict verdict = verdict_on(session.mesh(), id + " " + name);
    if (verdict.legal()) return {};
    if (!first) first = std::move(verdict);
  }
  return first.value_or(Verdict());
}

}  // namespace ryosen
