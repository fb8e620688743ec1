#include "ryosen/analysis/measure/flat_regions.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <tuple>

#include "ryosen/geometry/predicates.h"

namespace ryosen {

namespace {

constexpr double flat = 1e-12;  // of coordinates of about 1: so far from a plane lies on it
constexpr double pull = 3e-11;  // by this share a triangle that leaves a region by rounding is drawn inwards

double sign(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return static_cast<double>(orient2d(a, b, c));
}

// Whether a side runs through the inside of a triangle that turns left.
bool enters(const std::array<glm::dvec2, 2>& side, const std::array<glm::dvec2, 3>& t) {
  bool on_left = false, on_right = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec2 &a = t[i], &b = t[(i + 1) % 3];
    if (sign(a, b, side[0]) <= 0 && sign(a, b, side[1]) <= 0) return false;
    const double beside = sign(side[0], side[1], a);
    on_left = on_left || beside > 0;
    on_right = on_right || beside < 0;
  }
  return on_left && on_right;
}

// Whether a box is surely outside of a triangle that turns left.
bool is_apart(const glm::dvec2& lowest, const glm::dvec2& highest, const std::array<glm::dvec2, 3>& t) {
  constexpr double rounding = 1e-14;  // of a product of coordinates of about 1
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec2 way = t[(i + 1) % 3] - t[i];
    const double x = (way.y < 0 ? highest.x : lowest.x) - t[i].x, y = (way.x > 0 ? highest.y : lowest.y) - t[i].y;
    if (way.x * y - way.y * x < -rounding) return true;
  }
  const glm::dvec2 low = glm::min(glm::min(t[0], t[1]), t[2]), high = glm::max(glm::max(t[0], t[1]), t[2]);
  return lowest.x >= high.x || lowest.y >= high.y || highest.x <= low.x || highest.y <= low.y;
}

}  // namespace

FlatRegions::FlatRegions(const TriangleTree& to) : to_(to), region_of_(to.size(), no_index) {
  const auto neighbours = find_neighbours();
  for (std::uint32_t t = 0; t < to.size(); ++t)
    if (region_of_[t] == no_index) grow(t, neighbours);
}

// The neighbour at each side, from corner i on; none where a border is, or more than two meet.
std::vector<std::array<std::uint32_t, 3>> FlatRegions::find_neighbours() const {
  struct Half {
    std::uint32_t from, to, triangle, side;
    auto key() const { return std::pair(std::min(from, to), std::max(from, to)); }
  };
  std::vector<Half> halves;
  halves.reserve(to_.size() * std::size_t{3});
  for (std::uint32_t t = 0; t < to_.size(); ++t)
    for (std::uint32_t i = 0; i < 3; ++i) halves.push_back({to_.corners(t)[i], to_.corners(t)[(i + 1) % 3], t, i});
  std::sort(halves.begin(), halves.end(), [](const Half& a, const Half& b) {
    return std::tuple(a.key(), a.triangle, a.side) < std::tuple(b.key(), b.triangle, b.side);
  });
  std::vector<std::array<std::uint32_t, 3>> neighbours(to_.size(), {no_index, no_index, no_index});
  for (std::size_t begin = 0, end = 0; begin < halves.size(); begin = end) {
    while (end < halves.size() && halves[end].key() == halves[begin].key()) ++end;
    if (end - begin != 2 || halves[begin].from == halves[begin + 1].from) continue;
    neighbours[halves[begin].triangle][halves[begin].side] = halves[begin + 1].triangle;
    neighbours[halves[begin + 1].triangle][halves[begin + 1].side] = halves[begin].triangle;
  }
  return neighbours;
}

FlatRegions::Corners FlatRegions::seen(const TrianglePlaces& places, const Region& region) const {
  const auto x = static_cast<int>((region.dropped + 1) % 3), y = static_cast<int>((region.dropped + 2) % 3);
  Corners corners;
  for (std::size_t i = 0; i < 3; ++i) corners[i] = {places[i][x], places[i][y]};
  if (region.turn < 0) std::swap(corners[1], corners[2]);
  return corners;
}

// All triangles seen from one side turn the same way: so the number of them above a place changes at the border alone.
void FlatRegions::grow(std::uint32_t from, const std::vector<std::array<std::uint32_t, 3>>& neighbours) {
  glm::dvec3 normal = to_.area_normal(from);
  const double length = glm::length(normal);
  if (!(length > 0)) return;
  normal /= length;
  Region region;
  for (std::size_t axis = 1; axis < 3; ++axis)
    if (std::abs(normal[static_cast<int>(axis)]) > std::abs(normal[static_cast<int>(region.dropped)]))
      region.dropped = axis;
  region.turn = normal[static_cast<int>(region.dropped)] < 0 ? -1 : 1;
  const glm::dvec3 start = to_.places(from)[0];
  const auto number = static_cast<std::uint32_t>(regions_.size());
  std::vector<std::uint32_t> triangles;
  const auto take = [&](std::uint32_t t) {
    const TrianglePlaces places = to_.places(t);
    double uneven = 0;
    for (const glm::dvec3& p : places) uneven = std::max(uneven, std::abs(glm::dot(normal, p - start)));
    const Corners corners = seen(places, region);
    if (uneven > flat || !(sign(corners[0], corners[1], corners[2]) > 0)) return;
    region.uneven = std::max(region.uneven, uneven);
    region_of_[t] = number;
    region.middle += (places[0] + places[1] + places[2]) / 3.0;
    triangles.push_back(t);
  };
  take(from);
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (const std::uint32_t next : neighbours[triangles[i]])
      if (next != no_index && region_of_[next] == no_index) take(next);
  if (triangles.empty()) return;
  region.middle /= static_cast<double>(triangles.size());
  regions_.push_back(region);
  if (triangles.size() > 1) add_border(triangles, neighbours);
}

