// A set of elements of all kinds.
#pragma once

#include <array>
#include <span>

#include "ryosen/base/element.h"
#include "ryosen/base/index_set.h"

namespace ryosen {

// Costs of IndexSet: memory for the slots up to the highest member, a bit each.
class ElementSet {
 public:
  ElementSet() = default;
  explicit ElementSet(std::span<const Element> elements) {
    for (const Element& e : elements) insert(e);
  }

  // Both return whether the set changed.
  bool insert(Element e) { return of(e.kind).insert(e.index); }
  bool erase(Element e) { return of(e.kind).erase(e.index); }
  bool contains(Element e) const { return sets_[static_cast<std::size_t>(e.kind)].contains(e.index); }

 private:
  IndexSet& of(Element::Kind kind) { return sets_[static_cast<std::size_t>(kind)]; }

  std::array<IndexSet, 4> sets_;
};

}  // namespace ryosen
