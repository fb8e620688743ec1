// Any element of a mesh, tagged with its kind; used by verdicts, problems and selections.
#pragma once

#include <cstdint>
#include <vector>

#include "ryosen/base/handle.h"

namespace ryosen {

struct Element {
  enum class Kind : std::uint8_t { vertex, halfedge, edge, face };
  Kind kind = Kind::vertex;
  std::uint32_t index = no_index;

  constexpr Element() = default;
  // No element, of a kind.
  constexpr explicit Element(Kind none_of) : kind(none_of) {}
  constexpr Element(Vertex v) : kind(Kind::vertex), index(v.index) {}
  constexpr Element(Halfedge h) : kind(Kind::halfedge), index(h.index) {}
  constexpr Element(Edge e) : kind(Kind::edge), index(e.index) {}
  constexpr Element(Face f) : kind(Kind::face), index(f.index) {}

  // The typed handle; the kind must match.
  constexpr Vertex vertex() const { return Vertex(index); }
  constexpr Halfedge halfedge() const { return Halfedge(index); }
  constexpr Edge edge() const { return Edge(index); }
  constexpr Face face() const { return Face(index); }
  // Calls visit(handle) with the typed handle, and returns what it does.
  template <class Visit>
  constexpr decltype(auto) visit(Visit&& visit) const {
    switch (kind) {
      case Kind::vertex:
        return visit(vertex());
      case Kind::halfedge:
        return visit(halfedge());
      case Kind::edge:
        return visit(edge());
      default:
        return visit(face());
    }
  }

  friend constexpr auto operator<=>(const Element&, const Element&) = default;
};

using Elements = std::vector<Element>;

}  // namespace ryosen
