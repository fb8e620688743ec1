// A sequence in a balanced binary tree (treap), for orders that only a descent from the root can determine.
#pragma once

#include <cstdint>
#include <vector>

namespace ryosen {

// Nodes are numbers chosen by the caller, each in the tree at most once. To search, descend from root() by left() and
// right(). Inserting and erasing cost O(log n) expected for any input, because priorities are hashes of the numbers.
// Deterministic: the same calls give the same tree.
class OrderedTree {
 public:
  static constexpr std::uint32_t none = 0xffffffffu;

  void clear() {
    links_.clear();
    root_ = none;
  }

  std::uint32_t root() const { return root_; }
  std::uint32_t left(std::uint32_t node) const { return links_[node].child[0]; }
  std::uint32_t right(std::uint32_t node) const { return links_[node].child[1]; }

  // Inserts a node at the empty link where a search ended; `parent` is none for an empty tree.
  void attach(std::uint32_t node, std::uint32_t parent, bool to_the_right) {
    if (links_.size() <= node) links_.resize(node + 1);
    links_[node] = {{none, none}, parent, hash(node)};
    if (parent == none) {
      root_ = node;
      return;
    }
    links_[parent].child[to_the_right] = node;
    while (links_[node].parent != none && links_[links_[node].parent].priority < links_[node].priority) {
      rotate_up(node);
    }
  }

  // Inserts a node directly after another one.
  void insert_after(std::uint32_t node, std::uint32_t before) {
    std::uint32_t place = right(before);
    if (place == none) return attach(node, before, true);
    while (left(place) != none) place = left(place);
    attach(node, place, false);
  }

  void erase(std::uint32_t node) {
    while (left(node) != none || right(node) != none) {
      const std::uint32_t l = left(node);
      const std::uint32_t r = right(node);
      const bool use_left = r == none || (l != none && links_[l].priority > links_[r].priority);
      rotate_up(use_left ? l : r);
    }
    const std::uint32_t parent = links_[node].parent;
    if (parent == none) {
      root_ = none;
    } else {
      links_[parent].child[links_[parent].child[1] == node] = none;
    }
  }

 private:
  struct Links {
    std::uint32_t child[2] = {none, none};
    std::uint32_t parent = none;
    std::uint32_t priority = 0;
  };

  static std::uint32_t hash(std::uint32_t x) {
    x = (x ^ (x >> 16u)) * 0x7feb352du;
    x = (x ^ (x >> 15u)) * 0x846ca68bu;
    return x ^ (x >> 16u);
  }

  void rotate_up(std::uint32_t node) {
    const std::uint32_t parent = links_[node].parent;
    const std::uint32_t above = links_[parent].parent;
    const bool was_right = links_[parent].child[1] == node;
    const std::uint32_t inner = links_[node].child[!was_right];
    links_[parent].child[was_right] = inner;
    if (inner != none) links_[inner].parent = parent;
    links_[node].child[!was_right] = parent;
    links_[parent].parent = node;
    links_[node].parent = above;
    if (above == none) {
      root_ = node;
    } else {
      links_[above].child[links_[above].child[1] == parent] = node;
    }
  }

  std::vector<Links> links_;
  std::uint32_t root_ = none;
};

}  // namespace ryosen