void FlatRegions::add_border(std::span<const std::uint32_t> triangles,
                             const std::vector<std::array<std::uint32_t, 3>>& neighbours) {
  Region& region = regions_.back();
  const auto x = static_cast<int>((region.dropped + 1) % 3), y = static_cast<int>((region.dropped + 2) % 3);
  region.begin = static_cast<std::uint32_t>(sides_.size());
  for (const std::uint32_t t : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t next = neighbours[t][i];
      if (next != no_index && region_of_[next] == region_of_[t]) continue;
      const TrianglePlaces places = to_.places(t);
      const glm::dvec3 &a = places[i], &b = places[(i + 1) % 3];
      sides_.push_back({glm::dvec2(a[x], a[y]), glm::dvec2(b[x], b[y])});
    }
  region.end = static_cast<std::uint32_t>(sides_.size());
  region.root = region.begin < region.end ? add_node(region.begin, region.end) : no_index;
}

std::uint32_t FlatRegions::add_node(std::uint32_t begin, std::uint32_t end) {
  glm::dvec2 lowest = sides_[begin][0], highest = lowest;
  for (std::uint32_t i = begin; i < end; ++i)
    for (const glm::dvec2& p : sides_[i]) lowest = glm::min(lowest, p), highest = glm::max(highest, p);
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({lowest, highest, begin, end});
  if (end - begin <= 4) return number;
  const int axis = highest.x - lowest.x < highest.y - lowest.y ? 1 : 0;
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(sides_.begin() + begin, sides_.begin() + middle, sides_.begin() + end,
                   [axis](const Side& a, const Side& b) { return a[0][axis] + a[1][axis] < b[0][axis] + b[1][axis]; });
  const std::uint32_t left = add_node(begin, middle), right = add_node(middle, end);
  nodes_[number].left = left;
  nodes_[number].right = right;
  return number;
}

bool FlatRegions::is_entered(const Region& region, const Corners& triangle) const {
  std::vector<std::uint32_t> stack;
  if (region.root != no_index) stack.push_back(region.root);
  while (!stack.empty()) {
    const Node& node = nodes_[stack.back()];
    stack.pop_back();
    if (is_apart(node.lowest, node.highest, triangle)) continue;
    if (node.left != no_index) {
      stack.push_back(node.left);
      stack.push_back(node.right);
      continue;
    }
    for (std::uint32_t i = node.begin; i < node.end; ++i)
      if (enters(sides_[i], triangle)) return true;
  }
  return false;
}

// No side of the border runs through the inside, and a place inside is covered: then every one is.
bool FlatRegions::holds(const Region& region, std::uint32_t number, const TrianglePlaces& places,
                        std::uint32_t hint) const {
  const Corners corners = seen(places, region);
  if (!(sign(corners[0], corners[1], corners[2]) != 0)) return false;
  Corners triangle = corners;
  if (sign(corners[0], corners[1], corners[2]) < 0) std::swap(triangle[1], triangle[2]);
  if (is_entered(region, triangle)) return false;
  const glm::dvec3 middle = (places[0] + places[1] + places[2]) / 3.0;
  const std::uint32_t below = to_.nearest(middle, hint).triangle;
  if (region_of_[below] != number) return false;
  const glm::dvec2 place = seen({middle, middle, middle}, region)[0];
  const Corners covering = seen(to_.places(below), region);
  for (std::size_t i = 0; i < 3; ++i)
    if (!(sign(triangle[i], triangle[(i + 1) % 3], place) > 0) || sign(covering[i], covering[(i + 1) % 3], place) < 0)
      return false;
  return true;
}

double FlatRegions::bound_of(const FarthestCell& cell) const {
  constexpr double unknown = std::numeric_limits<double>::infinity();
  const std::uint32_t number = region_of_[cell.near[0].triangle];
  if (number == no_index || regions_[number].root == no_index) return unknown;
  TrianglePlaces nearest;
  for (std::size_t i = 0; i < 3; ++i) {
    if (region_of_[cell.near[i].triangle] != number) return unknown;
    nearest[i] = cell.corners[i] - to_.way(cell.corners[i], cell.near[i].triangle);
  }
  const Region& region = regions_[number];
  // Seen along an axis that the normal leans to the most, two places near the plane are less than 1.75 times as far
  // apart as across it.
  const double uneven = region.uneven > 0 ? 3.5 * region.uneven + 0x1p-50 : 0;
  if (holds(region, number, nearest, cell.near[0].triangle))
    return std::max({cell.near[0].distance, cell.near[1].distance, cell.near[2].distance}) + uneven;
  // Rounding may put them outside of the border: tries a little towards the middle of the region, or of themselves.
  for (const glm::dvec3& middle : {region.middle, (nearest[0] + nearest[1] + nearest[2]) / 3.0}) {
    TrianglePlaces pulled;
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      pulled[i] = nearest[i] + pull * (middle - nearest[i]);
      most = std::max(most, glm::length(cell.corners[i] - pulled[i]));
    }
    if (holds(region, number, pulled, cell.near[0].triangle)) return most + uneven;
  }
  return unknown;
}

}  // namespace ryosen
