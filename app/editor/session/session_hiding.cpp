// What a session hides, and who is told.
#include <algorithm>

#include "app/editor/session/session.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"

namespace ryosen {

namespace {

// What changes its looks with these parts: they, and what is at their corners.
TouchedElements looks_touched(const Mesh& mesh, const HiddenElements::Parts& parts) {
  TouchedElements touched;
  touched.faces = parts.faces;
  const auto add = [&](Vertex v) { for_each_copy(mesh, v, [&](Vertex copy) { touched.moved.push_back(copy); }); };
  for (const Face f : parts.faces)
    for (const Vertex v : vertices_around(mesh, f)) add(v);
  for (const Edge e : parts.wires) {
    add(ends(mesh, e).first);
    add(ends(mesh, e).second);
  }
  for (const Vertex v : parts.isolated) add(v);
  sort_unique(touched.moved);
  touched.vertices = touched.moved;
  return touched;
}

}  // namespace

// The preparation reads what is hidden, so that it ends first.
void Session::hide(std::span<const Element> elements) {
  preparation_.reset();
  follow_hiding(hidden_.hide(mesh(), elements));
}

void Session::isolate(std::span<const Element> elements) {
  preparation_.reset();
  follow_hiding(hidden_.isolate(mesh(), elements));
}

void Session::unhide() {
  preparation_.reset();
  follow_hiding(hidden_.show_all());
}

void Session::drop_hidden(Elements& elements) const {
  if (!hidden_.empty()) std::erase_if(elements, [&](const Element& e) { return hidden_.hides(mesh(), e); });
}

void Session::follow_hiding(const HiddenElements::Parts& changed) {
  if (changed.empty()) return;
  const Mesh& m = mesh();
  changes_.note_hiding();
  if (picker_) {
    picker_->update_hidden(m, changed);
    constexpr std::size_t few = 10000;  // more are found in one pass over all triangles
    for (const Face f : changed.faces) {
      changes_.note_face(f.index);
      if (changed.faces.size() > few) continue;
      picker_->note_changed(picker_->triangles().slots_of(m, f));
    }
  }
  if (highlights_) note_marks(looks_touched(m, changed));
  drop_hidden(selection.changed());
  if (!hover_) return;
  if (is_verdict_held_ && hidden_.hides(m, hover_->picked.element)) release_verdict();
  point_at(hover_->pixel, hover_->modifiers);
}

}  // namespace ryosen
