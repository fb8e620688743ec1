#include "ryosen/analysis/measure/surface_samples.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "ryosen/base/parallel.h"

namespace ryosen {

namespace {

using Nearest = TriangleTree::Near;

// What one part of the pieces yields.
struct SampledPart {
  SampleSums sums;
  Farthest farthest;  // the bound is that of the cells that are not open
  std::vector<OpenSample> open;
};

class Sampler {
 public:
  Sampler(SurfaceSamples& found, const TriangleTree& from, const TriangleTree& to, const DistanceOptions& options,
          FarEnough enough, unsigned threads)
      : found_(found), from_(from), to_(to), options_(options), enough_(enough), threads_(threads) {}

  bool run(Progress& progress) {
    cut_into_pieces();
    return ask_points(progress) && sample(progress);
  }

 private:
  static constexpr std::uint32_t most_cells_at_once = 5;  // of a piece whose points are asked about together
  static constexpr std::uint32_t points_per_part = 2048, samples_per_part = 2048, parts_per_round = 32;
  static constexpr double share_of_points = 0.25;

  // Cells of about the same area each.
  void cut_into_pieces() {
    std::vector<double> areas(from_.size());
    for (std::uint32_t t = 0; t < from_.size(); ++t) found_.area += areas[t] = area_of(from_.places(t));
    const double of_cell = found_.area / static_cast<double>(options_.samples);
    found_.pieces.reserve(from_.size());
    part_begins_ = {0};
    std::uint64_t in_part = 0;
    for (std::uint32_t t = 0; t < from_.size(); ++t) {
      const double sides = found_.area > 0 ? std::clamp(std::round(std::sqrt(areas[t] / of_cell)), 1.0, 16384.0) : 1.0;
      const std::uint32_t parts = static_cast<std::uint32_t>(std::ceil(sides / most_cells));
      const std::uint32_t cells = static_cast<std::uint32_t>(std::ceil(sides / parts));
      for (std::uint32_t part = 0; part < parts * parts; ++part) {
        found_.pieces.push_back({t, parts, part, cells});
        in_part += std::uint64_t{cells} * cells;
        if (in_part < samples_per_part) continue;
        part_begins_.push_back(static_cast<std::uint32_t>(found_.pieces.size()));
        in_part = 0;
      }
    }
    if (in_part > 0) part_begins_.push_back(static_cast<std::uint32_t>(found_.pieces.size()));
  }

  // Calls work(part) for all parts below count, some at once, and tells of it in between.
  template <class Work>
  bool in_rounds(std::size_t count, double begin, double end, Progress& progress, const Work& work) const {
    for (std::size_t first = 0; first < count; first += parts_per_round) {
      const double share = begin + (end - begin) * static_cast<double>(first) / static_cast<double>(count);
      if (!progress.go_on(static_cast<std::size_t>(share * 1000), 1000)) return false;
      for_each_task(static_cast<unsigned>(std::min<std::size_t>(parts_per_round, count - first)), threads_,
                    [&](unsigned i) { work(first + i); });
    }
    return true;
  }

  // The distances at the corners of the triangles.
  bool ask_points(Progress& progress) {
    const auto points = static_cast<std::uint32_t>(from_.points().size());
    near_.resize(points);
    const std::uint32_t parts = (points + points_per_part - 1) / points_per_part;
    if (!in_rounds(parts, 0, share_of_points, progress, [&](std::size_t part) {
          const auto begin = static_cast<std::uint32_t>(part) * points_per_part;
          std::uint32_t hint = no_index;
          for (std::uint32_t i = begin; i < std::min(points, begin + points_per_part); ++i) {
            near_[i] = nearest_of(to_, from_.points()[i], hint);
            hint = near_[i].triangle;
          }
        }))
      return false;
    found_.farthest.place = from_.points()[0];
    for (std::uint32_t i = 0; i < points; ++i) found_.farthest.note(from_.points()[i], near_[i].distance);
    return true;
  }

