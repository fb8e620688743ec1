// Points of a mesh that lie on others, kept current through edits.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ryosen/analysis/neighbourhood.h"

namespace ryosen {

// Coordinates are equal as numbers: 0 is -0, and what is not finite equals nothing. Copies of one point are no others.
class CoincidentPoints {
 public:
  CoincidentPoints() = default;
  // O(vertices) expected.
  explicit CoincidentPoints(const Mesh& mesh);
  bool knows_places() const { return !buckets_.empty(); }

  // Follows the mesh after the places, copies or lives of these vertices have changed, and forgets slots past the end.
  // Returns the vertices whose answer may be another now. O(their number) expected, however many points share a place.
  std::vector<Vertex> update(const Mesh& mesh, std::span<const Vertex> changed);

  // Whether another point is where this vertex is; false of all but the lowest copy of a point. O(1).
  bool is_on_another(Vertex v) const {
    return v.index < rings_.size() && rings_[v.index].next != no_index && rings_[v.index].next != v.index;
  }
  // Visits the points at the place of one that is on another, itself first. Cost: their number.
  template <class Visit>
  void for_each_at(Vertex v, Visit visit) const {
    std::uint32_t i = v.index;
    do visit(Vertex(i));
    while ((i = rings_[i].next) != v.index);
  }

 private:
  // The points of one place form a ring; a vertex that takes no part is in none.
  struct Ring {
    std::uint32_t next = no_index, prev = no_index;
  };
  // One of them, the first, is in the chain of a bucket.
  static constexpr std::uint32_t not_first = no_index - 1;
  struct Place {
    std::uint32_t hash = 0, chain = not_first;  // the next first point of the bucket
  };

  std::uint32_t& bucket_of(std::uint32_t hash) { return buckets_[hash & (buckets_.size() - 1)]; }
  void insert(const Mesh& mesh, Vertex v);
  void erase(Vertex v);
  void replace_first(std::uint32_t i, std::uint32_t other);
  void grow();

  std::vector<std::uint32_t> buckets_;  // the first of a chain; their number is a power of two
  std::vector<Place> places_;           // by vertex
  std::vector<Ring> rings_;             // by vertex
  std::size_t count_ = 0;               // of places
};

// All of them, ascending (ProblemRow::find_all). O(vertices) expected.
std::vector<std::uint32_t> find_coincident_points(Neighbourhood& around);

}  // namespace ryosen
