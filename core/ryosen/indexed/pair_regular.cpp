#include "ryosen/indexed/pair_regular.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <numeric>
#include <span>
#include <tuple>

#include "ryosen/base/parallel.h"

namespace ryosen {

namespace {

using Point = RegularPairing::Point;
using Sides = RegularPairing::Sides;

// The same as for_each_side(). For triangles, prefetches the entries of `fetched` for points that come soon; null for
// none.
template <class Visit>
void for_each_side_ahead(const IndexedMesh& source, bool triangles, std::uint32_t begin, std::uint32_t end, Visit visit,
                         const Point* fetched) {
  const std::uint32_t* corners = source.corners.data();
  if (triangles) {
    const auto visit_face = [&](std::uint32_t c) {
      const std::uint32_t p = corners[c], q = corners[c + 1], r = corners[c + 2];
      visit(c, p, q);
      visit(c + 1, q, r);
      visit(c + 2, r, p);
    };
    if (!fetched)
      for (std::uint32_t c = 3 * begin; c < 3 * end; c += 3) visit_face(c);
    constexpr std::size_t ahead = 48;
    const std::size_t last = source.corners.size() - 1;
    for (std::uint32_t c = 3 * begin; fetched && c < 3 * end; c += 3) {
      for (std::size_t k = c + ahead; k < c + ahead + 3; ++k)
        __builtin_prefetch(fetched + corners[std::min(k, last)], 1);
      visit_face(c);
    }
    return;
  }
  for_each_side(source, begin, end, visit);
}

// Whether consecutive faces mostly use distant points, so that each causes cache misses (by sampling).
bool is_scattered(const IndexedMesh& source, bool triangles) {
  constexpr std::size_t samples = 256;
  constexpr std::uint32_t far = 1u << 16;
  if (!triangles || source.corners.size() < 6 * samples) return false;
  std::size_t scattered = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    const std::size_t c = 3 * (i * (source.face_count() - 1) / samples);
    const std::uint32_t here = source.corners[c], next = source.corners[c + 3];
    scattered += std::max(here, next) - std::min(here, next) > far;
  }
  return 2 * scattered > samples;
}

class Pairer {
 public:
  Pairer(const IndexedMesh& source, unsigned threads)
      : source_(source),
        threads_(threads),
        faces_(static_cast<std::uint32_t>(source.face_count())),
        triangles_(is_all_triangles(source)),
        scattered_(is_scattered(source, triangles_)),
        cursors_(threads),
        down_only_(threads) {}

  std::optional<RegularPairing> pair() {
    count();
    prefix_sums();
    fill_buckets();
    match();
    for (const auto& corners : down_only_) out_.down_only.insert(out_.down_only.end(), corners.begin(), corners.end());
    if (!is_regular()) return std::nullopt;
    for (std::size_t i = 0; i < out_.down_only.size(); ++i)
      out_.halfedge[out_.down_only[i]] = halfedge(Edge(out_.up_edges + i), 1);
    out_.points = std::move(cursors_.back());
    return std::move(out_);
  }

 private:
  template <class Work>
  void with_sides(Work work) {
    for_each_part(faces_, threads_, [&](unsigned t, std::uint32_t begin, std::uint32_t end) {
      work(t, [&](auto visit, const Point* fetched) {
        for_each_side_ahead(source_, triangles_, begin, end, visit, scattered_ ? fetched : nullptr);
      });
    });
  }

  // Counts the up sides at each point, per thread's part of the faces.
  void count() {
    for (auto& cursors : cursors_) cursors.resize(source_.positions.size());
    with_sides([&](unsigned t, auto for_each) {
      Point* points = cursors_[t].data();
      std::fill_n(points, cursors_[t].size(), Point());
      for_each(
          [&](std::uint32_t corner, std::uint32_t a, std::uint32_t b) {
            points[a].edge_end += a < b;
            points[a].last_corner = corner;
          },
          points);
    });
  }

  // Prefix sums: counts become the offsets where each thread starts writing, in face order.
  void prefix_sums() {
    std::uint32_t sum = 0;
    for (std::size_t p = 0; p < source_.positions.size(); ++p) {
      std::uint32_t last = no_index;
      const std::uint32_t begin = sum;
      for (auto& cursors : cursors_) {
        const std::uint32_t count = cursors[p].edge_end;
        cursors[p].edge_end = sum;
        sum += count;
        if (cursors[p].last_corner != no_index) last = cursors[p].last_corner;
      }
      cursors_.back()[p].last_corner = last;
      if (sum - begin > many) high_valence_.push_back(static_cast<std::uint32_t>(p));
    }
    out_.up_edges = sum;
  }

