// Whether an edit says of each element that it creates what its values come from, and of each that it removes what
// becomes of them. Only test builds look; elsewhere nothing is kept.
#pragma once

#include <cstdint>
#ifdef RYOSEN_PROVENANCE
#include <array>
#include <optional>
#include <string>
#include <unordered_set>
#include <utility>
#endif

#include "ryosen/mesh/columns.h"

namespace ryosen {

class Mesh;

// A halfedge is a corner while it has a face.
#ifdef RYOSEN_PROVENANCE
class Provenance {
 public:
  void creates(ElementKind kind, std::uint32_t index) { add(created_, kind, index); }
  void removes(ElementKind kind, std::uint32_t index) { add(removed_, kind, index); }
  // That its values are derived, or the defaults.
  void tells(ElementKind kind, std::uint32_t index) { add(told_, kind, index); }
  // That its values go to an element that it is united with, or with it.
  void ends(ElementKind kind, std::uint32_t index) { add(ended_, kind, index); }
  // All elements were replaced: the sentence that Descent::untold() has of that.
  void replaces(std::optional<std::string> untold) { replacement_ = std::move(untold); }
  // A sentence on an element of which nothing was said.
  std::optional<std::string> untold(const Mesh& mesh) const;

 private:
  using Indices = std::array<std::unordered_set<std::uint32_t>, 4>;
  static void add(Indices& indices, ElementKind kind, std::uint32_t index) {
    indices[static_cast<std::size_t>(kind)].insert(index);
  }

  Indices created_, removed_, told_, ended_;
  std::optional<std::string> replacement_;
};
#else
class Provenance {
 public:
  static constexpr void creates(ElementKind, std::uint32_t) {}
  static constexpr void removes(ElementKind, std::uint32_t) {}
  static constexpr void tells(ElementKind, std::uint32_t) {}
  static constexpr void ends(ElementKind, std::uint32_t) {}
};
#endif

}  // namespace ryosen
