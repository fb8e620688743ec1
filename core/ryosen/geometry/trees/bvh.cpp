#include "ryosen/geometry/trees/bvh.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "ryosen/geometry/is_finite.h"
#include "ryosen/geometry/trees/primitive.h"
#include "ryosen/geometry/trees/small_stack.h"

namespace ryosen {
namespace {

// Relative error bound of the float box test.
constexpr float ray_margin = 0x1p-20f;

// Relative tolerance of the plane-box test in double.
constexpr double plane_margin = 0x1p-46;

}  // namespace

// A ray in the tree's frame, scaled so that the direction's largest component is 1. Boxes are inflated to cover the
// rounding of the origin and of the triangle test.
struct Bvh::LocalRay {
  Float4 before_lowest = Float4::all(0.0f);
  Float4 before_highest = Float4::all(0.0f);
  Float4 inverse = Float4::all(0.0f);
  float nearest = 0.0f;
  float farthest = 0.0f;
  double world_length = 0.0;  // length of one unit of t in mesh space
  double scale = 0.0;

  LocalRay(const Bvh& bvh, const Ray& ray) : world_length(largest_magnitude(ray.direction)), scale(bvh.scale_) {
    const glm::dvec3 origin = (ray.origin - bvh.origin_) * bvh.scale_;
    const double reach = largest_magnitude(origin);
    nearest = local_limit(ray.t_min, -ray_margin);
    farthest = local_limit(ray.t_max, ray_margin);
    // Origin too far away for floats: every box counts as hit (a zero inverse makes all entry parameters zero).
    if (!(reach < 1e15)) {
      nearest = 0.0f;
      farthest = std::numeric_limits<float>::infinity();
      unlimited_ = true;
      return;
    }
    const auto growth = static_cast<float>(reach + bvh.reach_) * ray_margin;
    std::array<float, 3> slope{};
    for (std::size_t i = 0; i < 3; ++i) {
      slope[i] = static_cast<float>(ray.direction[static_cast<int>(i)] / world_length);
      if (std::abs(slope[i]) < 1e-18f) slope[i] = std::signbit(slope[i]) ? -1e-18f : 1e-18f;
    }
    const Float4 start =
        Float4::of(static_cast<float>(origin.x), static_cast<float>(origin.y), static_cast<float>(origin.z), 1.0f);
    before_lowest = start + Float4::all(growth);
    before_highest = start - Float4::all(growth);
    inverse = Float4::of(1.0f / slope[0], 1.0f / slope[1], 1.0f / slope[2], 0.0f);
  }

  // A limit of t in the tree's frame, shifted by a relative amount.
  float local_limit(double t, float share) const {
    const double limit = std::clamp(t * world_length * scale, -1e37, 1e37);
    return static_cast<float>(limit + static_cast<double>(share) * std::abs(limit));
  }

  void shorten(double t) {
    if (!unlimited_) farthest = local_limit(t, ray_margin);
  }

  // The parameter at which the ray enters a box, or `missed` (infinity).
  float enter(const Node& node) const {
    const Float4 a = (node.lower_lanes() - before_lowest) * inverse;
    const Float4 b = (node.upper_lanes() - before_highest) * inverse;
    const float start = std::max(largest_of_three(smaller(a, b)), nearest);
    const float end = std::min(smallest_of_three(larger(a, b)), farthest);
    return start * (1.0f - ray_margin) <= end * (1.0f + ray_margin) ? start : missed;
  }

  static constexpr float missed = std::numeric_limits<float>::infinity();

