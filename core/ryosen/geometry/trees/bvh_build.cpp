#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "ryosen/base/column_memory.h"
#include "ryosen/base/interruption.h"
#include "ryosen/geometry/trees/bvh.h"

namespace ryosen {

// Top-down build that splits ranges of primitives by the surface area heuristic.
class BvhBuilder {
 public:
  BvhBuilder(Bvh& bvh, std::span<const glm::dvec3> positions) : bvh_(bvh) {
    reserve_large(items_, bvh.primitives_.size());
    for (std::uint32_t slot = 0; slot < bvh.primitives_.size(); ++slot) {
      stop_if_interrupted(slot);
      const Primitive& primitive = bvh.primitives_[slot];
      if (primitive.size() == 0 || !Bvh::is_finite(positions, primitive)) continue;
      items_.push_back({bvh.local_box(box_of(positions, primitive)), slot});
    }
  }

  // False if cancelled.
  bool run(Progress& progress) {
    bvh_.live_ = items_.size();
    if (items_.empty()) return true;
    bvh_.pairs_.reserve(items_.size() / 2 + 1);
    bvh_.parents_.reserve(items_.size() / 2 + 1);
    bvh_.blocks_.reserve(items_.size() / 2 + 1);
    bvh_.new_pair();
    std::vector<Task> tasks = {{0, 0, static_cast<std::uint32_t>(items_.size()), 0}};
    while (!tasks.empty()) {
      const Task task = tasks.back();
      tasks.pop_back();
      if (task.last - task.first >= worth_telling && !progress.go_on(task.first, items_.size())) return false;
      const Bounds bounds = bounds_of(task);
      bvh_.set_box(task.node, bounds.box);
      bvh_.reach_ = std::max(bvh_.reach_, static_cast<double>(largest_magnitude(bounds.box)));
      const std::uint32_t middle = choose_middle(task, bounds);
      if (middle == task.first) {
        make_leaf(task);
        continue;
      }
      const std::uint32_t children = bvh_.new_pair();
      bvh_.node(task.node).first = children;
      bvh_.node(task.node).count = 0;
      bvh_.parents_[children >> 1u] = task.node;
      tasks.push_back({children + 1, middle, task.last, task.depth + 1});
      tasks.push_back({children, task.first, middle, task.depth + 1});
    }
    return true;
  }

 private:
  static constexpr std::size_t most_bins = 16;
  static constexpr std::uint32_t worth_telling = 1000;     // primitives of a node
  static constexpr std::uint32_t most_depth_by_area = 48;  // below, median splits bound the depth

  struct Item {
    FloatBox box;
    std::uint32_t slot;
    // Twice the centre, which sorts the same.
    Float4 center() const { return box.lowest + box.highest; }
  };
  struct Task {
    std::uint32_t node, first, last, depth;
  };
  struct Bounds {
    FloatBox box = empty_box();
    FloatBox centers = empty_box();
  };
  struct Bin {
    FloatBox box = empty_box();
    std::uint32_t count = 0;
  };
  struct Plane {
    float cost = std::numeric_limits<float>::infinity();
    int axis = -1;
    int bin = 0;
  };

  Bounds bounds_of(const Task& task) const {
    Bounds bounds;
    for (std::uint32_t i = task.first; i < task.last; ++i) {
      stop_if_interrupted(i);
      grow(bounds.box, items_[i].box);
      const Float4 center = items_[i].center();
      grow(bounds.centers, {center, center});
    }
    return bounds;
  }

  // Partitions the range and returns where its second part starts, or the range's start for a leaf.
  std::uint32_t choose_middle(const Task& task, const Bounds& bounds) {
    const std::uint32_t count = task.last - task.first;
    if (count == 1) return task.first;
    const bool fits = count <= Bvh::leaf_capacity;
    const BinScale scale(bounds.centers, count);
    Plane plane;
    if (task.depth < most_depth_by_area && scale.is_usable) plane = best_plane(task, scale);
    if (plane.axis < 0) return fits ? task.first : halve(task, scale.extent);
    const float leaf_cost = static_cast<float>(count) * half_area(bounds.box);
    if (fits && leaf_cost <= plane.cost + 2.0f * half_area(bounds.box)) return task.first;
    const auto axis = static_cast<std::size_t>(plane.axis);
    std::uint32_t step = 0;
    const auto middle = std::partition(items_.begin() + task.first, items_.begin() + task.last, [&](const Item& item) {
      stop_if_interrupted(step++);
      return scale.bins_of(item.center())[axis] <= plane.bin;
    });
    return static_cast<std::uint32_t>(middle - items_.begin());
  }

  // Divides the extent of the centres into equal bins along every axis.
  struct BinScale {
    std::size_t bins;
    std::array<float, 4> extent;
    bool is_usable;
    Float4 start, factor;

    BinScale(const FloatBox& centers, std::uint32_t count)
        : bins(std::min<std::size_t>(most_bins, 4 + count / 4)),
          extent(floats_of(centers.highest - centers.lowest)),
          is_usable(std::max({extent[0], extent[1], extent[2]}) > 1e-30f),
          start(centers.lowest),
          factor(Float4::of(share(extent[0]), share(extent[1]), share(extent[2]), 0.0f)) {}

    float share(float length) const { return length > 1e-30f ? static_cast<float>(bins) * 0.99999f / length : 0.0f; }

