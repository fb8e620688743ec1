#include "ryosen/algo/simplify/nearer_moves.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "ryosen/base/parallel.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen {

namespace {

// So strongly is a vertex held where samples leave it open, as along a flat part: more would take more steps, less lets
// it slide away from the shape that it stands for.
constexpr double held_share = 0.05;
// A step is so many times the way to where the samples at its faces would have it if its neighbours stayed; they follow
// as well.
constexpr double stride = 1.2;
// What the way from the surface to the input counts beside the way back, which alone lets spikes grow between samples.
constexpr double middles_share = 0.3;
// The square of a step that is less than this share of the squares of its edges is rounding.
constexpr double least_square = 1e-12;

class Mover {
 public:
  Mover(Edit& edit, CollapseSurface& surface, NearSamples& samples, const TriangleTree* input)
      : edit_(edit),
        mesh_(edit.mesh()),
        surface_(surface),
        samples_(samples),
        input_(input && !input->is_empty() ? input : nullptr),
        steps_(mesh_.vertex_slots()) {
    for (const Vertex v : live_vertices(mesh_))
      if (surface_.is_amid_surface(v)) movable_.push_back(v);
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
    for_each_part(count, threads_for(std::size_t{count} * 16), [&](unsigned, std::uint32_t begin, std::uint32_t end) {
      for (std::uint32_t i = begin; i < end; ++i) steps_[movable_[i].index] = step_of(movable_[i]);
    });
    for (const Vertex v : movable_) take(v, steps_[v.index]);
  }

  const NearerMoves& moves() const { return moves_; }

 private:
  glm::dvec3 target_of(Edge e) const {
    const glm::dvec3 middle = middle_of(halfedge(e));
    return is_finite(middle) ? middle - input_->way(middle, input_->nearest(middle).triangle) : middle;
  }
  glm::dvec3 middle_of(Halfedge h) const { return (surface_.place(mesh_.from(h)) + surface_.place(mesh_.to(h))) / 2.0; }

  // The lowest place in the planes of the pulls, as seen from the vertex.
  glm::dvec3 step_of(Vertex v) const {
    Quadric pulls;
    const glm::dvec3& here = surface_.place(v);
    double lengths = 0;
    const auto pull = [&](const glm::dvec3& way, double weight) {
      if (const double length = glm::length(way); length > 0) pulls.add_plane(way / length, way, weight);
    };
    for (const Halfedge corner : outgoing(mesh_, v)) {
      const Halfedge next = mesh_.next(corner), prev = mesh_.prev(corner);
      if (mesh_.next(next) != prev) continue;
      const glm::dvec3 &x = surface_.place(mesh_.from(next)), &y = surface_.place(mesh_.from(prev));
      const glm::dvec3 normal = glm::cross(x - here, y - here);
      const double twice_area = glm::length(normal);
      lengths += glm::dot(x - here, x - here);
      if (!(twice_area > 0)) continue;
      const Primitive triangle = Primitive::triangle(v.index, mesh_.from(next).index, mesh_.from(prev).index, 0);
      samples_.for_each(mesh_.face(corner), [&](std::uint32_t i) {
        const auto [place, area] = samples_.sample(i);
        const NearestPlace near = samples_.nearest(triangle, place);
        const double weight = area * near.barycentric.x;
        if (!(weight > 0)) return;
        if (near.distance > rounding)
          pull(place - near.place, weight);
        else
          pulls.add_plane(normal / twice_area, glm::dvec3(0.0), weight);
      });
      if (!input_) continue;
      for (const Halfedge side : {corner, prev})
        if (const glm::dvec3 way = targets_[edge(side).index] - middle_of(side); glm::length(way) > rounding)
          pull(way, twice_area / 12 * middles_share);
    }
    const glm::dvec3 step = stride * pulls.lowest(glm::dvec3(0.0), held_share);
    return glm::dot(step, step) > least_square * lengths ? step : glm::dvec3(0.0);
  }

  // The squared distances of the samples at the faces around a vertex, and of the middles of its edges, by their areas.
  double squares_around(Vertex v) const {
    double sum = 0;
    const std::span<const glm::dvec3> places = samples_.places();
    for (const Halfedge corner : outgoing(mesh_, v)) {
      const Halfedge next = mesh_.next(corner), prev = mesh_.prev(corner);
      if (mesh_.next(next) != prev) continue;
      const Primitive triangle = Primitive::triangle(v.index, mesh_.from(next).index, mesh_.from(prev).index, 0);
      samples_.for_each(mesh_.face(corner), [&](std::uint32_t i) {
        const auto [place, area] = samples_.sample(i);
        const double distance = samples_.nearest(triangle, place).distance;
        sum += area * distance * distance;
      });
      const glm::dvec3 &p = surface_.place(v), &x = places[mesh_.from(next).index], &y = places[mesh_.from(prev).index];
      const double share = glm::length(glm::cross(x - p, y - p)) / 6 * middles_share;
      for (const glm::dvec3& middle : {(places[v.index] + x) / 2.0, (places[v.index] + y) / 2.0})
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
    const double error = surface_.error_of_move(v, position);
    if (!(error <= surface_.error_limit()) || surface_.move_spoils_face(v, position, Face()) ||
        surface_.move_tilts_face(v, position))
      return;
    if (input_) {
      const double was = squares_around(v);
      samples_.put(v, surface_.scale().scaled(position));
      if (!(squares_around(v) < was)) return samples_.put(v, surface_.place(v));
    }
    edit_.set_position(v, position);
    surface_.move(v, position);
    samples_.put(v, surface_.place(v));
    ++moves_.moves;
    moves_.error_max = std::max(moves_.error_max, error);
  }

  static constexpr double rounding = 1e-12;

  Edit& edit_;
  const Mesh& mesh_;
  CollapseSurface& surface_;
  NearSamples& samples_;
  const TriangleTree* input_;
  std::vector<Vertex> movable_;
  std::vector<glm::dvec3> steps_;    // by vertex
  std::vector<glm::dvec3> targets_;  // by edge, of its middle; none without a tree
  NearerMoves moves_;
};

}  // namespace

NearerMoves move_nearer(Edit& edit, CollapseSurface& surface, NearSamples& samples, std::span<const Vertex> hints,
                        const TriangleTree* input, Progress& progress) {
  const int rounds = input ? 4 : 1, steps = input ? 3 : 2;
  Mover mover(edit, surface, samples, input);
  for (int round = 0; round < rounds; ++round) {
    if (!samples.assign(hints, progress)) break;
    mover.aim();
    for (int step = 0; step < steps; ++step) mover.step();
  }
  return mover.moves();
}

}  // namespace ryosen
