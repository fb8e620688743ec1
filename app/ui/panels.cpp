#include "app/ui/panels.h"

#include <array>

#include "app/editor/words.h"
#include "app/ui/panels/all.h"
#include "core/mesh/copies.h"

namespace ryosen {

namespace {

constexpr std::array list{
    Panel{UiText::tools, Side::left, draw_tools},          Panel{UiText::highlights, Side::left, draw_highlights},
    Panel{UiText::totals, Side::left, draw_totals},        Panel{UiText::pointer, Side::right, draw_verdict},
    Panel{UiText::inspector, Side::right, draw_inspector}, Panel{UiText::problems, Side::right, draw_problems},
    Panel{UiText::history, Side::right, draw_history},
};

}  // namespace

std::span<const Panel> panels() { return list; }

void GuiState::follow(Session& session) {
  const Document& document = session.document();
  if (known_document == document.serial() && known_revision == document.revision()) return;
  const Mesh& mesh = session.mesh();
  problems = find_problems(mesh, session.highlights(), {document.tables().quarantine, document.tables().face_lines});
  on_points.reset();
  if (mesh.has_copies()) {
    const ElementCounts counts = counts_on_points(mesh);
    if (counts.vertices != mesh.live().vertices || counts.edges != mesh.live().edges) on_points = counts;
  }
  known_document = document.serial();
  known_revision = document.revision();
}

Outcome PanelContext::keep(Outcome outcome) {
  state.follow(session);  // what is drawn after this in the same frame must speak of elements that still exist
  state.last_kind = outcome.kind;
  state.last_outcome = outcome.sentence;
  if (outcome.done() && !outcome.performed.empty())
    state.last_outcome = {outcome.performed + ": " + ryosen::text(UiText::done, Language::english),
                          outcome.performed + "：" + ryosen::text(UiText::done, Language::japanese)};
  return outcome;
}

Outcome PanelContext::run(const std::string& line) { return keep(session.run(line)); }

Outcome PanelContext::click(glm::dvec2 pixel) { return keep(session.click(pixel, session.tool)); }

void PanelContext::leave(PendingLeave where) {
  if (session.document().is_modified()) {
    state.pending = std::move(where);
    state.last_outcome = {};
    session.open_panel = "unsaved";
    return;
  }
  session.open_panel.clear();
  if (where.quits)
    state.wants_quit = true;
  else
    run("open " + file_argument(where.opens.string()));
}

}  // namespace ryosen
