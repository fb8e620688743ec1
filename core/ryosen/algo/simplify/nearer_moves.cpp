#include "ryosen/algo/simplify/nearer_moves.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "ryosen/base/parallel.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen {

namespace {

// So strongly is a vertex held where samples leave it open, as along a flat part: more would take more steps, less lets
// it slide away from the shape that it stands for.
constexpr double held_share = 0.05;
// The same where values count fully, which would slide with it.
constexpr double held_share_of_values = 0.5;
// A step is so many times the way to where the samples at its faces would have it if its neighbours stayed; they follow
// as well.
constexpr double stride = 1.2;
// What the way from the surface to the input counts beside the way back, which alone lets spikes grow between samples.
constexpr double middles_share = 0.3;
// The square of a step that is less than this share of the squares of its edges is rounding.
constexpr double least_square = 1e-12;

class Moves {
 public:
  Moves(Edit& edit, CollapseSurface& surface, NearSamples& samples, const TriangleTree* input, DistanceGuard* guard)
      : mesh_(edit.mesh()),
        surface_(surface),
        samples_(samples),
        input_(input && !input->is_empty() ? input : nullptr),
        mover_(edit, surface, guard),
        held_share_(surface.values() ? std::clamp(surface.values()->weight() * held_share_of_values, held_share,
                                                  held_share_of_values)
                                     : held_share),
        number_(mesh_.vertex_slots(), no_index) {
    for (const Vertex v : live_vertices(mesh_)) {
      if (!surface_.is_amid_surface(v)) continue;
      number_[v.index] = static_cast<std::uint32_t>(movable_.size());
      movable_.push_back(v);
    }
    pulls_.resize(movable_.size());
    steps_.resize(movable_.size());
    if (input_) targets_.resize(mesh_.edge_slots());
  }

  // Where the middles of edges are to come: to the nearest places of the input.
  void aim() {
    if (!input_) return;
    for_each_part(mesh_.edge_slots(), threads_for(mesh_.edge_slots()),
                  [&](unsigned, std::uint32_t begin, std::uint32_t end) {
                    for (std::uint32_t i = begin; i < end; ++i)
                      if (mesh_.is_alive(Edge(i))) targets_[i] = target_of(Edge(i));
                  });
  }

  void step() {
    const auto count = static_cast<std::uint32_t>(movable_.size());
    std::fill(pulls_.begin(), pulls_.end(), Quadric());
    for_each_part(count, threads_for(std::size_t{count} * 16), [&](unsigned, std::uint32_t begin, std::uint32_t end) {
      for (const Face f : live_faces(mesh_)) pull_corners(f, begin, end);
      for (std::uint32_t i = begin; i < end; ++i) steps_[i] = step_of(movable_[i], pulls_[i]);
    });
    for (std::uint32_t i = 0; i < count; ++i) take(movable_[i], steps_[i]);
  }

  const NearerMoves& moves() const { return mover_.moves(); }

 private:
  glm::dvec3 target_of(Edge e) const {
    const glm::dvec3 middle = middle_of(halfedge(e));
    return is_finite(middle) ? middle - input_->way(middle, input_->nearest(middle).triangle) : middle;
  }
  glm::dvec3 middle_of(Halfedge h) const { return (surface_.place(mesh_.from(h)) + surface_.place(mesh_.to(h))) / 2.0; }

