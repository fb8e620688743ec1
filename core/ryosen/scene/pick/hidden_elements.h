// What of a mesh is hidden: neither drawn nor picked, nor in the way of what lies behind.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ryosen/base/element.h"
#include "ryosen/base/index_set.h"
#include "ryosen/mesh/journal.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// Hidden by themselves are faces, edges without faces (wires), and isolated vertices. Any other edge or vertex is
// hidden while all of these at it are, over all copies of a point.
class HiddenElements {
 public:
  struct Parts {
    std::vector<Face> faces;
    std::vector<Edge> wires;
    std::vector<Vertex> isolated;

    bool empty() const { return faces.empty() && wires.empty() && isolated.empty(); }
  };

  // All return what has changed. Hides what is at the elements: a vertex or an edge takes the faces at it along.
  Parts hide(const Mesh& mesh, std::span<const Element> elements);
  // Hides all else, and shows what is at the elements. O(mesh).
  Parts isolate(const Mesh& mesh, std::span<const Element> elements);
  Parts show_all();
  // After an edit: what is deleted, or of another sort now, is hidden no more. Where columns were replaced, nothing is.
  void follow(const Mesh& mesh, const TouchedElements& touched);

  // Another number after each change, unique among those of this process; 0 as long as there was none.
  std::uint64_t revision() const { return revision_; }

  // By themselves.
  std::vector<Element> elements() const;
  bool empty() const { return faces_.empty() && wires_.empty() && isolated_.empty(); }
  const IndexSet& faces() const { return faces_; }
  const IndexSet& wires() const { return wires_; }
  const IndexSet& isolated() const { return isolated_; }

  // Live elements.
  bool hides(const Mesh& mesh, Vertex v) const;
  bool hides(const Mesh& mesh, Edge e) const;
  bool hides(const Mesh& mesh, Halfedge h) const { return hides(mesh, edge(h)); }
  bool hides(const Mesh&, Face f) const { return faces_.contains(f.index); }
  bool hides(const Mesh& mesh, const Element& e) const {
    return e.visit([&](auto handle) { return hides(mesh, handle); });
  }

 private:
  Parts noted(Parts changed);
  bool hides_sheet(const Mesh& mesh, Edge e) const;
  bool hides_copy(const Mesh& mesh, Vertex v) const;

  IndexSet faces_, wires_, isolated_;
  std::uint64_t revision_ = 0;
};

}  // namespace ryosen