 private:
  bool unlimited_ = false;
};

std::optional<RayHit> Bvh::cast(std::span<const glm::dvec3> positions, const Ray& ray,
                                const IndexSet* passed_over) const {
  const RayCaster caster(ray);
  if (live_ == 0 || !caster.is_valid()) return std::nullopt;
  struct Entry {
    std::uint32_t node;
    float start;
  };
  LocalRay local(*this, ray);
  RayHit best;
  best.t = ray.t_max;
  SmallStack<Entry> stack;
  const Node* here = &node(0);
  for (;;) {
    if (here->count == 0) {
      const std::uint32_t child = here->first;
      const float left = local.enter(node(child));
      const float right = local.enter(node(child + 1));
      const std::uint32_t right_first = right < left ? 1u : 0u;
      if (std::max(left, right) != LocalRay::missed)
        stack.push({child + 1 - right_first, std::max(left, right) * (1.0f - ray_margin)});
      if (std::min(left, right) != LocalRay::missed) {
        here = &node(child + right_first);
        continue;
      }
    } else {
      cast_leaf(positions, caster, *here, passed_over, best);
      if (best.slot != no_index) local.shorten(best.t);
    }
    const Entry next =
        stack.pop_until([&](const Entry& entry) { return entry.start <= local.farthest; }, {no_index, 0});
    if (next.node == no_index) break;
    here = &node(next.node);
  }
  if (best.slot == no_index) return std::nullopt;
  return best;
}

void Bvh::cast_leaf(std::span<const glm::dvec3> positions, const RayCaster& caster, const Node& leaf,
                    const IndexSet* passed_over, RayHit& best) const {
  for (std::uint32_t i = 0; i < leaf.count; ++i) {
    const std::uint32_t slot = blocks_[leaf.first][i];
    const std::array<std::uint32_t, 3>& v = primitives_[slot].vertices;
    if (v[2] == no_index || (passed_over && passed_over->contains(primitives_[slot].owner))) continue;
    const auto hit = caster.hit(positions[v[0]], positions[v[1]], positions[v[2]]);
    if (!hit || hit->t > best.t || (hit->t == best.t && slot > best.slot)) continue;
    best = {slot, hit->t, hit->barycentric};
  }
}

// Calls visit for the slots of each leaf that meets(node), as do all nodes above it.
template <class Meets, class Visit>
void Bvh::visit_where(const Meets& meets, const Visit& visit) const {
  SmallStack<std::uint32_t> stack;
  if (live_ != 0) stack.push(0);
  while (!stack.empty()) {
    const Node& here = node(stack.pop());
    if (!meets(here)) continue;
    if (here.count == 0) {
      stack.push(here.first + 1);
      stack.push(here.first);
      continue;
    }
    for (std::uint32_t i = 0; i < here.count; ++i) visit(blocks_[here.first][i]);
  }
}

void Bvh::visit_frustum(std::span<const glm::dvec3> positions, const Frustum& frustum, SlotVisitor visit) const {
  // A plane in the tree's frame, tested against the box corner farthest along its normal (p-vertex).
  struct LocalPlane {
    double x, y, z, w;
    std::array<std::uint8_t, 3> corner;  // indices of its coordinates among the six bounds of a box
  };
  std::array<LocalPlane, Frustum::most_planes> local{};
  for (std::size_t i = 0; i < frustum.count; ++i) {
    const glm::dvec3 normal(frustum.planes[i]);
    const double offset = glm::dot(normal, origin_) + frustum.planes[i].w;
    const double size = glm::dot(glm::abs(normal), glm::abs(origin_) + reach_ / scale_) + std::abs(frustum.planes[i].w);
    const glm::dvec3 scaled = normal / scale_;
    const auto coordinate = [&](glm::length_t axis) {
      return static_cast<std::uint8_t>(scaled[axis] > 0.0 ? axis + 3 : axis);
    };
    local[i] = {
        scaled.x, scaled.y, scaled.z, offset + plane_margin * size, {coordinate(0), coordinate(1), coordinate(2)}};
  }
  const auto meets = [&](const std::array<double, 6>& bounds) {
    for (std::size_t i = 0; i < frustum.count; ++i) {
      const LocalPlane& p = local[i];
      if (p.x * bounds[p.corner[0]] + p.y * bounds[p.corner[1]] + p.z * bounds[p.corner[2]] + p.w < 0.0) return false;
    }
    return true;
  };
  const auto meets_node = [&](const Node& n) {
    return meets({n.lowest[0], n.lowest[1], n.lowest[2], n.highest[0], n.highest[1], n.highest[2]});
  };
  visit_where(meets_node, [&](std::uint32_t slot) {
    const Box box = box_of(positions, primitives_[slot]);
    const glm::dvec3 low = (box.lowest - origin_) * scale_, high = (box.highest - origin_) * scale_;
    if (meets({low.x, low.y, low.z, high.x, high.y, high.z})) visit(slot);
  });
}

void Bvh::visit_box(std::span<const glm::dvec3> positions, const Box& box, SlotVisitor visit) const {
  const FloatBox local = local_box(box);
  const std::array<float, 4> lowest = floats_of(local.lowest), highest = floats_of(local.highest);
  const auto meets = [&](const Node& n) {
    bool is_apart = false;
    for (std::size_t i = 0; i < 3; ++i) is_apart |= n.highest[i] < lowest[i] || highest[i] < n.lowest[i];
    return !is_apart;
  };
  visit_where(meets, [&](std::uint32_t slot) {
    if (box.overlaps(box_of(positions, primitives_[slot]))) visit(slot);
  });
}

std::optional<NearestHit> Bvh::nearest(std::span<const glm::dvec3> positions, const glm::dvec3& point,
                                       double max_distance) const {
  if (live_ == 0 || !::ryosen::is_finite(point)) return std::nullopt;
  const glm::dvec3 local = (point - origin_) * scale_;
  const double slack = (largest_magnitude(local) + reach_) * 0x1p-40;
  const auto distance_to = [&](const Node& n) {
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double p = local[static_cast<int>(i)];
      const double gap = std::max({static_cast<double>(n.lowest[i]) - p, p - static_cast<double>(n.highest[i]), 0.0});
      sum += gap * gap;
    }
    return std::sqrt(sum) / scale_;
  };
  struct Entry {
    std::uint32_t node;
    double distance;
  };
  NearestHit best;
  best.distance = max_distance;
  SmallStack<Entry> stack;
  stack.push({0, distance_to(node(0))});
  while (!stack.empty()) {
    const Entry entry = stack.pop();
    if (entry.distance > best.distance + slack / scale_) continue;
    const Node& here = node(entry.node);
    if (here.count == 0) {
      const Entry left{here.first, distance_to(node(here.first))};
      const Entry right{here.first + 1, distance_to(node(here.first + 1))};
      stack.push(left.distance <= right.distance ? right : left);
      stack.push(left.distance <= right.distance ? left : right);
      continue;
    }
    for (std::uint32_t i = 0; i < here.count; ++i) {
      const std::uint32_t slot = blocks_[here.first][i];
      const NearestPlace place = nearest_place(positions, primitives_[slot], point);
      if (!(place.distance <= best.distance) || (place.distance == best.distance && slot > best.slot)) continue;
      best = {slot, place.distance, place.place, place.barycentric};
    }
  }
  if (best.slot == no_index) return std::nullopt;
  return best;
}

std::size_t Bvh::bytes() const {
  return primitives_.capacity() * sizeof(Primitive) + leaf_of_.capacity() * sizeof(std::uint32_t) +
         pairs_.capacity() * sizeof(NodePair) + parents_.capacity() * sizeof(std::uint32_t) +
         blocks_.capacity() * sizeof(SlotBlock) +
         (free_pairs_.capacity() + free_blocks_.capacity()) * sizeof(std::uint32_t);
}

}  // namespace ryosen