  // What is nearest to the lattice points of a piece, line by line.
  void ask_lattice(const SampledPiece& piece, const TrianglePlaces& places, std::vector<Nearest>& lattice) const {
    lattice.clear();
    const auto& corners = from_.corners(piece.triangle);
    if (piece.parts == 1 && piece.cells == 1) {
      for (const std::uint32_t corner : corners) lattice.push_back(near_[corner]);
      return;
    }
    if (piece.parts == 1 && piece.cells <= most_cells_at_once) return ask_at_once(piece, places, lattice);
    for (std::uint32_t line = 0; line <= piece.cells; ++line)
      for (std::uint32_t along = 0; along <= line; ++along) {
        const std::uint32_t hint = along > 0  ? lattice.back().triangle
                                   : line > 0 ? lattice[lattice.size() - line].triangle
                                              : near_[corners[0]].triangle;
        if (piece.parts == 1 && is_corner(piece, line, along))
          lattice.push_back(near_[corners[line == 0 ? 0 : along == 0 ? 1 : 2]]);
        else
          lattice.push_back(nearest_of(to_, lattice_point(places, piece.cells, line, along), hint));
      }
  }

  // The points of a small piece lie near each other, and each near to what is nearest to one of its corners. The
  // corners themselves are known.
  void ask_at_once(const SampledPiece& piece, const TrianglePlaces& places, std::vector<Nearest>& lattice) const {
    const auto& corners = from_.corners(piece.triangle);
    constexpr std::size_t most = (most_cells_at_once + 1) * (most_cells_at_once + 2) / 2;
    std::array<glm::dvec3, most> points;
    std::array<Nearest, most> near;
    std::size_t count = 0;
    for (std::uint32_t line = 0; line <= piece.cells; ++line)
      for (std::uint32_t along = 0; along <= line; ++along) {
        const std::size_t nearer = 2 * line < piece.cells ? 0 : 2 * along < line ? 1 : 2;
        lattice.push_back(near_[corners[nearer]]);
        if (is_corner(piece, line, along)) continue;
        points[count] = lattice_point(places, piece.cells, line, along);
        near[count++] = {0, near_[corners[nearer]].triangle};
      }
    to_.nearest(std::span(points).first(count), std::span(near).first(count));
    std::size_t next = 0;
    for (std::uint32_t line = 0; line <= piece.cells; ++line)
      for (std::uint32_t along = 0; along <= line; ++along) {
        if (is_corner(piece, line, along)) continue;
        lattice[lattice_index(line, along)] = {without_rounding(near[next].distance), near[next].triangle};
        ++next;
      }
  }

  // Cells that are asked about together, since they lie near each other.
  struct SampleBlock {
    static constexpr std::size_t size = 16;
    struct Pending {
      std::uint32_t piece, index;
      double weight, bound;  // the bound is of the whole piece
      FarthestCell cell;
    };
    std::array<Pending, size> pending;
    std::array<glm::dvec3, size> middles;
    std::array<Nearest, size> near;
    std::size_t count = 0;
  };

  void sample_piece(std::uint32_t number, std::vector<Nearest>& lattice, SampleBlock& block, SampledPart& part) const {
    const SampledPiece& piece = found_.pieces[number];
    const TrianglePlaces places = places_of(from_, piece);
    ask_lattice(piece, places, lattice);
    const double weight = found_.area > 0 ? area_of(places) / (double(piece.cells) * piece.cells) : 1;
    const double bound = piece.cells > 1 ? bound_by_middle(places) : std::numeric_limits<double>::infinity();
    for_each_cell(piece, places, lattice, [&](std::uint32_t index, const FarthestCell& cell) {
      if (block.count == SampleBlock::size) finish(block, part);
      const auto nearer = std::min_element(cell.near.begin(), cell.near.end(),
                                           [](const Nearest& a, const Nearest& b) { return a.distance < b.distance; });
      block.middles[block.count] = (cell.corners[0] + cell.corners[1] + cell.corners[2]) / 3.0;
      block.near[block.count] = *nearer;
      block.pending[block.count++] = {number, index, weight, bound, cell};
    });
  }

  // A piece that lies along one triangle: so far from that which is nearest to its middle.
  double bound_by_middle(const TrianglePlaces& places) const {
    return bound_by((nearest_of(to_, (places[0] + places[1] + places[2]) / 3.0, no_index)).triangle, places);
  }
  double bound_by(std::uint32_t triangle, const TrianglePlaces& places) const {
    double bound = 0;
    for (const glm::dvec3& corner : places) bound = std::max(bound, without_rounding(to_.distance(corner, triangle)));
    return bound;
  }

  void finish(SampleBlock& block, SampledPart& part) const {
    to_.nearest(std::span(block.middles).first(block.count), std::span(block.near).first(block.count));
    for (std::size_t i = 0; i < block.count; ++i) {
      block.near[i].distance = without_rounding(block.near[i].distance);
      add_sample(block.pending[i], block.middles[i], block.near[i], part);
    }
    block.count = 0;
  }

