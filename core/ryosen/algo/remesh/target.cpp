#include "ryosen/algo/remesh/target.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "ryosen/geometry/is_finite.h"
#include "ryosen/geometry/trees/primitive.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen::remesh {

namespace {

double length_for(double curvature, const SizeOptions& options) {
  const double square = curvature > 0 ? 6 * options.tolerance / curvature - 3 * options.tolerance * options.tolerance
                                      : std::numeric_limits<double>::infinity();
  return std::clamp(std::sqrt(std::max(0.0, square)), options.length / 8, options.length);
}

// Where the foot of the normal from a place lies in a triangle: the weights of the corners, times `sum`.
struct Foot {
  std::array<double, 3> weights;
  double sum, height;  // the height times the root of the sum

  Foot(const glm::dvec3& p, const Corners& c) {
    const glm::dvec3 ab = c[1] - c[0], ac = c[2] - c[0], ap = p - c[0], normal = glm::cross(ab, ac);
    sum = glm::dot(normal, normal);
    height = glm::dot(ap, normal);
    const double of_b = glm::dot(glm::cross(ap, ac), normal), of_c = glm::dot(glm::cross(ab, ap), normal);
    weights = {sum - (of_b + of_c), of_b, of_c};
  }
  bool is_inside() const { return weights[0] > 0 && weights[1] > 0 && weights[2] > 0; }
  bool is_within(double distance) const { return height * height <= distance * distance * sum; }
  // The side that it lies beyond, farthest in shares of the triangle.
  std::size_t side() const {
    const auto least = static_cast<std::size_t>(std::min_element(weights.begin(), weights.end()) - weights.begin());
    return (least + 1) % 3;
  }
};

}  // namespace

std::vector<double> largest_curvatures(const Mesh& mesh) {
  const std::uint32_t n = mesh.vertex_slots();
  std::vector<glm::dvec3> bends(n, glm::dvec3(0));
  std::vector<double> areas(n, 0), angles(n, 0), found(n, 0);
  for (const Face f : live_faces(mesh)) {
    const Halfedge start = mesh.halfedge(f);
    const double area = glm::length(area_normal(corners_of(mesh, start))) / 2;
    if (!(area > 0)) continue;
    for (const Halfedge h : loop(mesh, start)) {
      const Corners c = corners_of(mesh, h);
      const std::uint32_t at = mesh.from(h).index, a = mesh.to(h).index, b = mesh.from(mesh.prev(h)).index;
      const double weight = cotangent_at(c[0], c[1], c[2]) / 2;
      bends[a] += weight * (c[2] - c[1]);
      bends[b] += weight * (c[1] - c[2]);
      areas[at] += area / 3;
      angles[at] += std::atan2(2 * area, glm::dot(c[1] - c[0], c[2] - c[0]));
    }
  }
  for (const Vertex v : live_vertices(mesh)) {
    const std::uint32_t i = v.index;
    if (mesh.is_boundary(v) || !(areas[i] > 0)) continue;
    const double mean = glm::length(bends[i]) / (2 * areas[i]);
    const double gaussian = (2 * std::numbers::pi - angles[i]) / areas[i];
    found[i] = mean + std::sqrt(std::max(0.0, mean * mean - gaussian));
  }
  return found;
}

Sizing::Sizing(const Mesh& mesh, const SizeOptions& options) : options_(options) {
  if (!options.adaptive) return;
  for (const double curvature : largest_curvatures(mesh)) lengths_.push_back(length_for(curvature, options));
}

