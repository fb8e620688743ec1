#include "ryosen/analysis/measure/farthest.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "ryosen/analysis/measure/cut_cell.h"
#include "ryosen/analysis/measure/flat_regions.h"
#include "ryosen/base/parallel.h"

namespace ryosen {

namespace {

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