  // Writes each up side to the bucket of its smaller point. Branchless: a down side writes to a dummy slot at the end.
  void fill_buckets() {
    out_.sides.resize(out_.up_edges + look_ahead);
    out_.halfedge.resize(source_.corners.size());
    with_sides([&](unsigned t, auto for_each) {
      Point* points = cursors_[t].data();
      Sides* sides = out_.sides.data();
      Halfedge* halfedges = out_.halfedge.data();
      const std::uint32_t dummy = out_.up_edges + t;
      for_each(
          [&](std::uint32_t corner, std::uint32_t a, std::uint32_t b) {
            const bool up = a < b;
            const std::uint32_t place = points[a].edge_end;
            points[a].edge_end = place + up;
            sides[up ? place : dummy] = {b, corner, no_index};
            halfedges[corner] = halfedge(Edge(place));
          },
          points);
    });
    std::fill_n(out_.sides.begin() + out_.up_edges, look_ahead, Sides{no_index, no_index, no_index});
    for (std::uint32_t p : high_valence_) sort_edges_of(p);
  }

  // The edges in the bucket of a point.
  std::pair<std::uint32_t, std::uint32_t> edges_of(std::uint32_t point) const {
    const Point* points = cursors_.back().data();
    return {point == 0 ? 0 : points[point - 1].edge_end, points[point].edge_end};
  }

  void sort_edges_of(std::uint32_t point) {
    const auto [begin, end] = edges_of(point);
    std::sort(out_.sides.begin() + begin, out_.sides.begin() + end,
              [](const Sides& x, const Sides& y) { return x.larger != y.larger ? x.larger < y.larger : x.up < y.up; });
    for (std::uint32_t e = begin; e < end; ++e) out_.halfedge[out_.sides[e].up] = halfedge(Edge(e));
  }

  // The edge to `larger` in the bucket begin .. end of the smaller point, or no_index.
  std::uint32_t find(std::uint32_t begin, std::uint32_t end, std::uint32_t larger) const {
    const Sides* at = out_.sides.data() + begin;
    unsigned found = 1u << look_ahead;
    for (unsigned i = 0; i < look_ahead; ++i) found |= static_cast<unsigned>(at[i].larger == larger) << i;
    const std::uint32_t place = begin + static_cast<std::uint32_t>(std::countr_zero(found));
    if (place >= end) return no_index;
    return place < begin + look_ahead ? place : find_among(place, end, larger);
  }

  std::uint32_t find_among(std::uint32_t begin, std::uint32_t end, std::uint32_t larger) const {
    const Sides *first = out_.sides.data() + begin, *last = out_.sides.data() + end;
    const auto is_smaller = [](const Sides& sides, std::uint32_t point) { return sides.larger < point; };
    const auto is_it = [&](const Sides& sides) { return sides.larger == larger; };
    const Sides* found =
        end - begin > many ? std::lower_bound(first, last, larger, is_smaller) : std::find_if(first, last, is_it);
    return found != last && is_it(*found) ? static_cast<std::uint32_t>(found - out_.sides.data()) : no_index;
  }

  // A down side whose edge is looked up.
  struct DownSide {
    std::uint32_t smaller, larger, corner, begin, end;
  };

  // Finds the edges of all down sides, in batches with prefetch, so that their cache misses overlap.
  void match() {
    with_sides([&](unsigned t, auto for_each) {
      std::array<DownSide, 256> batch;
      std::size_t count = 0;
      for_each(
          [&](std::uint32_t corner, std::uint32_t a, std::uint32_t b) {
            batch[count] = {b, a, corner, 0, 0};
            count += a > b;
            if (count < batch.size()) return;
            match_batch(batch, down_only_[t]);
            count = 0;
          },
          nullptr);
      match_batch(std::span(batch).first(count), down_only_[t]);
    });
  }

