// A dynamic bounding volume hierarchy over triangles, segments and points: ray casting, frustum queries and nearest
// points, with incremental insertion, update and removal.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "ryosen/base/index_set.h"
#include "ryosen/base/progress.h"
#include "ryosen/geometry/frustum.h"
#include "ryosen/geometry/ray.h"
#include "ryosen/geometry/trees/float_box.h"
#include "ryosen/geometry/trees/primitive.h"

namespace ryosen {

struct RayHit {
  std::uint32_t slot = no_index;
  double t = 0.0;
  glm::dvec3 barycentric{0.0};  // weights of the triangle's vertices
};

struct NearestHit {
  std::uint32_t slot = no_index;
  double distance = 0.0;
  glm::dvec3 place{0.0};
  glm::dvec3 barycentric{0.0};  // weights of the primitive's vertices
};

// Refers to a function of a slot, and is gone before it.
class SlotVisitor {
 public:
  template <class Visit>
  SlotVisitor(const Visit& visit)
      : function_(&visit),
        call_([](const void* function, std::uint32_t slot) { (*static_cast<const Visit*>(function))(slot); }) {}
  void operator()(std::uint32_t slot) const { call_(function_, slot); }

 private:
  const void* function_;
  void (*call_)(const void*, std::uint32_t);
};

// Primitives have slots, stable numbers chosen by the caller. The tree stores vertex numbers, not positions: pass the
// same column of positions to every call; the caller owns it and may let it grow.
//
// Results do not depend on the tree's shape, hence not on the order of edits. Boxes are rounded outwards, so no hit is
// missed. A primitive with a non-finite position keeps its slot but is found by no query. Cost: build O(n log n) by
// binned surface area heuristic [Wald07]; queries and single changes typically O(depth). Local rotations maintain the
// tree's quality [Kopta12]; after many changes, rebuild.
class Bvh {
 public:
  // Replaces the contents: primitive i goes to slot i; empty primitives leave their slot empty.
  void build(std::span<const glm::dvec3> positions, std::vector<Primitive> primitives);
  // The same, told by the share of the primitives that have their place. Cancelled: false, and the tree is empty.
  bool build(std::span<const glm::dvec3> positions, std::vector<Primitive> primitives, Progress& progress);
  // Rebuilds from the current primitives; worthwhile when is_worn(): after changes to a third of them, of which one
  // that only moves counts by how far it leads out of its box.
  void rebuild(std::span<const glm::dvec3> positions);
  bool is_worn() const { return changes_ > 64 && changes_ > static_cast<double>(live_) / 3; }

  // Puts a primitive into a slot, free or occupied; memory grows with the largest slot number.
  void insert(std::span<const glm::dvec3> positions, std::uint32_t slot, const Primitive& primitive);
  // Empties a slot; no effect if it is empty.
  void erase(std::uint32_t slot);
  // Refits after the positions of the slot's vertices changed.
  void update(std::span<const glm::dvec3> positions, std::uint32_t slot);

  // The first triangle hit by the ray, from either side; at equal t the smallest slot. Segments and points are never
  // hit, nor are triangles of the owners that are passed over.
  std::optional<RayHit> cast(std::span<const glm::dvec3> positions, const Ray& ray,
                             const IndexSet* passed_over = nullptr) const;

  // Calls visit(slot) for all primitives whose box meets the frustum, in no particular order. Conservative: boxes near
  // an edge of the frustum may be visited although they miss it.
  void visit_frustum(std::span<const glm::dvec3> positions, const Frustum& frustum, SlotVisitor visit) const;
  // The same of a box, and faster.
  void visit_box(std::span<const glm::dvec3> positions, const Box& box, SlotVisitor visit) const;

  // The nearest point on any primitive, at most max_distance away; on a tie the smallest slot.
  std::optional<NearestHit> nearest(std::span<const glm::dvec3> positions, const glm::dvec3& point,
                                    double max_distance) const;

  // The primitive in a slot; an empty one for an empty slot.
  Primitive primitive(std::uint32_t slot) const { return slot < primitives_.size() ? primitives_[slot] : Primitive{}; }
  std::size_t size() const { return live_; }  // primitives in the tree
  std::size_t bytes() const;

 private:
  static constexpr std::uint32_t leaf_capacity = 4;
  friend class BvhBuilder;
  friend struct BvhInspector;  // of the tests

  // Boxes are floats in the tree's frame, (p - origin_) * scale_, of magnitude about 1.
  struct alignas(16) Node {
    std::array<float, 3> lowest;
    std::uint32_t first;  // inner node: the left child, the right one follows; leaf: block of slots
    std::array<float, 3> highest;
    std::uint32_t count;  // primitives in a leaf, 0 for an inner node

    // The three bounds; the last lane holds whatever follows in memory.
    Float4 lower_lanes() const { return Float4::load(lowest.data()); }
    Float4 upper_lanes() const { return Float4::load(highest.data()); }
  };
  struct alignas(64) NodePair {
    std::array<Node, 2> side;
  };
  struct LocalRay;
  using SlotBlock = std::array<std::uint32_t, leaf_capacity>;

  // Node 0 is the root; node 1 is never used.
  Node& node(std::uint32_t i) { return pairs_[i >> 1u].side[i & 1u]; }
  const Node& node(std::uint32_t i) const { return pairs_[i >> 1u].side[i & 1u]; }
  std::uint32_t parent(std::uint32_t i) const { return parents_[i >> 1u]; }
  FloatBox box(std::uint32_t i) const;
  void set_box(std::uint32_t i, const FloatBox& box);

  FloatBox local_box(const Box& box) const;
  static bool is_finite(std::span<const glm::dvec3> positions, const Primitive& primitive);
  bool rebuild(std::span<const glm::dvec3> positions, Progress& progress);
  void choose_frame(std::span<const glm::dvec3> positions);

  void link_slot(std::span<const glm::dvec3> positions, std::uint32_t slot);
  void unlink_slot(std::uint32_t slot);
  std::uint32_t best_sibling(const FloatBox& box) const;
  void add_to_leaf(std::uint32_t leaf, std::uint32_t slot);
  void split_off(std::uint32_t at, std::uint32_t slot, const FloatBox& box);
  void move_node(std::uint32_t from, std::uint32_t to);
  void adopt(std::uint32_t i);
  void rotate(std::uint32_t i);
  void exchange(std::uint32_t a, std::uint32_t b);
  FloatBox leaf_box(std::span<const glm::dvec3> positions, const Node& leaf) const;
  void refit_upwards(std::uint32_t i, bool with_rotations);
  std::uint32_t new_pair();
  std::uint32_t new_block();

  void cast_leaf(std::span<const glm::dvec3> positions, const RayCaster& caster, const Node& leaf,
                 const IndexSet* passed_over, RayHit& best) const;
  template <class Meets, class Visit>
  void visit_where(const Meets& meets, const Visit& visit) const;

  std::vector<Primitive> primitives_;   // by slot
  std::vector<std::uint32_t> leaf_of_;  // by slot: its leaf, or no_index
  std::vector<NodePair> pairs_;
  std::vector<std::uint32_t> parents_;  // by pair of siblings: their parent
  std::vector<SlotBlock> blocks_;
  std::vector<std::uint32_t> free_pairs_, free_blocks_;
  glm::dvec3 origin_{0.0};
  double scale_ = 1.0;
  double reach_ = 0.0;  // largest magnitude in any box so far, in the tree's frame
  std::size_t live_ = 0;
  double changes_ = 0;
};

}  // namespace ryosen
