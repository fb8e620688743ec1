// Typed element handles: four bytes each, one type per kind of element, so comparing a vertex with a face does not
// compile.
#pragma once

#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace ryosen {

inline constexpr std::uint32_t no_index = 0xffffffffu;

// A slot number in the columns of a mesh, or none. Kind is a tag type; handles of different kinds do not convert. A
// handle stays valid while its element lives; slots are never reused, so a stale handle names a dead element.
template <class Kind>
struct Handle {
  std::uint32_t index = no_index;

  constexpr Handle() = default;
  template <std::integral Number>
  constexpr explicit Handle(Number slot) : index(static_cast<std::uint32_t>(slot)) {}

  constexpr bool is_none() const { return index == no_index; }
  constexpr explicit operator bool() const { return index != no_index; }
  friend constexpr auto operator<=>(Handle, Handle) = default;
};

using Vertex = Handle<struct VertexKind>;
using Halfedge = Handle<struct HalfedgeKind>;
using Edge = Handle<struct EdgeKind>;
using Face = Handle<struct FaceKind>;

// Twins occupy adjacent slots, so twin and edge are computed, not stored.
constexpr Halfedge twin(Halfedge h) { return Halfedge(h.index ^ 1u); }
constexpr Edge edge(Halfedge h) { return Edge(h.index >> 1u); }
// The even (side 0) or odd (side 1) halfedge of an edge.
constexpr Halfedge halfedge(Edge e, unsigned side = 0) { return Halfedge((e.index << 1u) | side); }

}  // namespace ryosen

template <class Kind>
struct std::hash<ryosen::Handle<Kind>> {
  std::size_t operator()(ryosen::Handle<Kind> h) const noexcept { return std::hash<std::uint32_t>()(h.index); }
};
