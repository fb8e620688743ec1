#include "ryosen/algo/smooth/smooth.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "ryosen/algo/smooth/boundary_slide.h"
#include "ryosen/algo/smooth/implicit_step.h"
#include "ryosen/algo/smooth/keep_volume.h"
#include "ryosen/algo/unit_scale.h"
#include "ryosen/base/parallel.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"

namespace ryosen::smooth {

namespace {

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
    if (options_.keeps_volume) {
      const KeptVolume kept = keep_volume(mesh_, scale_, shares_, start, places_);
      result.kept_parts = kept.parts;
      result.open_parts = kept.open_parts;
      result.failed_parts = kept.failed_parts;
    }
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
                            is_finite(mesh_.position(v)) && !ends_a_wire_or_fan(v);
      if (!is_moved) shares_[i] = 0;
      if (shares_[i] == 0 || !mesh_.is_boundary(v) || options_.boundary == BoundaryRule::free) continue;
      if (options_.boundary == BoundaryRule::sliding) add_sliding(v);
      shares_[i] = 0;
    }
    slide_.emplace(std::move(sliding_), places_);
  }

  bool ends_a_wire_or_fan(Vertex v) const {
    if (!mesh_.is_boundary(v)) return false;
    std::uint32_t gaps = 0;
    for (const Halfedge h : outgoing(mesh_, v)) {
      if (mesh_.is_wire(edge(h))) return true;
      gaps += mesh_.is_outside(h) ? 1u : 0u;
    }
    return gaps > 1;
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
