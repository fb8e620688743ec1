// A bounding volume hierarchy over the triangles of a surface for broad-phase self-collision: finds the pairs with
// overlapping boxes.
//
// Axis-aligned boxes separate long, thin triangles poorly: the boxes of a fan all overlap at its tip, and so do those
// of parallel oblique slivers. So the triangles around a point of high valence form a star, a subtree whose boxes bound
// directions from that point; and subtrees of slivers use boxes oriented along them. Neither do they tell large
// triangles apart that lie over each other like the walls of stacked cups: those are parted by their normals first, and
// then have boxes that lie flat along them.
#pragma once

#include <cstdint>
#include <deque>
#include <mutex>
#include <span>
#include <vector>

#include "ryosen/analysis/numbered_surface.h"
#include "ryosen/analysis/overlap_view.h"
#include "ryosen/base/interruption.h"
#include "ryosen/base/parallel.h"

namespace ryosen {

// Refers to the surface. Build: O(n log n), on up to `threads` threads.
class OverlapTree {
 public:
  OverlapTree(const NumberedSurface& surface, unsigned threads);

  std::uint32_t node_count() const { return static_cast<std::uint32_t>(nodes_.size()); }

  // Whether is(slot) holds for all triangles in the leaf `node`; true where it is no leaf.
  template <class Is>
  bool holds_for_all(std::uint32_t node, const Is& is) const;

  // Calls visit(slot, slot) for each pair of triangles with overlapping boxes whose first one, in leaf order, is in the
  // leaf `node`. Stops and returns false when visit does. Leaves out pairs for which may(slot, slot) is false, which is
  // asked first: it should be quick.
  template <class May, class Visit>
  bool visit_pairs(std::uint32_t node, const May& may, const Visit& visit) const;

  // The leaf of each triangle, by slot; no_index for flat ones. O(triangles).
  std::vector<std::uint32_t> leaves_of_slots() const;
  // Calls visit(slot) for each other triangle whose box overlaps that of this one, which is in the leaf `node`, but for
  // those for which may(slot) is false.
  template <class May, class Visit>
  void visit_overlaps(std::uint32_t slot, std::uint32_t node, const May& may, const Visit& visit) const;

 private:
  static constexpr std::uint32_t leaf_size = 4;
  static constexpr std::uint32_t samples = 16;  // triangles sampled per node

  struct Triangle {
    OverlapBox box;  // in the view of its leaf
    std::uint32_t slot;
  };
  // Nodes are stored in preorder, so later leaves have larger indices.
  struct Node {
    OverlapBox box;
    const OverlapView* view;  // of the box
    std::uint32_t behind;     // index past this node's subtree
    std::uint32_t first = 0;  // a leaf's triangles
    std::uint32_t count = 0;
  };
  struct Star {
    OverlapBox box;             // in the axis-aligned view
    std::uint32_t first, last;  // its triangles
    std::uint32_t point;
  };
  // The triangles of a leaf, in the view of the node they are tested against.
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
  enum class By { place, normal };
  void divide(std::uint32_t node, std::uint32_t first, std::uint32_t last, const OverlapView& view, unsigned threads,
              By by = By::place);
  // The view for a node's children: an oriented one if its triangles are aligned slivers.
  const OverlapView& view_below(std::uint32_t first, std::uint32_t last, const OverlapView& view);
  OverlapView view_of_star(const Star& star) const;
  const OverlapView& add_view(const OverlapView& view);
  const Triangle& sample(std::uint32_t first, std::uint32_t last, std::uint32_t k) const {
    return triangles_[part_begin(last - first, k, samples) + first];
  }
  // Whether the boxes in a node lie over each other along all axes.
  bool is_stack(std::uint32_t first, std::uint32_t last) const;
  enum class Sheets { parallel, of_several_normals, not_apart };
  // How the triangles of a stack are told apart, with the view for it where they are parallel.
  Sheets sheets_in(std::uint32_t first, std::uint32_t last, OverlapView& view) const;
  // Partitions at the `middle`-th by normal, of either sign, along the axis in which normals differ most.
  void halve_by_normal(std::uint32_t first, std::uint32_t middle, std::uint32_t last);
  // Recomputes the boxes of triangles in a view.
  void look(std::uint32_t first, std::uint32_t last, const OverlapView& view);
  void look(const Node& leaf, const OverlapView& view, Leaf& seen) const;
  // Whether the boxes of triangle i of a leaf and triangle j of another also overlap in the former's view.
  bool overlap_for_leaf(const Node& leaf, std::uint32_t i, const Node& other, std::uint32_t j) const {
    return leaf.view == other.view || leaf.view == &views_.front() ||
           triangles_[leaf.first + i].box.overlaps(leaf.view->box_of(surface_.triangle(triangles_[j].slot)));
  }

  const NumberedSurface& surface_;
  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
  std::deque<OverlapView> views_;  // a deque for stable addresses; the first is the axis-aligned view
  std::mutex views_change_;
};

template <class Is>
bool OverlapTree::holds_for_all(std::uint32_t node, const Is& is) const {
  const Node& leaf = nodes_[node];
  for (std::uint32_t i = 0; i < leaf.count; ++i)
    if (!is(triangles_[leaf.first + i].slot)) return false;
  return true;
}

template <class May, class Visit>
bool OverlapTree::visit_pairs(std::uint32_t node, const May& may, const Visit& visit) const {
  stop_if_interrupted();
  const Node& leaf = nodes_[node];
  if (leaf.count == 0) return true;
  Leaf seen;
  look(leaf, *leaf.view, seen);
  const auto pair_up = [&](std::uint32_t i, const Node& other, std::uint32_t begin) {
    for (std::uint32_t j = begin; j < other.first + other.count; ++j)
      if (seen.boxes[i].overlaps(triangles_[j].box) && may(triangles_[leaf.first + i].slot, triangles_[j].slot) &&
          overlap_for_leaf(leaf, i, other, j) && !visit(triangles_[leaf.first + i].slot, triangles_[j].slot))
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

template <class May, class Visit>
void OverlapTree::visit_overlaps(std::uint32_t slot, std::uint32_t node, const May& may, const Visit& visit) const {
  stop_if_interrupted();
  const Node& leaf = nodes_[node];
  std::uint32_t own = 0;
  while (triangles_[leaf.first + own].slot != slot) ++own;
  const Triangle& triangle = triangles_[leaf.first + own];
  const OverlapView* view = leaf.view;
  OverlapBox seen = triangle.box;
  for (std::uint32_t k = 0; k < nodes_.size();) {
    const Node& other = nodes_[k];
    if (other.view != view) {
      view = other.view;
      seen = view == leaf.view ? triangle.box : view->box_of(surface_.triangle(slot));
    }
    if (!seen.overlaps(other.box)) {
      k = other.behind;
      continue;
    }
    for (std::uint32_t j = other.first; j < other.first + other.count; ++j)
      if (triangles_[j].slot != slot && seen.overlaps(triangles_[j].box) && may(triangles_[j].slot) &&
          overlap_for_leaf(leaf, own, other, j))
        visit(triangles_[j].slot);
    ++k;
  }
}

}  // namespace ryosen
