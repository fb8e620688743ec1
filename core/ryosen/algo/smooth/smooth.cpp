#include "ryosen/algo/smooth/smooth.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "ryosen/algo/features.h"
#include "ryosen/algo/unit_scale.h"
#include "ryosen/base/parallel.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"

namespace ryosen::smooth {

namespace {

constexpr std::size_t held = static_cast<std::size_t>(-1);

// Points that slide along the curve that a boundary was: each towards the middle of its neighbours, by the way on the
// curve.
//
//      held --- p --------- q --- held          the curve is the chain of edges between points that are held, or
//           t=0   ->   <-                        a whole loop; the length t from its beginning tells where a point is
class BoundarySlide {
 public:
  struct Point {
    std::uint32_t point, before, after;  // and its neighbours on the boundary
    double share;                        // of the way
  };

  // `places` as the curve is; each point is the neighbour of those that slide beside it. O(n log n).
  BoundarySlide(std::vector<Point> points, const Places& places) : points_(std::move(points)), at_(points_.size()) {
    std::vector<std::size_t> slot_of(places.size(), held);
    for (std::size_t i = 0; i < points_.size(); ++i) slot_of[points_[i].point] = i;
    std::vector<std::uint8_t> is_known(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (!is_known[i]) follow(i, is_known, slot_of, places);
  }

  // Moves them by a share of the way, those between which they lie being where they were. O(n log n).
  void step(double strength, Places& places) {
    for (const Curve& curve : curves_) {
      const std::size_t n = curve.points.size();
      const double length = curve.lengths.back();
      std::vector<double> moved(n);
      for (std::size_t k = 0; k < n; ++k) {
        const double here = at_[curve.points[k]];
        const double before = k > 0 ? at_[curve.points[k - 1]] : curve.is_loop ? at_[curve.points[n - 1]] - length : 0;
        const double after = k + 1 < n       ? at_[curve.points[k + 1]]
                             : curve.is_loop ? at_[curve.points[0]] + length
                                             : length;
        moved[k] = here + points_[curve.points[k]].share * strength * (0.5 * before + 0.5 * after - here);
      }
      for (std::size_t k = 0; k < n; ++k) {
        const std::size_t i = curve.points[k];
        if (moved[k] == at_[i]) continue;
        at_[i] = moved[k];
        places[points_[i].point] = place_at(curve, moved[k]);
      }
    }
  }

 private:
  struct Curve {
    std::vector<glm::dvec3> corners;
    std::vector<double> lengths;      // from the beginning, to each corner
    std::vector<std::size_t> points;  // in their order, without those that are held
    bool is_loop = false;
  };

  // The whole curve of a point.
  void follow(std::size_t first, std::vector<std::uint8_t>& is_known, const std::vector<std::size_t>& slot_of,
              const Places& places) {
    Curve& curve = curves_.emplace_back();
    std::size_t begin = first;
    while (slot_of[points_[begin].before] != held && !curve.is_loop) {
      begin = slot_of[points_[begin].before];
      curve.is_loop = begin == first;
    }
    const auto add = [&](std::uint32_t point) {
      const glm::dvec3& place = places[point];
      curve.lengths.push_back(
          curve.corners.empty() ? 0 : curve.lengths.back() + glm::distance(curve.corners.back(), place));
      curve.corners.push_back(place);
    };
    if (!curve.is_loop) add(points_[begin].before);
    for (std::size_t i = begin; i != held && !is_known[i]; i = slot_of[points_[i].after]) {
      is_known[i] = 1;
      curve.points.push_back(i);
      add(points_[i].point);
      at_[i] = curve.lengths.back();
    }
    add(points_[curve.points.back()].after);
  }

  glm::dvec3 place_at(const Curve& curve, double t) const {
    const double length = curve.lengths.back();
    if (curve.is_loop) t -= t >= length ? length : t < 0 ? -length : 0;
    const auto next = std::upper_bound(curve.lengths.begin() + 1, curve.lengths.end() - 1, t);
    const std::size_t i = static_cast<std::size_t>(next - curve.lengths.begin());
    const double before = curve.lengths[i - 1], way = curve.lengths[i] - before;
    const glm::dvec3 &a = curve.corners[i - 1], &b = curve.corners[i];
    return way > 0 ? a + std::clamp((t - before) / way, 0.0, 1.0) * (b - a) : a;
  }

  std::vector<Point> points_;
  std::vector<double> at_;  // by point
  std::vector<Curve> curves_;
};

constexpr std::size_t most_rounds = 2000;

double dot(const Places& a, const Places& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += glm::dot(a[i], b[i]);
  return sum;
}

// The system on the points that move; the others are 0 in every vector, or hold as constants.
class ImplicitSystem {
 public:
  ImplicitSystem(const Laplacian& laplacian, std::span<const double> strength)
      : laplacian_(laplacian), strength_(strength) {}

