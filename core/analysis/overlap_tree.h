// A tree of boxes over the triangles of a surface, which finds the pairs whose boxes overlap.
//
// Boxes along the axes tell little apart where triangles are long and thin: the wedges of a fan all overlap at its tip,
// and so do parallel slivers aslant. So triangles around a point with many form a star, a subtree of its own in which
// boxes hold directions from there; and where triangles turn out to be slivers, the boxes of a subtree lie along them.
#pragma once

#include <cstdint>
#include <deque>
#include <mutex>
#include <span>
#include <vector>

#include "core/analysis/numbered_surface.h"
#include "core/analysis/overlap_view.h"

namespace ryosen {

// Refers to the surface. Building takes O(n log n). threads: as many as may work at the same time.
class OverlapTree {
 public:
  OverlapTree(const NumberedSurface& surface, unsigned threads);

  std::uint32_t node_count() const { return static_cast<std::uint32_t>(nodes_.size()); }

  // Calls visit(slot, slot) for each pair of triangles with overlapping boxes of which the one that comes first is in the
  // leaf `node`, until it returns false; then so does this.
  template <class Visit>
  bool visit_pairs(std::uint32_t node, const Visit& visit) const;

 private:
  static constexpr std::uint32_t leaf_size = 4;

  struct Triangle {
    OverlapBox box;  // in the view of its leaf
    std::uint32_t slot;
  };
  // Nodes lie in depth-first order, so that whatever comes later in the order of leaves lies behind.
  struct Node {
    OverlapBox box;
    const OverlapView* view;  // the one the box is in
    std::uint32_t behind;     // the first node that is not below this one
    std::uint32_t first = 0;  // a leaf's triangles
    std::uint32_t count = 0;
  };
  struct Star {
    OverlapBox box;             // in the view of space
    std::uint32_t first, last;  // its triangles
    std::uint32_t point;
  };
  // The triangles of a leaf in the view of the node at hand.
  struct Leaf {
    std::array<OverlapBox, leaf_size> boxes;
    OverlapBox whole;
    const OverlapView* view;
  };

  static std::uint32_t leaf_count(std::uint32_t triangles) { return (triangles + leaf_size - 1) / leaf_size; }
  static std::uint32_t nodes_for(std::uint32_t triangles) { return triangles > 0 ? 2 * leaf_count(triangles) - 1 : 0; }
  static std::uint32_t nodes_for(std::span<const Star> stars);

  void collect_triangles(unsigned threads);
  // Moves the triangles of stars to the end, star by star.
  std::vector<Star> gather_stars();
  void build(std::uint32_t node, std::uint32_t first, std::uint32_t last, const OverlapView& view, unsigned threads);
  void build_stars(std::uint32_t node, std::span<Star> stars, unsigned threads);
  void divide(std::uint32_t node, std::uint32_t first, std::uint32_t last, const OverlapView& view, unsigned threads);
  // The view for what is below a node: another one where its triangles are slivers that lie along each other.
  const OverlapView& view_below(std::uint32_t first, std::uint32_t last, const OverlapView& view);
  OverlapView view_of_star(const Star& star) const;
  const OverlapView& add_view(const OverlapView& view);
  // Brings the boxes of triangles into a view.
  void look(std::uint32_t first, std::uint32_t last, const OverlapView& view);
  void look(const Node& leaf, const OverlapView& view, Leaf& seen) const;
  // Whether triangle i of a leaf overlaps triangle j of another in the view of the former too.
  bool overlap_for_leaf(const Node& leaf, std::uint32_t i, const Node& other, std::uint32_t j) const {
    return leaf.view == other.view || leaf.view == &views_.front() ||
           triangles_[leaf.first + i].box.overlaps(leaf.view->box_of(surface_.triangle(triangles_[j].slot)));
  }

  const NumberedSurface& surface_;
  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
  std::deque<OverlapView> views_;  // their places stay; the first is that of space
  std::mutex views_change_;
};

template <class Visit>
bool OverlapTree::visit_pairs(std::uint32_t node, const Visit& visit) const {
  const Node& leaf = nodes_[node];
  if (leaf.count == 0) return true;
  Leaf seen;
  look(leaf, *leaf.view, seen);
  const auto pair_up = [&](std::uint32_t i, const Node& other, std::uint32_t begin) {
    for (std::uint32_t j = begin; j < other.first + other.count; ++j)
      if (seen.boxes[i].overlaps(triangles_[j].box) && overlap_for_leaf(leaf, i, other, j) &&
          !visit(triangles_[leaf.first + i].slot, triangles_[j].slot))
        return false;
    return true;
  };
  for (std::uint32_t i = 0; i < leaf.count; ++i)
    if (!pair_up(i, leaf, leaf.first + i + 1)) return false;
  for (std::uint32_t k = node + 1; k < nodes_.size();) {
    const Node& other = nodes_[k];
    if (other.view != seen.view) look(leaf, *other.view, seen);
    if (!seen.whole.overlaps(other.box)) {
      k = other.behind;
      continue;
    }
    for (std::uint32_t i = 0; other.count > 0 && i < leaf.count; ++i)
      if (seen.boxes[i].overlaps(other.box) && !pair_up(i, other, other.first)) return false;
    ++k;
  }
  return true;
}

}  // namespace ryosen
