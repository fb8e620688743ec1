// The face corners at points, grouped to the fans that pairs of faces make of them.
#pragma once

#include <span>
#include <unordered_map>
#include <vector>

#include "ryosen/analysis/disjoint_sets.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// A corner is the halfedge of its face that begins at the point. Corners of a point are in one fan where pairs of sides
// connect them. The mesh must outlive it and not change, but for what is told by rename(). Points at one place count as
// one where `place` has by vertex slot the one that stands for it.
class FanGroups {
 public:
  explicit FanGroups(const Mesh& mesh, const std::vector<Vertex>* place = nullptr) : mesh_(mesh), place_(place) {}

  // Adds a side of a face at one of the points, and the side that it is paired with, or none.
  void add_side(Halfedge side, Halfedge across) { across_[side] = across; }
  // Adds a corner at one of the points; both of its sides are known.
  void add_corner(Halfedge corner) { corners_.push_back(corner); }
  // Finds the fans, once all sides and corners are known; each is a group of its own. At each of these edges, given by
  // its sides, which run between two of the points, pairs are exchanged until no two of them have the same fans at both
  // ends: else two vertices would have two edges. Cost: O(k log k) for k sides, and that of a fan for each exchange.
  void find_fans(const std::vector<std::vector<Halfedge>>& edges);

  Halfedge across(Halfedge side) const { return across_.at(side); }
  // Makes the fans of two corners one group.
  void join(Halfedge corner, Halfedge other) { groups_.join(fan_.at(corner), fan_.at(other)); }
  std::uint32_t group(Halfedge corner) { return groups_.root(fan_.at(corner)); }
  bool knows(Halfedge corner) const { return fan_.contains(corner); }
  // The side is another halfedge now.
  void rename(Halfedge side, Halfedge now);

 private:
  // Sides of two faces between two points that are paired, or one alone; and their fans.
  struct Pair {
    Halfedge forward, backward;
    std::uint32_t fan_at_start, fan_at_end;
  };

  std::vector<Halfedge> corners_of_fan(Halfedge corner) const;
  std::vector<Pair> pairs_of(std::span<const Halfedge> sides) const;
  bool exchange_two(std::span<const Halfedge> sides);
  void set_pair(Halfedge forward, Halfedge backward);
  void give_new_fan(Halfedge corner);

  const Mesh& mesh_;
  const std::vector<Vertex>* place_;
  std::vector<Halfedge> corners_;
  std::unordered_map<Halfedge, Halfedge> across_;
  std::unordered_map<Halfedge, std::uint32_t> fan_;
  std::uint32_t fans_ = 0;
  DisjointSets groups_;
};

}  // namespace ryosen