  void add_sample(const SampleBlock::Pending& sample, const glm::dvec3& middle, const Nearest& near,
                  SampledPart& part) const {
    const auto add = [&](double weight, double distance) {
      part.sums.distance += weight * distance;
      part.sums.square += weight * distance * distance;
    };
    add(0.75 * sample.weight, near.distance);
    for (std::size_t i = 0; i < 3; ++i) {
      add(sample.weight / 12, sample.cell.near[i].distance);
      part.farthest.note(sample.cell.corners[i], sample.cell.near[i].distance);
    }
    part.farthest.note(middle, near.distance);
    part.sums.weight += sample.weight;
    ++part.sums.samples;
    const double wanted = enough_.from(part.farthest.distance);
    const double bound = sample.bound <= wanted ? sample.bound : quick_bound(sample.cell, middle, near, wanted);
    if (bound > wanted)
      part.open.push_back({sample.piece,
                           sample.index,
                           above(bound),
                           {sample.cell.near[0].triangle, sample.cell.near[1].triangle, sample.cell.near[2].triangle}});
    else
      part.farthest.bound = std::max(part.farthest.bound, bound);
  }

  static float above(double bound) {
    return std::nextafter(static_cast<float>(bound), std::numeric_limits<float>::infinity());
  }

  // By the way from the middle to the farthest corner where that is little enough, else by the nearest triangles.
  double quick_bound(const FarthestCell& cell, const glm::dvec3& middle, const Nearest& near, double wanted) const {
    double reach = 0;
    for (const glm::dvec3& corner : cell.corners) reach = std::max(reach, squared(corner - middle));
    const double by_reach = near.distance + std::sqrt(reach);
    if (by_reach <= wanted) return by_reach;
    const double by_middle = bound_by(near.triangle, cell.corners);
    if (by_middle <= wanted) return by_middle;
    return std::min({by_reach, by_middle, bound_of(to_, cell, wanted)});
  }

  bool sample(Progress& progress) {
    const std::size_t parts = part_begins_.size() - 1;
    std::vector<SampledPart> results(parts);
    if (!in_rounds(parts, share_of_points, share_of_samples, progress, [&](std::size_t i) {
          results[i].farthest.distance = found_.farthest.distance;
          std::vector<Nearest> lattice;
          SampleBlock block;
          for (std::uint32_t piece = part_begins_[i]; piece < part_begins_[i + 1]; ++piece)
            sample_piece(piece, lattice, block, results[i]);
          finish(block, results[i]);
        }))
      return false;
    for (const SampledPart& part : results) {
      found_.sums.weight += part.sums.weight;
      found_.sums.distance += part.sums.distance;
      found_.sums.square += part.sums.square;
      found_.sums.samples += part.sums.samples;
      found_.farthest.note(part.farthest.place, part.farthest.distance);
    }
    for (const SampledPart& part : results) {
      found_.farthest.bound = std::max(found_.farthest.bound, part.farthest.bound);
      for (const OpenSample& open : part.open)
        if (double(open.bound) > enough_.from(found_.farthest.distance))
          found_.open.push_back(open);
        else
          found_.farthest.bound = std::max(found_.farthest.bound, double(open.bound));
    }
    return true;
  }

  SurfaceSamples& found_;
  const TriangleTree& from_;
  const TriangleTree& to_;
  const DistanceOptions& options_;
  const FarEnough enough_;
  const unsigned threads_;
  std::vector<std::uint32_t> part_begins_;
  std::vector<Nearest> near_;  // to the points of `from_`
};

}  // namespace

FarthestCell SurfaceSamples::cell(const TriangleTree& from, const TriangleTree& to, const OpenSample& one) const {
  const SampledPiece& piece = pieces[one.piece];
  FarthestCell cell{subtriangle(places_of(from, piece), piece.cells, one.cell), {}};
  for (std::size_t i = 0; i < 3; ++i)
    cell.near[i] = {without_rounding(to.distance(cell.corners[i], one.near[i])), one.near[i]};
  return cell;
}

bool take_samples(SurfaceSamples& samples, const TriangleTree& from, const TriangleTree& to,
                  const DistanceOptions& options, FarEnough enough, unsigned threads, Progress& progress) {
  return Sampler(samples, from, to, options, enough, threads).run(progress);
}

}  // namespace ryosen