  bool moves(std::uint32_t i) const { return strength_[i] > 0 && laplacian_.sum(i) > 0; }
  double diagonal(std::uint32_t i) const { return laplacian_.sum(i) / strength_[i] + laplacian_.sum(i); }

  // What is left: the right side less the matrix times the places, with the constants.
  void residual(const Places& before, const Places& places, Places& out) const {
    for_each_point([&](std::uint32_t i) {
      out[i] = glm::dvec3(0);
      if (!moves(i)) return;
      out[i] = (laplacian_.sum(i) / strength_[i]) * (before[i] - places[i]);
      for (const Laplacian::Term& term : laplacian_.row(i)) out[i] += term.weight * (places[term.point] - places[i]);
    });
  }
  void times(const Places& x, Places& out) const {
    for_each_point([&](std::uint32_t i) {
      out[i] = glm::dvec3(0);
      if (!moves(i)) return;
      out[i] = diagonal(i) * x[i];
      for (const Laplacian::Term& term : laplacian_.row(i)) out[i] -= term.weight * x[term.point];
    });
  }
  void precondition(const Places& x, Places& out) const {
    for_each_point([&](std::uint32_t i) { out[i] = moves(i) ? x[i] / diagonal(i) : glm::dvec3(0); });
  }
  template <class Work>
  void for_each_point(const Work& work) const {
    const auto count = static_cast<std::uint32_t>(strength_.size());
    for_each_part(count, threads_for(count), [&](unsigned, std::uint32_t begin, std::uint32_t end) {
      for (std::uint32_t i = begin; i < end; ++i) work(i);
    });
  }

 private:
  const Laplacian& laplacian_;
  std::span<const double> strength_;
};

// One implicit step: replaces the places of the points with a positive strength s by those p' with
// (D / s + D - W) p' = D / s p, where W are the weights and D their sums by rows [Desbrun99]; it is stable for any
// strength. All others stay and hold. At most `most_rounds` of conjugate gradients, preconditioned by the diagonal, to
// a residual of 1e-12; sums are formed in one order, so that the result does not depend on threads. Cancelled: false,
// and places are as they were.
bool implicit_step(const Laplacian& laplacian, std::span<const double> strength, Places& places, Progress& progress) {
  const ImplicitSystem system(laplacian, strength);
  const std::size_t n = places.size();
  Places x = places, rest(n), scaled(n), direction(n), image(n);
  system.residual(places, x, rest);
  system.precondition(rest, direction);
  double size = dot(rest, direction);
  const double enough = size * 1e-24;
  for (std::size_t round = 0; round < most_rounds && size > enough && size > 0; ++round) {
    if (!progress.go_on()) return false;
    system.times(direction, image);
    const double bend = dot(direction, image);
    if (!(bend > 0)) break;
    const double t = size / bend;
    system.for_each_point([&](std::uint32_t i) {
      x[i] += t * direction[i];
      rest[i] -= t * image[i];
    });
    system.precondition(rest, scaled);
    const double next = dot(rest, scaled), ratio = next / size;
    system.for_each_point([&](std::uint32_t i) { direction[i] = scaled[i] + ratio * direction[i]; });
    size = next;
  }
  places = std::move(x);
  return true;
}

class Smoother {
 public:
  Smoother(const Mesh& mesh, const Options& options, std::vector<double> shares)
      : mesh_(mesh),
        options_(options),
        shares_(std::move(shares)),
        scale_(unit_scale(mesh.positions())),
        triangles_(triangles_of(mesh, scale_)),
        laplacian_(mesh, options.weights, triangles_) {
    places_.reserve(mesh.vertex_slots());
    for (const glm::dvec3& p : mesh.positions()) places_.push_back(p * scale_);
    hold_what_stays();
  }

