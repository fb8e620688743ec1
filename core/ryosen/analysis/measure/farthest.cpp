#include "ryosen/analysis/measure/farthest.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "ryosen/analysis/box_tree.h"
#include "ryosen/analysis/measure/cell_bound.h"
#include "ryosen/base/parallel.h"
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
bool is_apart(const Box& box, const std::array<glm::dvec2, 3>& t) {
  const glm::dvec2 lowest(box.lowest), highest(box.highest);
  constexpr double rounding = 1e-14;  // of a product of coordinates of about 1
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec2 way = t[(i + 1) % 3] - t[i];
    const double x = (way.y < 0 ? highest.x : lowest.x) - t[i].x, y = (way.x > 0 ? highest.y : lowest.y) - t[i].y;
    if (way.x * y - way.y * x < -rounding) return true;
  }
  const glm::dvec2 low = glm::min(glm::min(t[0], t[1]), t[2]), high = glm::max(glm::max(t[0], t[1]), t[2]);
  return lowest.x >= high.x || lowest.y >= high.y || highest.x <= low.x || highest.y <= low.y;
}

// Flat parts of a surface, however they are cut into triangles: triangles that are joined by sides and lie in one
// plane. Where the triangle between the points that are nearest to the corners of a cell lies in one such region, no
// point of the cell is farther than the farthest corner: a cell above many triangles of one plane need not be cut by
// the sides of each, of which two discs cut in n thin triangles have n * n pairs.
class FlatRegions {
 public:
  // O(n log n). `to` must outlive it.
  explicit FlatRegions(const TriangleTree& to) : to_(to), region_of_(to.size(), no_index) {
    const Neighbours neighbours = find_neighbours();
    std::vector<Box> boxes;
    for (std::uint32_t t = 0; t < to.size(); ++t)
      if (region_of_[t] == no_index) grow(t, neighbours, boxes);
    borders_ = BoxTree(std::move(boxes));
  }