    std::array<int, 3> bins_of(Float4 center) const {
      const std::array<float, 4> place = floats_of((center - start) * factor);
      return {static_cast<int>(place[0]), static_cast<int>(place[1]), static_cast<int>(place[2])};
    }
  };

  Plane best_plane(const Task& task, const BinScale& scale) {
    for (auto& axis : bins_) std::fill_n(axis.begin(), scale.bins, Bin{});
    for (std::uint32_t i = task.first; i < task.last; ++i) {
      stop_if_interrupted(i);
      const std::array<int, 3> place = scale.bins_of(items_[i].center());
      for (std::size_t axis = 0; axis < 3; ++axis) {
        Bin& bin = bins_[axis][static_cast<std::size_t>(place[axis])];
        grow(bin.box, items_[i].box);
        ++bin.count;
      }
    }
    Plane best;
    for (std::size_t axis = 0; axis < 3; ++axis) compare_planes(axis, scale.bins, best);
    return best;
  }

  void compare_planes(std::size_t axis, std::size_t bins, Plane& best) const {
    std::array<float, most_bins> right_cost{};
    Bin sum;
    for (std::size_t i = bins - 1; i > 0; --i) {
      grow(sum.box, bins_[axis][i].box);
      sum.count += bins_[axis][i].count;
      right_cost[i] = sum.count == 0 ? -1.0f : static_cast<float>(sum.count) * half_area(sum.box);
    }
    sum = Bin{};
    for (std::size_t i = 0; i + 1 < bins; ++i) {
      grow(sum.box, bins_[axis][i].box);
      sum.count += bins_[axis][i].count;
      if (sum.count == 0 || right_cost[i + 1] < 0.0f) continue;
      const float cost = static_cast<float>(sum.count) * half_area(sum.box) + right_cost[i + 1];
      if (cost < best.cost) best = {cost, static_cast<int>(axis), static_cast<int>(i)};
    }
  }

  std::uint32_t halve(const Task& task, const std::array<float, 4>& extent) {
    const std::size_t axis = extent[0] >= extent[1] && extent[0] >= extent[2] ? 0 : extent[1] >= extent[2] ? 1 : 2;
    const std::uint32_t middle = task.first + (task.last - task.first) / 2;
    std::nth_element(items_.begin() + task.first, items_.begin() + middle, items_.begin() + task.last,
                     [&](const Item& a, const Item& b) {
                       const float x = floats_of(a.center())[axis];
                       const float y = floats_of(b.center())[axis];
                       return x != y ? x < y : a.slot < b.slot;
                     });
    return middle;
  }

  void make_leaf(const Task& task) {
    const std::uint32_t block = bvh_.new_block();
    bvh_.node(task.node).first = block;
    bvh_.node(task.node).count = task.last - task.first;
    for (std::uint32_t i = task.first; i < task.last; ++i) {
      bvh_.blocks_[block][i - task.first] = items_[i].slot;
      bvh_.leaf_of_[items_[i].slot] = task.node;
    }
  }

  Bvh& bvh_;
  std::vector<Item> items_;
  std::array<std::array<Bin, most_bins>, 3> bins_;
};

void Bvh::build(std::span<const glm::dvec3> positions, std::vector<Primitive> primitives) {
  Progress unseen;
  build(positions, std::move(primitives), unseen);
}

bool Bvh::build(std::span<const glm::dvec3> positions, std::vector<Primitive> primitives, Progress& progress) {
  primitives_ = std::move(primitives);
  if (rebuild(positions, progress)) return true;
  *this = Bvh();
  return false;
}

void Bvh::rebuild(std::span<const glm::dvec3> positions) {
  Progress unseen;
  rebuild(positions, unseen);
}

bool Bvh::rebuild(std::span<const glm::dvec3> positions, Progress& progress) {
  leaf_of_.clear();
  reserve_large(leaf_of_, primitives_.size());
  for (std::uint32_t slot = 0; slot < primitives_.size(); ++slot) {
    stop_if_interrupted(slot);
    leaf_of_.push_back(no_index);
  }
  pairs_.clear();
  parents_.clear();
  blocks_.clear();
  free_pairs_.clear();
  free_blocks_.clear();
  reach_ = 0.0;
  changes_ = 0;
  choose_frame(positions);
  return BvhBuilder(*this, positions).run(progress);
}

// The frame's origin is the centre of the primitives' bounding box and its scale the power of two that makes them about
// one unit large: floats then resolve a small mesh far from the origin as well as a large one at it.
void Bvh::choose_frame(std::span<const glm::dvec3> positions) {
  Box box;
  std::uint32_t step = 0;
  for (const Primitive& primitive : primitives_) {
    stop_if_interrupted(step++);
    if (primitive.size() == 0 || !is_finite(positions, primitive)) continue;
    box.add(box_of(positions, primitive));
  }
  origin_ = glm::dvec3(0.0);
  scale_ = 1.0;
  if (box.is_empty()) return;
  origin_ = box.middle();
  const glm::dvec3 half = box.highest * 0.5 - box.lowest * 0.5;
  const double size = std::max({half.x, half.y, half.z});
  if (size > 0.0) scale_ = std::ldexp(1.0, -std::clamp(std::ilogb(size), -1000, 1000));
}

}  // namespace ryosen
