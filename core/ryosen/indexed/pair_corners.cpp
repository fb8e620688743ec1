#include "ryosen/indexed/pair_corners.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "ryosen/base/parallel.h"
#include "ryosen/indexed/pair_regular.h"

namespace ryosen {

namespace {

// One side of a face, in the bucket of the smaller of its two points.
struct Side {
  std::uint32_t larger;
  std::uint32_t corner_and_direction;  // corner * 2 + (runs from the larger to the smaller point)

  std::uint32_t corner() const { return corner_and_direction >> 1u; }
  std::uint32_t direction() const { return corner_and_direction & 1u; }
  friend bool operator<(const Side& a, const Side& b) {
    return a.larger != b.larger ? a.larger < b.larger : a.corner_and_direction < b.corner_and_direction;
  }
};

template <class Counter>
void sort_bucket(Side* begin, Side* end, Counter& counter) {
  constexpr std::ptrdiff_t small = 24;
  const auto comes_first = [&](const Side& a, const Side& b) {
    counter.count();
    return a < b;
  };
  if (end - begin > small) {
    std::sort(begin, end, comes_first);
    return;
  }
  for (Side* i = begin + 1; i < end; ++i) {
    const Side side = *i;
    Side* place = i;
    for (; place > begin && comes_first(side, place[-1]); --place) *place = place[-1];
    *place = side;
  }
}

template <class Counter>
CornerPairing pair_by_buckets(const IndexedMesh& source, Counter& counter) {
  const std::size_t points = source.positions.size();
  const auto faces = static_cast<std::uint32_t>(source.face_count());
  std::vector<std::uint32_t> bucket_end(points + 1, 0);
  for_each_side(source, 0, faces,
                [&](std::uint32_t, std::uint32_t a, std::uint32_t b) { ++bucket_end[std::min(a, b) + 1]; });
  for (std::size_t p = 0; p < points; ++p) bucket_end[p + 1] += bucket_end[p];

  // Filling moves each bucket's start to its end, which is where the next one begins.
  std::vector<Side> sides(source.corners.size());
  for_each_side(source, 0, faces, [&](std::uint32_t corner, std::uint32_t a, std::uint32_t b) {
    const std::uint32_t reversed = a > b;
    sides[bucket_end[reversed ? b : a]++] = {reversed ? a : b, corner * 2 + reversed};
  });

  const auto is_same = [&](const Side& a, const Side& b) {
    counter.count();
    return a.larger == b.larger;
  };
  CornerPairing pairing;
  pairing.halfedge.resize(source.corners.size());
  std::uint32_t begin = 0;
  for (std::size_t p = 0; p < points; ++p) {
    const std::uint32_t end = bucket_end[p];
    if (end - begin > 1) sort_bucket(sides.data() + begin, sides.data() + end, counter);
    while (begin < end) {
      std::uint32_t last = begin + 1;
      while (last < end && is_same(sides[last], sides[begin])) ++last;
      const bool joined = last - begin == 2 && sides[begin].direction() != sides[begin + 1].direction();
      for (std::uint32_t i = begin; i < last; ++i) {
        pairing.halfedge[sides[i].corner()] = halfedge(Edge(pairing.edges), sides[i].direction());
        if (!joined) ++pairing.edges;
      }
      if (joined) ++pairing.edges;
      pairing.has_cuts |= !joined && last - begin > 1;
      begin = last;
    }
  }
  return pairing;
}

}  // namespace

CornerPairing pair_with_cuts(const IndexedMesh& source) {
  NotCounted none;
  return pair_by_buckets(source, none);
}

CornerPairing pair_counting(const IndexedMesh& source, Counted& counter) { return pair_by_buckets(source, counter); }

CornerPairing pair_corners(const IndexedMesh& source) {
  std::optional<RegularPairing> regular = pair_regular(source, threads_for(source.corners.size()));
  if (!regular) return pair_with_cuts(source);
  const std::uint32_t edges = regular->edges();
  return {std::move(regular->halfedge), edges, false};
}

}  // namespace ryosen
