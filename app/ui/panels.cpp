#include "app/ui/panels.h"

#include <array>

#include "app/editor/command_syntax.h"
#include "app/editor/commands.h"
#include "app/editor/words.h"
#include "app/ui/panels/all.h"
#include "core/analysis/boundary_loops.h"

namespace ryosen {

namespace {

constexpr std::array list{
    Panel{UiText::tools, Side::left, draw_tools},          Panel{UiText::highlights, Side::left, draw_highlights},
    Panel{UiText::totals, Side::left, draw_totals},        Panel{UiText::pointer, Side::right, draw_verdict},
    Panel{UiText::inspector, Side::right, draw_inspector}, Panel{UiText::problems, Side::right, draw_problems},
    Panel{UiText::history, Side::right, draw_history},     Panel{UiText::forms, Side::right, draw_forms},
};

}  // namespace

std::span<const Panel> panels() { return list; }

void GuiState::know(const Session& session) {
  const Document& document = session.document();
  if (known_document_ == document.serial() && known_set_aside_ == document.tables().quarantine.size()) return;
  known_set_aside_ = document.tables().quarantine.size();
  known_document_ = document.serial();
  known_loops_.reset();
  for (const ProblemRow& row : problem_table()) {
    std::vector<Element>& faces = quarantined_[static_cast<std::size_t>(row.kind)];
    faces.clear();
    if (!row.quarantined) continue;
    for (const QuarantinedFace& face : document.tables().quarantine)
      if (row.quarantined(face, session.mesh().file_vertices())) faces.emplace_back(Face(face.face));
  }
}

std::size_t GuiState::findings(Session& session, const ProblemRow& row) {
  know(session);
  if (row.quarantined) return quarantined_[static_cast<std::size_t>(row.kind)].size();
  if (row.kind == ProblemKind::boundary_loop) return session.boundary_loops().count();
  return session.highlights().count(row.kind);
}

Element GuiState::finding(Session& session, const ProblemRow& row, std::size_t n) {
  know(session);
  if (row.quarantined) return quarantined_[static_cast<std::size_t>(row.kind)][n];
  if (row.kind != ProblemKind::boundary_loop) {
    const std::uint32_t i = session.highlights().of(row.kind).nth(static_cast<std::uint32_t>(n));
    return row.vertex ? Element(Vertex(i)) : row.edge ? Element(Edge(i)) : Element(Face(i));
  }
  if (known_loops_ != session.boundary_loops().revision()) {
    Neighbourhood around(session.mesh());
    const BoundaryLoops loops = find_boundary_loops(around, session.highlights().of(row.kind));
    loops_.clear();
    for (std::size_t i = 0; i < loops.size(); ++i) loops_.emplace_back(edge(loops[i].front()));
    known_loops_ = session.boundary_loops().revision();
  }
  return loops_[n];
}

Outcome PanelContext::keep(Outcome outcome) {
  state.last_kind = outcome.kind;
  state.last_outcome = outcome.sentence;
  if (outcome.done() && !outcome.performed.empty())
    state.last_outcome = {outcome.performed + ": " + ryosen::text(UiText::done, Language::english),
                          outcome.performed + "：" + ryosen::text(UiText::done, Language::japanese)};
  if (outcome.done() && !outcome.performed.empty() && !outcome.sentence.en.empty())
    state.last_outcome = {outcome.performed + ": " + outcome.sentence.en,
                          outcome.performed + "：" + outcome.sentence.ja};
  return outcome;
}

namespace {

// Lines that may take long, if they are right: others fail at once, where they were written.
bool is_long_work(const std::string& line) {
  const auto call = call_of(line);
  return call && call->row.is_long && !fault_of_command(line);
}

}  // namespace

Outcome PanelContext::run(const std::string& line) {
  if (state.is_laying_out && is_long_work(line)) {
    state.waiting.push_back(line);
    return {};
  }
  return keep(session.run(line));
}

Outcome PanelContext::click(glm::dvec2 pixel) { return keep(session.click(pixel, session.tool)); }

void PanelContext::leave(PendingLeave where) {
  if (session.document().is_modified()) {
    state.pending = std::move(where);
    state.last_outcome = {};
    session.open_panel = "unsaved";
    return;
  }
  go(where);
}

void PanelContext::go(const PendingLeave& where) {
  session.open_panel.clear();
  if (where.quits)
    state.wants_quit = true;
  else if (!where.command.empty())
    run(where.command);
  else
    run(where.opens.empty() ? "new" : "open " + file_argument(where.opens.string()));
}

}  // namespace ryosen
