// Ranges over all vertices, edges, faces or halfedges of a mesh that have not been deleted.
#pragma once

#include <cstddef>
#include <iterator>

#include "ryosen/mesh/mesh.h"

namespace ryosen {

// The live elements of one kind in ascending order of slots, from a first slot on. The mesh may be edited during the
// walk, as in a loop over slot numbers: an element that has been deleted before its turn is left out, and an element
// that has been added is reached, since the end is where the slots end by then. Costs one look at each slot.
template <class Handle>
class LiveElements {
 public:
  class iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = Handle;
    using difference_type = std::ptrdiff_t;
    using pointer = void;
    using reference = Handle;

    iterator(const Mesh* mesh, Handle first) : mesh_(mesh), current_(first) { skip_dead(); }
    Handle operator*() const { return current_; }
    iterator& operator++() {
      ++current_.index;
      skip_dead();
      return *this;
    }
    friend bool operator==(const iterator& a, std::default_sentinel_t) { return !a.mesh_->exists(a.current_); }

   private:
    void skip_dead() {
      while (mesh_->exists(current_) && !mesh_->is_alive(current_)) ++current_.index;
    }

    const Mesh* mesh_;
    Handle current_;
  };

  explicit LiveElements(const Mesh& mesh, Handle first = Handle(0)) : mesh_(&mesh), first_(first) {}
  iterator begin() const { return {mesh_, first_}; }
  std::default_sentinel_t end() const { return {}; }

 private:
  const Mesh* mesh_;
  Handle first_;
};

inline auto live_vertices(const Mesh& m, Vertex first = Vertex(0)) { return LiveElements(m, first); }
inline auto live_edges(const Mesh& m, Edge first = Edge(0)) { return LiveElements(m, first); }
inline auto live_faces(const Mesh& m, Face first = Face(0)) { return LiveElements(m, first); }
inline auto live_halfedges(const Mesh& m, Halfedge first = Halfedge(0)) { return LiveElements(m, first); }

}  // namespace ryosen