Target::Target(const Mesh& mesh, const Sizing& sizing) : sizing_(sizing) {
  std::vector<Primitive> triangles;
  triangles.reserve(mesh.live().faces);
  for (const Face f : live_faces(mesh)) {
    const Halfedge h = mesh.halfedge(f);
    const std::array corners{mesh.from(h), mesh.to(h), mesh.from(mesh.prev(h))};
    const bool is_there =
        std::all_of(corners.begin(), corners.end(), [&](Vertex v) { return is_finite(mesh.position(v)); });
    if (is_there)
      triangles.push_back(Primitive::triangle(corners[0].index, corners[1].index, corners[2].index, f.index));
  }
  tree_ = TriangleTree(mesh.positions(), triangles, 1);
  hints_.assign(mesh.vertex_slots(), no_index);
  for (std::uint32_t t = 0; t < tree_.size(); ++t)
    for (const Halfedge h : loop(mesh, mesh.halfedge(Face(tree_.owner(t))))) hints_[mesh.from(h).index] = t;
  find_neighbours(mesh);
  if (!sizing.is_adaptive()) return;
  point_lengths_.resize(tree_.points().size());
  for (std::uint32_t t = 0; t < tree_.size(); ++t) {
    Halfedge h = mesh.halfedge(Face(tree_.owner(t)));
    for (const std::uint32_t point : tree_.corners(t)) {
      point_lengths_[point] = sizing.length_at(mesh.from(h));
      h = mesh.next(h);
    }
  }
}

void Target::find_neighbours(const Mesh& mesh) {
  std::vector<std::uint32_t> number(mesh.face_slots(), no_index);
  for (std::uint32_t t = 0; t < tree_.size(); ++t) number[tree_.owner(t)] = t;
  beside_.resize(tree_.size());
  for (std::uint32_t t = 0; t < tree_.size(); ++t) {
    Halfedge h = mesh.halfedge(Face(tree_.owner(t)));
    for (std::uint32_t& other : beside_[t]) {
      const Face f = mesh.face(twin(h));
      other = f ? number[f.index] : no_index;
      h = mesh.next(h);
    }
  }
}

// Whether few steps lead to a triangle under a place, and near; to the last one in any case.
bool Target::comes_under(const glm::dvec3& place, std::uint32_t& triangle) const {
  constexpr int most_steps = 4;
  constexpr double of_length = 0.1;
  for (int step = 0; step < most_steps; ++step) {
    const Foot foot(place, tree_.places(triangle));
    if (foot.is_inside()) return foot.is_within(of_length * sizing_.shortest());
    const std::uint32_t next = beside_[triangle][foot.side()];
    if (next == no_index) return false;
    triangle = next;
  }
  return false;
}

std::optional<Target::Nearest> Target::nearest(const glm::dvec3& place, const glm::dvec3& direction,
                                               std::uint32_t hint) const {
  if (tree_.is_empty() || !is_finite(place)) return std::nullopt;
  std::uint32_t triangle = hint;
  if (hint == no_index || !comes_under(place, triangle)) triangle = tree_.nearest(place, triangle).triangle;
  if (glm::dot(tree_.area_normal(triangle), direction) < 0) triangle = tree_.nearest_facing(place, direction).triangle;
  if (triangle == no_index) return std::nullopt;
  if (!sizing_.is_adaptive()) return Nearest{place - tree_.way(place, triangle), sizing_.longest(), triangle};
  const auto& [a, b, c] = tree_.corners(triangle);
  const NearestPlace near = nearest_place(tree_.points(), Primitive::triangle(a, b, c, 0), place);
  const glm::dvec3 lengths(point_lengths_[a], point_lengths_[b], point_lengths_[c]);
  return Nearest{near.place, glm::dot(near.barycentric, lengths), triangle};
}

std::optional<Target::Share> Target::share(const glm::dvec3& place, const glm::dvec3& direction, std::uint32_t hint,
                                           const std::function<bool(Face)>& may_be) const {
  const auto found = nearest(place, direction, hint);
  if (!found) return std::nullopt;
  std::uint32_t triangle = found->triangle;
  if (!may_be(Face(tree_.owner(triangle))))
    triangle = tree_.nearest_of(place, [&](std::uint32_t t) { return may_be(Face(tree_.owner(t))); }).triangle;
  if (triangle == no_index) return std::nullopt;
  const auto& [a, b, c] = tree_.corners(triangle);
  const glm::dvec3 weights = nearest_place(tree_.points(), Primitive::triangle(a, b, c, 0), place).barycentric;
  return Share{Face(tree_.owner(triangle)), {weights.x, weights.y, weights.z}};
}

}  // namespace ryosen::remesh
