// The 3i+j form of the source texts: triangles, and a map from each directed side to the number of the halfedge
// opposite.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <map>
#include <memory>

#include "ryosen/textbook/forms/walk.h"

namespace ryosen::forms {

// Counts the bytes allocated by a container.
template <class T>
struct CountingAllocator {
  using value_type = T;
  std::shared_ptr<std::size_t> bytes = std::make_shared<std::size_t>(0);

  CountingAllocator() = default;
  template <class Other>
  CountingAllocator(const CountingAllocator<Other>& other) : bytes(other.bytes) {}
  T* allocate(std::size_t n) {
    *bytes += n * sizeof(T);
    return std::allocator<T>().allocate(n);
  }
  void deallocate(T* at, std::size_t n) {
    *bytes -= n * sizeof(T);
    std::allocator<T>().deallocate(at, n);
  }
  template <class Other>
  bool operator==(const CountingAllocator<Other>& other) const {
    return bytes == other.bytes;
  }
};

// Halfedge 3i+j is side j of face i. The map stores for (from, to) the number of the opposite halfedge, at a boundary
// -(own number + 1). The text has no link from a vertex to its halfedges, so a vertex relation is a search through all
// faces: O(n). The handle of an edge is one of its halfedges.
class OppositeMap : public TriangleForm<OppositeMap> {
 public:
  explicit OppositeMap(const Mesh& mesh);
  OppositeMap(const OppositeMap&) = delete;
  OppositeMap& operator=(const OppositeMap&) = delete;

  std::size_t bytes() const override;
  Mesh to_mesh() const override;
  std::uint32_t find_edge(std::uint32_t a, std::uint32_t b) const override;
  bool answer(Relation relation, std::uint32_t element, Answer& out) const override;
  Fields record(Element own) const override;

  // The stored value for the side of a halfedge.
  std::int32_t coded_opposite(std::uint32_t h) const { return opposites_.find(key(h))->second; }
  std::size_t map_size() const { return opposites_.size(); }

  // The interface of split_3ij.h.
  std::uint32_t corner(std::uint32_t h) const { return faces_[h / 3][h % 3]; }
  std::uint32_t opposite(std::uint32_t h) const {
    const std::int32_t coded = coded_opposite(h);
    return coded < 0 ? no_index : static_cast<std::uint32_t>(coded);
  }
  const glm::dvec3& position(std::uint32_t v) const { return positions_[v]; }
  std::uint32_t face_count() const { return static_cast<std::uint32_t>(faces_.size()); }
  std::uint32_t add_vertex(const glm::dvec3& position);
  std::uint32_t add_face();
  void set_face(std::uint32_t f, const std::array<std::uint32_t, 3>& corners);
  void join(std::uint32_t h, std::uint32_t g);
  void set_boundary(std::uint32_t h) { opposites_[key(h)] = -(static_cast<std::int32_t>(h) + 1); }

  static std::uint32_t at_vertex(std::uint32_t) { return no_index; }  // of walk.h

 private:
  using Side = std::pair<std::uint32_t, std::uint32_t>;
  using Opposites = std::map<Side, std::int32_t, std::less<>, CountingAllocator<std::pair<const Side, std::int32_t>>>;

  Side key(std::uint32_t h) const { return {corner(h), corner(next(h))}; }

  std::vector<glm::dvec3> positions_;
  std::vector<std::array<std::uint32_t, 3>> faces_;
  Opposites opposites_;
};

}  // namespace ryosen::forms
