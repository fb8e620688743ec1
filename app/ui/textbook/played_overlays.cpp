// What the step that is played and the question of practice are about.
#include <algorithm>

#include "app/editor/session/session.h"
#include "app/editor/textbook/playing.h"
#include "app/ui/overlay_painter.h"
#include "app/ui/overlays.h"
#include "ryosen/mesh/find_element.h"

namespace ryosen {

namespace {

Style style(steps::RoleLook look, Theme theme) {
  if (look == steps::RoleLook::main) return style(Role::selected, theme);
  if (look == steps::RoleLook::good) return style(Role::legal, theme);
  if (look == steps::RoleLook::bad) return style(Role::refused, theme);
  if (look == steps::RoleLook::other) return style(Role::hover, theme);
  return style(Role::witness, theme);
}

// A halfedge on its own side of the edge, so that it is told from its twin.
void draw_beside_twin(Painter& painter, const Mesh& mesh, const ViewState& view, const Gesturing& gesturing,
                      const Element& element) {
  if (element.kind != Element::Kind::halfedge) return painter.draw(element);
  for (const LinkArrow& arrow : arrows_of(mesh, view, gesturing.drawn_positions(), {element.halfedge()}))
    painter.line(arrow.from, arrow.to, true);
}

}  // namespace

Overlay question_overlay(const Session& session, Theme theme) {
  Overlay overlay;
  const std::optional<Element> about = asked_element(session.document(), session.layout, session.asked_question);
  if (!about) return overlay;
  Painter painter(session.mesh(), session.gesturing.drawn_positions(), overlay, style(Role::witness, theme), 0.6f);
  draw_beside_twin(painter, session.mesh(), session.view, session.gesturing, *about);
  return overlay;
}

Overlay step_overlay(const Mesh& mesh, const ViewState& view, const Gesturing& gesturing, const Shown& shown,
                     Theme theme) {
  Overlay overlay;
  const std::shared_ptr<const StepsPlayer> player = steps_player(shown);
  if (!shown.shows(ShownBy::step) || !player || !player->step()) return overlay;
  // The first mark of an element is what it is above all: it is drawn last.
  const std::vector<steps::Mark>& marks = player->step()->marks;
  for (auto mark = marks.rbegin(); mark != marks.rend(); ++mark) {
    if (!has_slot(mesh.lengths(), mark->element) || !is_alive(mesh, mark->element)) continue;
    Painter painter(mesh, gesturing.drawn_positions(), overlay, style(steps::row_of(mark->role).look, theme), 0.6f);
    draw_beside_twin(painter, mesh, view, gesturing, mark->element);
  }
  for (const steps::Gone& gone : player->step()->gone) {
    const Style looks = style(steps::row_of(gone.role).look, theme);
    for (std::size_t i = 1; i < gone.places.size(); ++i)
      overlay.lines.push_back({gone.places[i - 1], gone.places[i], looks.colour, LineStyle::dashed, 1.5f});
  }
  return overlay;
}

}  // namespace ryosen
