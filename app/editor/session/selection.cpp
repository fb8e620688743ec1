#include "app/editor/session/selection.h"

#include <atomic>

#include "ryosen/mesh/find_element.h"

namespace ryosen {

Elements& Selection::changed() {
  stamp_ = next_stamp();
  return elements_;
}

std::size_t Selection::count(Element::Kind kind) const {
  if (counted_ != stamp_) {
    counts_ = {};
    for (const Element& e : elements_) ++counts_[static_cast<std::size_t>(e.kind)];
    counted_ = stamp_;
  }
  return counts_[static_cast<std::size_t>(kind)];
}

std::uint64_t Selection::next_stamp() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

void drop_lost(Elements& elements, const Mesh& mesh, bool is_renumbered) {
  std::erase_if(elements, [&](const Element& e) {
    const bool keeps_number = e.kind == Element::Kind::face || (e.kind == Element::Kind::vertex && !mesh.has_copies());
    return (is_renumbered && !keeps_number) || !is_alive(mesh, e);
  });
}

SelectionMemory::Shared SelectionMemory::shared(const Elements& selection) {
  if (!last_ || *last_ != selection) last_ = std::make_shared<const Elements>(selection);
  return last_;
}

namespace {

void pass_on(Elements& elements, const Mesh& mesh, const SelectionMemory::Passage& passage) {
  if (passage.descent)
    elements = descended(mesh, *passage.descent, elements);
  else if (passage.lineage == Lineage::numbers)
    drop_lost(elements, mesh, true);
  else
    elements.clear();
}

}  // namespace

void SelectionMemory::made(std::size_t entry, Elements& selection, const Mesh& mesh,
                           const std::optional<Passage>& passage, const ColumnLengths& before) {
  around_.resize(entry);  // one that was not noted, for want of memory, remembers nothing
  Around& around = around_.emplace_back();
  around.before = shared(selection);
  for (auto& [name, elements] : kept) std::erase_if(elements, [&](const Element& e) { return !has_slot(before, e); });
  if (!passage) return drop_lost(selection, mesh, false);
  pass_on(selection, mesh, *passage);
  around.other_kept = kept;
  for (auto& [name, elements] : kept) pass_on(elements, mesh, *passage);
  std::erase_if(kept, [](const auto& set) { return set.second.empty(); });
}

void SelectionMemory::undone(std::size_t entry, Elements& selection, const Mesh& mesh, bool is_renumbered) {
  if (entry < around_.size() && around_[entry].before) {
    Around& around = around_[entry];
    around.after = shared(selection);
    selection = *around.before;
    if (is_renumbered) kept.swap(around.other_kept);
  }
  drop_lost(selection, mesh, false);
}

void SelectionMemory::redone(std::size_t entry, Elements& selection, const Mesh& mesh, bool is_renumbered) {
  if (entry < around_.size() && around_[entry].after) {
    Around& around = around_[entry];
    selection = *around.after;
    if (is_renumbered) kept.swap(around.other_kept);
  }
  drop_lost(selection, mesh, false);
}

std::vector<Element> FirstSlots::added_to(const Mesh& mesh) const {
  std::vector<Element> added;
  for (Face f(faces_); f.index < mesh.face_slots(); ++f.index)
    if (mesh.is_alive(f)) added.push_back(f);
  for (Edge e(edges_); e.index < mesh.edge_slots(); ++e.index)
    if (mesh.is_alive(e) && mesh.is_wire(e)) added.push_back(e);
  for (Vertex v(vertices_); v.index < mesh.vertex_slots(); ++v.index)
    if (mesh.is_alive(v) && mesh.is_isolated(v)) added.push_back(v);
  return added;
}

}  // namespace ryosen
