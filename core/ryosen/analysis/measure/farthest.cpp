#include "ryosen/analysis/measure/farthest.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "ryosen/analysis/measure/flat_regions.h"
#include "ryosen/base/parallel.h"

namespace ryosen {

namespace {

// Parts of a triangle whose distance from a surface is known better.
struct CellParts {
  std::array<FarthestCell, 3> cells;
  std::size_t count = 0;
  // Corners that the cell did not have, and how far they are.
  std::array<glm::dvec3, 2> places;
  std::array<double, 2> distances;
  std::size_t new_places = 0;
};

constexpr double much = 1e-11;  // of coordinates of about 1: what is nearer to a plane is on it

using Near = TriangleTree::Near;
using Signs = std::array<double, 3>;  // of the corners: on which side of a plane, and how far from it

std::size_t longest_side(const TrianglePlaces& t) {
  std::size_t longest = 0;
  double length = -1;
  for (std::size_t i = 0; i < 3; ++i)
    if (const double square = squared(t[(i + 1) % 3] - t[i]); square > length) length = square, longest = i;
  return longest;
}

// The plane through a side of a triangle, at a right angle to it: positive on the side of the triangle.
Signs beside_side(const TrianglePlaces& t, std::size_t side, const TrianglePlaces& cell) {
  const glm::dvec3 way = t[(side + 1) % 3] - t[side];
  const glm::dvec3 inwards = glm::cross(glm::cross(way, t[(side + 2) % 3] - t[side]), way);
  const double length = glm::length(inwards);
  Signs found{};
  if (length > 0)
    for (std::size_t i = 0; i < 3; ++i) found[i] = glm::dot(inwards, cell[i] - t[side]) / length;
  return found;
}

// Cuts a cell through a side of a triangle that lies below one of its corners and ends before another, at a right angle
// to the triangle: so what lies along one triangle is parted from what does not, and where two surfaces lie along each
// other, cut in any way, no more parts come of it than there are pairs of triangles above each other. Where there is no
// such side the cell is halved.
class CellCutter {
 public:
  CellCutter(const TriangleTree& to, const FarthestCell& cell) : to_(to), cell_(cell) {}

  CellParts run() {
    if (const Signs by = best_plane(); by != Signs{})
      cut(by);
    else
      halve();
    return parts_;
  }

 private:
  // The plane that leaves most of the cell on either side; zeros where there is none.
  Signs best_plane() const {
    double best = much;
    Signs by{};
    for (std::size_t i = 0; i < 3; ++i) {
      if (cell_.is_repeated(i)) continue;
      const TrianglePlaces t = to_.places(cell_.near[i].triangle);
      for (std::size_t side = 0; side < 3; ++side) {
        const Signs beside = beside_side(t, side, cell_.corners);
        const auto [low, high] = std::minmax({beside[0], beside[1], beside[2]});
        if (beside[i] < -much || std::min(-low, high) <= best) continue;
        best = std::min(-low, high);
        by = beside;
      }
    }
    for (double& x : by)
      if (std::abs(x) <= much) x = 0;
    return by;
  }

  Near ask(const glm::dvec3& place, std::uint32_t hint) {
    const Near near = nearest_of(to_, place, hint);
    parts_.places[parts_.new_places] = place;
    parts_.distances[parts_.new_places++] = near.distance;
    return near;
  }

  void add(const TrianglePlaces& places, const std::array<Near, 3>& near) {
    parts_.cells[parts_.count++] = {places, near};
  }

  void halve() {
    const std::size_t i = longest_side(cell_.corners);
    cut_at(i, (i + 1) % 3, 0.5 * cell_.corners[i] + 0.5 * cell_.corners[(i + 1) % 3]);
  }
  // In two, from a place between two corners to the third.
  void cut_at(std::size_t i, std::size_t k, const glm::dvec3& place) {
    const Near near = ask(place, cell_.near[i].triangle);
    for (const std::size_t replaced : {k, i}) {
      FarthestCell part = cell_;
      part.corners[replaced] = place;
      part.near[replaced] = near;
      add(part.corners, part.near);
    }
  }

  void cut(const Signs& by) {
    const auto crossing = [&](std::size_t i, std::size_t k) {
      return cell_.corners[i] + by[i] / (by[i] - by[k]) * (cell_.corners[k] - cell_.corners[i]);
    };
    const auto& [corners, near] = cell_;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t k = (i + 1) % 3, l = (i + 2) % 3;
      if (by[i] == 0 && by[k] * by[l] < 0) return cut_at(k, l, crossing(k, l));
      // A corner that is alone on its side: a triangle there, and two on the other.
      if (!(by[i] * by[k] < 0 && by[i] * by[l] < 0)) continue;
      const glm::dvec3 p = crossing(i, k), q = crossing(i, l);
      const Near near_p = ask(p, near[i].triangle), near_q = ask(q, near[i].triangle);
      add({corners[i], p, q}, {near[i], near_p, near_q});
      add({p, corners[k], corners[l]}, {near_p, near[k], near[l]});
      add({p, corners[l], q}, {near_p, near[l], near_q});
      return;
    }
  }

  const TriangleTree& to_;
  const FarthestCell& cell_;
  CellParts parts_;
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
    const CellParts parts = CellCutter(to, here.cell).run();
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
