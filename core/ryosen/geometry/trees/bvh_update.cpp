#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "ryosen/geometry/trees/bvh.h"
#include "ryosen/geometry/trees/small_stack.h"

namespace ryosen {
namespace {

// Coordinates beyond this, in the tree's frame, require a rebuild with a new frame: areas would overflow floats.
constexpr float largest_local = 1e15f;

// If a leaf's box grows by more than this factor when a vertex moves, the primitive is reinserted elsewhere.
constexpr float most_growth = 4.0f;

// By how much two boxes together are larger than one, as a share of it, at most 1.
float share_beside(const FloatBox& box, const FloatBox& other) {
  const float area = half_area(box), beside = half_area(united(box, other)) - area;
  return beside < area ? beside / area : 1.0f;
}

}  // namespace

void Bvh::insert(std::span<const glm::dvec3> positions, std::uint32_t slot, const Primitive& primitive) {
  if (primitive.size() == 0) return erase(slot);
  if (primitives_.size() <= slot) {
    primitives_.resize(slot + 1);
    leaf_of_.resize(slot + 1, no_index);
  }
  primitives_[slot] = primitive;
  update(positions, slot);  // what takes the place of another mostly lies there
}

void Bvh::erase(std::uint32_t slot) {
  if (slot >= primitives_.size()) return;
  if (leaf_of_[slot] != no_index) unlink_slot(slot);
  primitives_[slot] = Primitive{};
}

void Bvh::update(std::span<const glm::dvec3> positions, std::uint32_t slot) {
  if (slot >= primitives_.size() || primitives_[slot].size() == 0) return;
  const std::uint32_t leaf = leaf_of_[slot];
  if (!is_finite(positions, primitives_[slot])) {
    if (leaf != no_index) unlink_slot(slot);
    return;
  }
  if (leaf == no_index) return link_slot(positions, slot);
  const FloatBox old_box = box(leaf);
  const FloatBox new_box = leaf_box(positions, node(leaf));
  if (!(largest_magnitude(new_box) < largest_local) || half_area(new_box) > most_growth * half_area(old_box)) {
    unlink_slot(slot);
    return link_slot(positions, slot);
  }
  changes_ += is_same(old_box, new_box) ? 0.0 : static_cast<double>(share_beside(old_box, new_box));
  reach_ = std::max(reach_, static_cast<double>(largest_magnitude(new_box)));
  set_box(leaf, new_box);
  if (leaf != 0 && !is_same(old_box, new_box)) refit_upwards(parent(leaf), false);
}

bool Bvh::is_finite(std::span<const glm::dvec3> positions, const Primitive& primitive) {
  // Branchless: finite * 0 is 0, while infinities and NaN give NaN.
  double sum = 0.0;
  for (int i = 0; i < primitive.size(); ++i) {
    const glm::dvec3& p = positions[primitive.vertices[static_cast<std::size_t>(i)]];
    sum += p.x * 0.0 + p.y * 0.0 + p.z * 0.0;
  }
  return sum == 0.0;
}

FloatBox Bvh::local_box(const Box& box) const {
  const glm::dvec3 limit(1e37);
  return rounded_outwards(glm::clamp((box.lowest - origin_) * scale_, -limit, limit),
                          glm::clamp((box.highest - origin_) * scale_, -limit, limit));
}

FloatBox Bvh::leaf_box(std::span<const glm::dvec3> positions, const Node& leaf) const {
  Box result;
  for (std::uint32_t i = 0; i < leaf.count; ++i) {
    // A primitive whose position became non-finite is removed by its own update, which may still be pending.
    const Primitive& primitive = primitives_[blocks_[leaf.first][i]];
    if (!is_finite(positions, primitive)) continue;
    result.add(box_of(positions, primitive));
  }
  return local_box(result);
}

FloatBox Bvh::box(std::uint32_t i) const { return {node(i).lower_lanes(), node(i).upper_lanes()}; }

void Bvh::set_box(std::uint32_t i, const FloatBox& box) {
  const std::array<float, 4> lowest = floats_of(box.lowest);
  const std::array<float, 4> highest = floats_of(box.highest);
  std::copy_n(lowest.begin(), 3, node(i).lowest.begin());
  std::copy_n(highest.begin(), 3, node(i).highest.begin());
}

void Bvh::link_slot(std::span<const glm::dvec3> positions, std::uint32_t slot) {
  const FloatBox added = local_box(box_of(positions, primitives_[slot]));
  if (live_ == 0 || !(largest_magnitude(added) < largest_local)) return rebuild(positions);
  ++changes_;
  ++live_;
  reach_ = std::max(reach_, static_cast<double>(largest_magnitude(added)));
  const std::uint32_t at = best_sibling(added);
  const Node& sibling = node(at);
  const FloatBox both = united(box(at), added);
  // A leaf with free room takes the primitive if that costs no more than a separate leaf.
  const auto count = static_cast<float>(sibling.count);
  const bool joins = sibling.count != 0 && sibling.count < leaf_capacity &&
                     half_area(both) * count <= half_area(both) + half_area(box(at)) * count + half_area(added);
  if (joins) {
    add_to_leaf(at, slot);
    set_box(at, both);
  } else {
    split_off(at, slot, added);
  }
  if (at != 0) refit_upwards(parent(at), true);
}

void Bvh::unlink_slot(std::uint32_t slot) {
  ++changes_;
  --live_;
  const std::uint32_t leaf = leaf_of_[slot];
  leaf_of_[slot] = no_index;
  Node& here = node(leaf);
  SlotBlock& slots = blocks_[here.first];
  *std::find(slots.begin(), slots.begin() + here.count, slot) = slots[here.count - 1];
  --here.count;
  // Boxes of remaining primitives are not shrunk: they stay valid, and a rebuild tightens them.
  if (here.count != 0) return;
  free_blocks_.push_back(here.first);
  if (leaf == 0) {
    pairs_.clear();
    parents_.clear();
    return;
  }
  const std::uint32_t above = parent(leaf);
  const std::uint32_t pair = leaf & ~1u;
  move_node(leaf ^ 1u, above);
  free_pairs_.push_back(pair);
  if (above != 0) refit_upwards(parent(above), true);
}

// Descends to the node whose new sibling leaf adds the least surface area.
std::uint32_t Bvh::best_sibling(const FloatBox& added) const {
  std::uint32_t here = 0;
  while (node(here).count == 0) {
    const float area = half_area(box(here));
    const float grown = half_area(united(box(here), added));
    const float cost_here = 2.0f * grown;
    const float inherited = 2.0f * (grown - area);
    const auto cost_of = [&](std::uint32_t child) {
      const float with = half_area(united(box(child), added));
      return inherited + 2.0f * (node(child).count != 0 ? with : with - half_area(box(child)));
    };
    const float left = cost_of(node(here).first);
    const float right = cost_of(node(here).first + 1);
    if (cost_here < left && cost_here < right) break;
    here = node(here).first + (left <= right ? 0u : 1u);
  }
  return here;
}

void Bvh::add_to_leaf(std::uint32_t leaf, std::uint32_t slot) {
  Node& here = node(leaf);
  blocks_[here.first][here.count++] = slot;
  leaf_of_[slot] = leaf;
}

// Turns a node into an inner one: its content becomes the left child, a new leaf the right one.
void Bvh::split_off(std::uint32_t at, std::uint32_t slot, const FloatBox& added) {
  const std::uint32_t children = new_pair();
  const std::uint32_t block = new_block();
  move_node(at, children);
  parents_[children >> 1u] = at;
  node(children + 1).first = block;
  node(children + 1).count = 0;
  add_to_leaf(children + 1, slot);
  set_box(children + 1, added);
  node(at).first = children;
  node(at).count = 0;
  set_box(at, united(box(children), added));
}

void Bvh::move_node(std::uint32_t from, std::uint32_t to) {
  node(to) = node(from);
  adopt(to);
}

// Updates the back links from a node's children or slots.
void Bvh::adopt(std::uint32_t i) {
  const Node& here = node(i);
  if (here.count == 0) {
    parents_[here.first >> 1u] = i;
    return;
  }
  for (std::uint32_t k = 0; k < here.count; ++k) leaf_of_[blocks_[here.first][k]] = i;
}

void Bvh::exchange(std::uint32_t a, std::uint32_t b) {
  std::swap(node(a), node(b));
  adopt(a);
  adopt(b);
}

// Tree rotation: swaps a child with a grandchild on the other side if that shrinks the other child's box [Kopta12].
void Bvh::rotate(std::uint32_t i) {
  const std::uint32_t children = node(i).first;
  float best_gain = 0.0f;
  std::uint32_t best_child = no_index;
  std::uint32_t best_grandchild = no_index;
  for (std::uint32_t side = 0; side < 2; ++side) {
    const std::uint32_t child = children + side;
    const std::uint32_t other = children + 1 - side;
    if (node(other).count != 0) continue;
    const float area = half_area(box(other));
    for (std::uint32_t k = 0; k < 2; ++k) {
      const std::uint32_t stays = node(other).first + 1 - k;
      const float gain = area - half_area(united(box(child), box(stays)));
      if (gain > best_gain) {
        best_gain = gain;
        best_child = child;
        best_grandchild = node(other).first + k;
      }
    }
  }
  if (best_child == no_index) return;
  exchange(best_child, best_grandchild);
  const std::uint32_t changed = parent(best_grandchild);
  set_box(changed, united(box(node(changed).first), box(node(changed).first + 1)));
}

void Bvh::refit_upwards(std::uint32_t i, bool with_rotations) {
  for (;;) {
    if (with_rotations) rotate(i);
    const FloatBox fresh = united(box(node(i).first), box(node(i).first + 1));
    const bool same = is_same(box(i), fresh);
    set_box(i, fresh);
    if (i == 0 || (same && !with_rotations)) return;
    i = parent(i);
  }
}

std::uint32_t Bvh::new_pair() {
  if (!free_pairs_.empty()) {
    const std::uint32_t pair = free_pairs_.back();
    free_pairs_.pop_back();
    return pair;
  }
  pairs_.emplace_back();
  parents_.push_back(no_index);
  return static_cast<std::uint32_t>(2 * (pairs_.size() - 1));
}

std::uint32_t Bvh::new_block() {
  if (!free_blocks_.empty()) {
    const std::uint32_t block = free_blocks_.back();
    free_blocks_.pop_back();
    return block;
  }
  blocks_.emplace_back();
  return static_cast<std::uint32_t>(blocks_.size() - 1);
}

}  // namespace ryosen
