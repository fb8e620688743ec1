#include "app/editor/session/selection_memory.h"

#include "ryosen/mesh/find_element.h"

namespace ryosen {

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

}  // namespace ryosen