  // Pulls the corners of a face whose numbers are in the range: by its samples, as they share in their place on it, and
  // by the middles of its sides.
  void pull_corners(Face f, std::uint32_t begin, std::uint32_t end) {
    const Halfedge h = mesh_.halfedge(f);
    const std::array<Halfedge, 3> sides{h, mesh_.next(h), mesh_.prev(h)};
    if (mesh_.next(sides[1]) != sides[2]) return;
    std::array<glm::dvec3, 3> corners{};
    std::array<Quadric*, 3> pulls{};
    for (int k = 0; k < 3; ++k) {
      const Vertex corner = mesh_.from(sides[k]);
      corners[k] = surface_.place(corner);
      if (const std::uint32_t i = number_[corner.index]; begin <= i && i < end) pulls[k] = &pulls_[i];
    }
    if (!pulls[0] && !pulls[1] && !pulls[2]) return;
    const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double twice_area = glm::length(normal);
    if (!(twice_area > 0)) return;
    // Each corner is pulled by its weight, along a way that is not 0.
    const auto pull = [&](const glm::dvec3& direction, const glm::dvec3& way, const glm::dvec3& weights) {
      for (int k = 0; k < 3; ++k)
        if (pulls[k] && weights[k] > 0) pulls[k]->add_plane(direction, way, weights[k]);
    };
    samples_.for_each(f, [&](std::uint32_t i) {
      const auto [place, area] = samples_.sample(i);
      const NearestPlace near = nearest_on_triangle(corners, place);
      if (near.distance > rounding)
        pull((place - near.place) / near.distance, place - near.place, area * near.barycentric);
      else
        pull(normal / twice_area, glm::dvec3(0.0), area * near.barycentric);
    });
    if (!input_) return;
    for (int k = 0; k < 3; ++k) {
      const glm::dvec3 way = targets_[edge(sides[k]).index] - middle_of(sides[k]);
      glm::dvec3 weights(twice_area / 12 * middles_share);
      weights[(k + 2) % 3] = 0;
      if (const double length = glm::length(way); length > rounding) pull(way / length, way, weights);
    }
  }

  // To the lowest place in the planes of the pulls, as seen from the vertex.
  glm::dvec3 step_of(Vertex v, const Quadric& pulls) const {
    double lengths = 0;
    for (const Halfedge h : outgoing(mesh_, v)) {
      const glm::dvec3 along = surface_.place(mesh_.to(h)) - surface_.place(v);
      lengths += glm::dot(along, along);
    }
    const glm::dvec3 step = stride * pulls.lowest(glm::dvec3(0.0), held_share_);
    return glm::dot(step, step) > least_square * lengths ? step : glm::dvec3(0.0);
  }

  // The squared distances of the samples at the faces around a vertex at a place, and of the middles of its edges, by
  // their areas.
  double squares_around(Vertex v, const glm::dvec3& p) const {
    double sum = 0;
    for (const Halfedge corner : outgoing(mesh_, v)) {
      const Halfedge next = mesh_.next(corner), prev = mesh_.prev(corner);
      if (mesh_.next(next) != prev) continue;
      const glm::dvec3 &x = surface_.place(mesh_.from(next)), &y = surface_.place(mesh_.from(prev));
      samples_.for_each(mesh_.face(corner), [&](std::uint32_t i) {
        const auto [place, area] = samples_.sample(i);
        sum += area * square_from_triangle({p, x, y}, place);
      });
      const double share = glm::length(glm::cross(x - p, y - p)) / 6 * middles_share;
      for (const glm::dvec3& middle : {(p + x) / 2.0, (p + y) / 2.0})
        if (is_finite(middle)) {
          const double distance = input_->nearest(middle).distance;
          sum += share * distance * distance;
        }
    }
    return sum;
  }

  void take(Vertex v, const glm::dvec3& step) {
    if (step == glm::dvec3(0.0)) return;
    const glm::dvec3 position = surface_.scale().restored(surface_.place(v) + step);
    if (!mover_.may_move(v, position)) return;
    if (!input_ || squares_around(v, surface_.scale().scaled(position)) < squares_around(v, surface_.place(v)))
      mover_.move(v, position);
  }

  static constexpr double rounding = 1e-12;

  const Mesh& mesh_;
  const CollapseSurface& surface_;
  NearSamples& samples_;
  const TriangleTree* input_;
  VertexMover mover_;
  double held_share_;
  std::vector<Vertex> movable_;
  std::vector<std::uint32_t> number_;  // by vertex, in movable_; none of one that is not to move
  std::vector<Quadric> pulls_;         // by number
  std::vector<glm::dvec3> steps_;      // by number
  std::vector<glm::dvec3> targets_;    // by edge, of its middle; none without a tree
};

}  // namespace

NearerMoves move_nearer(Edit& edit, CollapseSurface& surface, NearSamples& samples, std::span<const Vertex> merged,
                        const TriangleTree* input, DistanceGuard* guard, Progress& progress) {
  const int rounds = input ? 4 : 1, steps = input ? 3 : 2;
  Moves moves(edit, surface, samples, input, guard);
  for (int round = 0; round < rounds; ++round) {
    if (!samples.assign(merged, input != nullptr, progress)) break;
    moves.aim();
    for (int step = 0; step < steps; ++step) moves.step();
  }
  return moves.moves();
}

}  // namespace ryosen