  // No point of the cell is farther than this; infinity where nothing is known. O(log n) where few sides of the border
  // of the region come near to the sides of the cell.
  double bound_of(const FarthestCell& cell) const {
    constexpr double unknown = std::numeric_limits<double>::infinity();
    const std::uint32_t number = region_of_[cell.near[0].triangle];
    if (number == no_index || !regions_[number].has_border) return unknown;
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
    // By rounding they may lie outside of the border: a little towards the middle of the region, or of themselves.
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

 private:
  using Neighbours = std::vector<std::array<std::uint32_t, 3>>;
  using Side = std::array<glm::dvec2, 2>;
  using Corners = std::array<glm::dvec2, 3>;
  struct Region {
    int dropped = 0;  // the axis along which it is seen
    double turn = 1;  // the sign of its triangles seen so
    glm::dvec3 middle{0.0};
    double uneven = 0;        // how far a corner is from the plane
    bool has_border = false;  // that is known: not of a triangle alone
  };

  // By side, from corner i on; none where a border is, or more than two meet.
  Neighbours find_neighbours() const {
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
    Neighbours neighbours(to_.size(), {no_index, no_index, no_index});
    for (std::size_t begin = 0, end = 0; begin < halves.size(); begin = end) {
      while (end < halves.size() && halves[end].key() == halves[begin].key()) ++end;
      if (end - begin != 2 || halves[begin].from == halves[begin + 1].from) continue;
      neighbours[halves[begin].triangle][halves[begin].side] = halves[begin + 1].triangle;
      neighbours[halves[begin + 1].triangle][halves[begin + 1].side] = halves[begin].triangle;
    }
    return neighbours;
  }

  Corners seen(const TrianglePlaces& places, const Region& region) const {
    Corners corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = seen_along(places[i], region.dropped);
    if (region.turn < 0) std::swap(corners[1], corners[2]);
    return corners;
  }

  // All triangles seen from one side turn the same way: so the number of them above a place changes at the border
  // alone.
  void grow(std::uint32_t from, const Neighbours& neighbours, std::vector<Box>& boxes) {
    glm::dvec3 normal = to_.area_normal(from);
    const double length = glm::length(normal);
    if (!(length > 0)) return;
    normal /= length;
    Region region;
    for (int axis = 1; axis < 3; ++axis)
      if (std::abs(normal[axis]) > std::abs(normal[region.dropped])) region.dropped = axis;
    region.turn = normal[region.dropped] < 0 ? -1 : 1;
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
    if (triangles.size() > 1) add_border(triangles, neighbours, boxes);
  }

  // Of the last region.
  void add_border(std::span<const std::uint32_t> triangles, const Neighbours& neighbours, std::vector<Box>& boxes) {
    Region& region = regions_.back();
    for (const std::uint32_t t : triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t next = neighbours[t][i];
        if (next != no_index && region_of_[next] == region_of_[t]) continue;
        const TrianglePlaces places = to_.places(t);
        const Side side{seen_along(places[i], region.dropped), seen_along(places[(i + 1) % 3], region.dropped)};
        region.has_border = true;
        sides_.push_back(side);
        Box& box = boxes.emplace_back();
        for (const glm::dvec2& p : side) box.add(glm::dvec3(p, regions_.size() - 1));
      }
  }

  // No side of the border runs through the inside, and a place inside is covered: then every one is.
  bool holds(const Region& region, std::uint32_t number, const TrianglePlaces& places, std::uint32_t hint) const {
    const Corners corners = seen(places, region);
    if (!(sign(corners[0], corners[1], corners[2]) != 0)) return false;
    Corners triangle = corners;
    if (sign(corners[0], corners[1], corners[2]) < 0) std::swap(triangle[1], triangle[2]);
    const auto may_enter = [&](const Box& box) {
      return box.lowest.z <= number && number <= box.highest.z && !is_apart(box, triangle);
    };
    if (!borders_.visit(may_enter, [&](std::uint32_t i) { return !enters(sides_[i], triangle); })) return false;
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

  const TriangleTree& to_;
  std::vector<std::uint32_t> region_of_;  // by triangle
  std::vector<Region> regions_;
  std::vector<Side> sides_;  // of all borders, each seen as its region is
  BoxTree borders_;          // of the sides; the third coordinate is the number of the region
};

struct OpenCell {
  FarthestCell cell;
  double bound;
};
bool is_nearer(const OpenCell& a, const OpenCell& b) { return a.bound < b.bound; }

// What comes of one cell after some steps.
struct Looked {
  Farthest farthest;
  std::vector<OpenCell> open;  // at first the cell
  std::uint32_t steps = 0;
};

double bound_of(const TriangleTree& to, const FlatRegions* regions, const FarthestCell& cell, double wanted) {
  const double bound = bound_of(to, cell, wanted);
  return bound > wanted && regions ? std::min(bound, regions->bound_of(cell)) : bound;
}

void look_through(Looked& one, const TriangleTree& to, const FlatRegions* regions, FarEnough enough,
                  std::uint32_t most_steps) {
  // It may have come from where regions were not known.
  if (regions) one.open.back().bound = std::min(one.open.back().bound, regions->bound_of(one.open.back().cell));
  while (!one.open.empty() && one.steps < most_steps) {
    const OpenCell here = one.open.back();
    one.open.pop_back();
    const double wanted = enough.from(one.farthest.distance);
    if (here.bound <= wanted) {
      one.farthest.bound = std::max(one.farthest.bound, here.bound);
      continue;
    }
    ++one.steps;
    const CellParts parts = cut_cell(to, here.cell);
    for (std::size_t i = 0; i < parts.new_places; ++i) one.farthest.note(parts.places[i], parts.distances[i]);
    const std::size_t first = one.open.size();
    for (std::size_t i = 0; i < parts.count; ++i)
      one.open.push_back({parts.cells[i], std::min(here.bound, bound_of(to, regions, parts.cells[i], wanted))});
    std::sort(one.open.begin() + static_cast<std::ptrdiff_t>(first), one.open.end(), is_nearer);
  }
}

class FarthestSearch {
 public:
  FarthestSearch(Farthest& farthest, const TriangleTree& to, const FarCells& cells, FarEnough enough)
      : farthest_(farthest), to_(to), cells_(cells), enough_(enough) {}

  bool run(std::uint64_t most_steps, unsigned threads, Progress& progress) {
    constexpr std::uint32_t steps_at_once = 256;
    for (std::size_t at_once = 64; most_steps > 0; at_once = std::min<std::size_t>(2 * at_once, 8192)) {
      if (!progress.go_on()) return false;
      std::vector<Looked> looked = next_ones(at_once);
      if (looked.empty()) break;
      const auto tasks = static_cast<unsigned>((looked.size() + 7) / 8);
      for_each_task(tasks, threads, [&](unsigned task) {
        for (std::size_t i = task * std::size_t{8}; i < std::min(looked.size(), (task + std::size_t{1}) * 8); ++i)
          look_through(looked[i], to_, regions_ ? &*regions_ : nullptr, enough_, steps_at_once);
      });
      for (const Looked& one : looked) {
        take(one);
        most_steps -= std::min<std::uint64_t>(most_steps, one.steps + 1);
        farthest_.cuts += one.steps;
      }
      // Worth their cost by then.
      if (!regions_ && farthest_.cuts > 4096 + 2 * std::uint64_t{to_.size()}) regions_.emplace(to_);
    }
    farthest_.bound = std::max({farthest_.bound, farthest_.distance, largest_bound()});
    return true;
  }

 private:
  double bound_of_next() const { return next_ < cells_.count ? cells_.bound(next_) : -1; }
  double bound_of_rest() const { return rest_.empty() ? -1 : rest_.front().bound; }
  double largest_bound() const { return std::max(bound_of_next(), bound_of_rest()); }

  // The farthest ones; none where all are near enough.
  std::vector<Looked> next_ones(std::size_t most) {
    std::vector<Looked> ones;
    const double wanted = enough_.from(farthest_.distance);
    while (ones.size() < most && largest_bound() > wanted) {
      Looked& one = ones.emplace_back();
      one.farthest.distance = farthest_.distance;
      if (bound_of_next() >= bound_of_rest()) {
        one.open.push_back({cells_.cell(next_), cells_.bound(next_)});
        ++next_;
      } else {
        std::pop_heap(rest_.begin(), rest_.end(), is_nearer);
        one.open.push_back(rest_.back());
        rest_.pop_back();
      }
      for (std::size_t i = 0; i < 3; ++i)
        one.farthest.note(one.open[0].cell.corners[i], one.open[0].cell.near[i].distance);
    }
    return ones;
  }

  void take(const Looked& one) {
    farthest_.bound = std::max(farthest_.bound, one.farthest.bound);
    farthest_.note(one.farthest.place, one.farthest.distance);
    for (const OpenCell& open : one.open) {
      rest_.push_back(open);
      std::push_heap(rest_.begin(), rest_.end(), is_nearer);
    }
  }

  Farthest& farthest_;
  const TriangleTree& to_;
  const FarCells& cells_;
  const FarEnough enough_;
  std::optional<FlatRegions> regions_;
  std::size_t next_ = 0;
  std::vector<OpenCell> rest_;  // of cells that took many steps; a heap, the farthest on top
};

}  // namespace

bool search_farthest(Farthest& farthest, const TriangleTree& to, const FarCells& cells, FarEnough enough,
                     std::uint64_t most_steps, unsigned threads, Progress& progress) {
  return FarthestSearch(farthest, to, cells, enough).run(most_steps, threads, progress);
}

}  // namespace ryosen
