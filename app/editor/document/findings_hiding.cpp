// What is hidden of a mesh, and what its problems are about.
#include <algorithm>

#include "app/editor/document/findings.h"
#include "ryosen/base/count_text.h"
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
bool Findings::hide(std::span<const Element> elements) {
  preparation_.reset();
  return note_hiding(hidden_.hide(mesh(), elements));
}

bool Findings::isolate(std::span<const Element> elements) {
  preparation_.reset();
  return note_hiding(hidden_.isolate(mesh(), elements));
}

bool Findings::unhide() {
  preparation_.reset();
  return note_hiding(hidden_.show_all());
}

void Findings::drop_hidden(Elements& elements) const {
  if (!hidden_.empty()) std::erase_if(elements, [&](const Element& e) { return hidden_.hides(mesh(), e); });
}

bool Findings::note_hiding(const HiddenElements::Parts& changed) {
  if (changed.empty()) return false;
  changes_.note_hiding();
  for (const Face f : changed.faces) changes_.note_face(f.index);
  if (picker_) {
    picker_->update_hidden(mesh(), changed);
    constexpr std::size_t few = 10000;  // more are found in one pass over all triangles
    for (const Face f : changed.faces)
      if (changed.faces.size() <= few) picker_->note_changed(picker_->triangles().slots_of(mesh(), f));
  }
  if (highlights_) note_marks(looks_touched(mesh(), changed));
  return true;
}

std::vector<Element> Findings::about(const ProblemRow& row, Element element) {
  if (row.is_on_request() && has_searched(row.kind)) {
    std::vector<Element> found{element};
    for (const auto& [a, b] : searched_->pairs)
      if (Element(a) == element || Element(b) == element) found.emplace_back(Element(a) == element ? b : a);
    return found;
  }
  if (!row.is_local()) return {element};
  const IndexSet& members = highlights().of(row.kind);
  // Of what is several in the kernel one is a member.
  std::vector<Element> same{element};
  if (element.kind == Element::Kind::vertex) same = {point(mesh(), element.vertex())};
  if (element.kind == Element::Kind::edge)
    for (Halfedge h : sheets_between(mesh(), ends(mesh(), element.edge()).first, ends(mesh(), element.edge()).second))
      same.emplace_back(edge(h));
  for (const Element& e : same) {
    if (e.kind != row.sort() || !members.contains(e.index)) continue;
    Neighbourhood around(mesh());
    return ryosen::about(row, around, members, e);
  }
  return {element};
}

Text hidden_text(const HiddenElements& hidden) {
  if (hidden.empty()) return {"nothing is hidden", "非表示の要素はありません"};
  if (const auto faces = hidden.faces().size())
    return count_text(faces, "one face is hidden", "# faces are hidden", "# 面を非表示にしています");
  return count_text(hidden.wires().size() + hidden.isolated().size(), "one element is hidden", "# elements are hidden",
                    "# 個の要素を非表示にしています");
}

}  // namespace ryosen