  Smoothed run(Progress& progress) {
    Smoothed result;
    const Places start = places_;
    for (std::size_t step = 0; step < options_.steps; ++step) {
      if (progress.go_on(step, options_.steps) && take_step(progress)) continue;
      result.is_cancelled = true;
      return result;
    }
    if (options_.keeps_volume) result.volume = keep_volume(mesh_, scale_, shares_, start, places_);
    result.places = std::move(places_);
    for (std::uint32_t i = 0; i < result.places.size(); ++i) {
      const bool stays = result.places[i] == start[i] || !is_finite(result.places[i]);
      result.places[i] = stays ? mesh_.position(Vertex(i)) : result.places[i] / scale_;
    }
    return result;
  }

 private:
  void hold_what_stays() {
    for (std::uint32_t i = 0; i < mesh_.vertex_slots(); ++i) {
      const Vertex v(i);
      const bool is_moved = mesh_.is_alive(v) && !mesh_.is_isolated(v) && !has_copies(mesh_, v) &&
                            is_finite(mesh_.position(v)) && !ends_a_wire_or_fan(mesh_, v);
      if (!is_moved) shares_[i] = 0;
      if (shares_[i] == 0 || !mesh_.is_boundary(v) || options_.boundary == BoundaryRule::free) continue;
      if (options_.boundary == BoundaryRule::sliding) add_sliding(v);
      shares_[i] = 0;
    }
    slide_.emplace(std::move(sliding_), places_);
  }

  void add_sliding(Vertex v) {
    const Halfedge out = mesh_.halfedge(v);
    const std::uint32_t after = point(mesh_, mesh_.to(out)).index,
                        before = point(mesh_, mesh_.from(mesh_.prev(out))).index;
    const glm::dvec3 come = places_[v.index] - places_[before], go = places_[after] - places_[v.index];
    const double product = glm::dot(come, go), lengths = glm::length(come) * glm::length(go);
    // It bends by more than 45 degrees, or a neighbour is nowhere.
    if (!(product > 0) || !(product * product * 2 >= lengths * lengths)) return;
    sliding_.push_back({v.index, before, after, shares_[v.index]});
  }

  bool take_step(Progress& progress) {
    const double s = options_.strength;
    switch (options_.method) {
      case Method::laplace:
        explicit_step(s);
        return true;
      case Method::taubin:
        explicit_step(s);
        explicit_step(1 / (options_.pass_band - 1 / s));
        return true;
      case Method::implicit:
        break;
    }
    slide_->step(std::min(s, 1.0), places_);
    laplacian_.weigh(triangles_, places_);
    std::vector<double> strengths = shares_;
    for (double& share : strengths) share *= s;
    return implicit_step(laplacian_, strengths, places_, progress);
  }

  void explicit_step(double strength) {
    laplacian_.weigh(triangles_, places_);
    Places next = places_;
    const auto count = static_cast<std::uint32_t>(places_.size());
    for_each_part(count, threads_for(count), [&](unsigned, std::uint32_t begin, std::uint32_t end) {
      for (std::uint32_t i = begin; i < end; ++i) {
        if (shares_[i] == 0) continue;
        const glm::dvec3& here = places_[i];
        next[i] = here + (shares_[i] * strength) * (laplacian_.mean(i, places_, here) - here);
      }
    });
    slide_->step(strength, next);
    places_ = std::move(next);
  }

  const Mesh& mesh_;
  const Options& options_;
  std::vector<double> shares_;
  double scale_;
  std::vector<Triangle> triangles_;
  Laplacian laplacian_;
  Places places_;  // scaled
  std::vector<BoundarySlide::Point> sliding_;
  std::optional<BoundarySlide> slide_;
};

}  // namespace

Smoothed smoothed(const Mesh& mesh, const Options& options, std::vector<double> shares, Progress& progress) {
  Smoothed cancelled;
  cancelled.is_cancelled = true;
  if (!progress.go_on(0, options.steps)) return cancelled;
  return Smoother(mesh, options, std::move(shares)).run(progress);
}

}  // namespace ryosen::smooth