  void match_batch(std::span<DownSide> batch, std::vector<std::uint32_t>& down_only) {
    const Point* points = cursors_.back().data();
    Sides* sides = out_.sides.data();
    for (const DownSide& s : batch) __builtin_prefetch(points + s.smaller);
    for (DownSide& s : batch) {
      std::tie(s.begin, s.end) = edges_of(s.smaller);
      __builtin_prefetch(sides + s.begin, 1);
      __builtin_prefetch(sides + s.begin + look_ahead - 1, 1);
    }
    for (const DownSide& s : batch) {
      const std::uint32_t e = find(s.begin, s.end, s.larger);
      if (e == no_index) {
        down_only.push_back(s.corner);
        continue;
      }
      out_.halfedge[s.corner] = halfedge(Edge(e), 1);
      // If two sides claim the same half either may win; is_regular() detects it.
      std::atomic_ref(sides[e].down).store(s.corner, std::memory_order_relaxed);
    }
  }

  // Every matched down side has a half of its own, and no two up sides, nor two unmatched down sides, have the same two
  // points.
  bool is_regular() const {
    std::vector<std::size_t> filled(threads_, 0);
    std::atomic<bool> twice = false;
    for_each_part(static_cast<std::uint32_t>(source_.positions.size()), threads_,
                  [&](unsigned t, std::uint32_t begin, std::uint32_t end) {
                    std::size_t count = 0;
                    for (std::uint32_t p = begin; p < end; ++p) {
                      const auto [first, last] = edges_of(p);
                      for (std::uint32_t e = first; e < last; ++e) {
                        if (out_.sides[e].down != no_index)
                          ++count;
                        else if (has_duplicate(e, first, last))
                          twice = true;
                      }
                    }
                    filled[t] = count;
                  });
    const std::size_t found = std::accumulate(filled.begin(), filled.end(), std::size_t{0});
    return !twice && out_.up_edges + found + out_.down_only.size() == source_.corners.size() &&
           are_distinct(out_.down_only);
  }

  // Whether another edge of the bucket has the same two points. Of several equal ones only the first is ever matched.
  bool has_duplicate(std::uint32_t e, std::uint32_t first, std::uint32_t last) const {
    const std::uint32_t larger = out_.sides[e].larger;
    if (last - first > many)
      return (e > first && out_.sides[e - 1].larger == larger) || (e + 1 < last && out_.sides[e + 1].larger == larger);
    for (std::uint32_t other = first; other < last; ++other)
      if (other != e && out_.sides[other].larger == larger) return true;
    return false;
  }

  bool are_distinct(const std::vector<std::uint32_t>& down_only) const {
    if (down_only.empty()) return true;
    std::vector<std::uint64_t> pairs;
    pairs.reserve(down_only.size());
    for (std::uint32_t c : down_only) {
      std::uint32_t next = c % 3 == 2 ? c - 2 : c + 1;
      if (!triangles_) {
        const auto after = std::upper_bound(source_.face_offsets.begin(), source_.face_offsets.end(), c);
        next = c + 1 < *after ? c + 1 : *(after - 1);
      }
      pairs.push_back(std::uint64_t{source_.corners[c]} << 32 | source_.corners[next]);
    }
    std::sort(pairs.begin(), pairs.end());
    return std::adjacent_find(pairs.begin(), pairs.end()) == pairs.end();
  }

  // Edges of a bucket that are compared unconditionally; also the number of dummy slots after the last edge, one per
  // thread.
  static constexpr unsigned look_ahead = 4;
  // Larger buckets are sorted by larger point, which avoids quadratic cost at points of high valence.
  static constexpr std::uint32_t many = 32;

  const IndexedMesh& source_;
  const unsigned threads_;
  const std::uint32_t faces_;
  const bool triangles_, scattered_;
  std::vector<UnwrittenVector<Point>> cursors_;
  std::vector<std::uint32_t> high_valence_;  // points with more than `many` edges
  std::vector<std::vector<std::uint32_t>> down_only_;
  RegularPairing out_;
};

}  // namespace

bool is_all_triangles(const IndexedMesh& source) {
  if (source.corners.size() != 3 * source.face_count()) return false;
  std::uint32_t difference = 0;
  for (std::uint32_t f = 0; f < source.face_offsets.size(); ++f) difference |= source.face_offsets[f] ^ (3 * f);
  return difference == 0;
}

std::optional<RegularPairing> pair_regular(const IndexedMesh& source, unsigned threads) {
  return Pairer(source, threads).pair();
}

}  // namespace ryosen
