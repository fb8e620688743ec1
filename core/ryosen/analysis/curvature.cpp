#include "ryosen/analysis/curvature.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "ryosen/base/sort_unique.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/circulate.h"

namespace ryosen {

namespace {

constexpr std::uint32_t most_steps = 8;  // to either side of an edge, around its other end

// The ends of the edges at w that are near the one to v: all where the valence is at most 17.
void add_neighbours_beside(const Mesh& mesh, Halfedge from_v, std::vector<Vertex>& found) {
  const Halfedge back = twin(from_v);
  Halfedge left = back, right = back;
  for (std::uint32_t i = 0; i < most_steps; ++i) {
    left = mesh.counter_clockwise(left);
    if (left == back) return;
    found.push_back(mesh.to(left));
    right = mesh.clockwise(right);
    found.push_back(mesh.to(right));
  }
}

// Ascending, without v.
std::vector<Vertex> points_of_two_rings(const Mesh& mesh, Vertex v) {
  std::vector<Vertex> found;
  found.reserve(64);
  for (const Halfedge h : outgoing(mesh, v)) {
    found.push_back(mesh.to(h));
    add_neighbours_beside(mesh, h, found);
  }
  sort_unique(found);
  found.erase(std::remove(found.begin(), found.end(), v), found.end());
  return found;
}

// The sum of the vector areas at the corners of v: of length 0 where there is no side to look from.
glm::dvec3 normal_at(const Mesh& mesh, Vertex v, double size) {
  glm::dvec3 sum(0);
  for (const Halfedge h : outgoing(mesh, v)) {
    if (mesh.is_outside(h)) continue;
    const glm::dvec3& here = mesh.position(v);
    sum +=
        glm::cross((mesh.position(mesh.to(h)) - here) / size, (mesh.position(mesh.from(mesh.prev(h))) - here) / size);
  }
  return sum;
}

// x, y, then x x, x y, y y, then those of the third degree, and the height behind them.
constexpr std::size_t most_terms = 9, height = most_terms;
using Row = std::array<double, most_terms + 1>;

// Solves for the factors of the terms from `first` up to `end` in the sense of least squares, by Householder's
// reflections. None where a term is that share of itself or less beside those before it, so that its factor would be
// mostly noise.
std::optional<Row> least_squares(std::vector<Row> rows, std::size_t first, std::size_t end, double least_share) {
  if (rows.size() < end - first) return std::nullopt;
  Row lengths{}, factors{};
  for (std::size_t k = first; k < end; ++k) {
    for (const Row& row : rows) lengths[k] += row[k] * row[k];
    lengths[k] = std::sqrt(lengths[k]);
    if (!(lengths[k] > 0)) return std::nullopt;
  }
  for (std::size_t k = first; k < end; ++k) {
    const std::size_t top = k - first;
    double square = 0;
    for (std::size_t i = top; i < rows.size(); ++i) square += rows[i][k] * rows[i][k];
    const double rest = std::sqrt(square);
    if (!(rest > least_share * lengths[k])) return std::nullopt;
    const double diagonal = rows[top][k] > 0 ? -rest : rest;
    // The mirror: the column less its image.
    rows[top][k] -= diagonal;
    const double half = -diagonal * rows[top][k];  // half the square of the mirror's length
    const auto reflect = [&](std::size_t column) {
      double product = 0;
      for (std::size_t i = top; i < rows.size(); ++i) product += rows[i][k] * rows[i][column];
      const double share = product / half;
      for (std::size_t i = top; i < rows.size(); ++i) rows[i][column] -= share * rows[i][k];
    };
    for (std::size_t column = k + 1; column < end; ++column) reflect(column);
    reflect(height);
    rows[top][k] = diagonal;
  }
  for (std::size_t k = end; k-- > first;) {
    const Row& row = rows[k - first];
    double rest = row[height];
    for (std::size_t column = k + 1; column < end; ++column) rest -= row[column] * factors[column];
    factors[k] = rest / row[k];
  }
  return factors;
}

// Of the height p x + q y + a x x + b x y + c y y + ... at 0: the shape operator's eigenvalues, turned so that heights
// which fall away count as bending away from the normal.
Curvature curvature_of(const Row& factors, double size) {
  const double p = factors[0], q = factors[1], a = 2 * factors[2], b = factors[3], c = 2 * factors[4];
  const double stretch = 1 + p * p + q * q, root = std::sqrt(stretch);
  const double mean = -((1 + q * q) * a - 2 * p * q * b + (1 + p * p) * c) / (2 * stretch * root);
  const double gaussian = (a * c - b * b) / (stretch * stretch);
  const double apart = std::sqrt(std::max(0.0, mean * mean - gaussian));
  return {(mean - apart) / size, (mean + apart) / size};
}

}  // namespace

Curvature curvature_at(Neighbourhood& around, Vertex v) {
  const Mesh& mesh = around.mesh();
  if (mesh.is_isolated(v) || !around.is_plain(v)) return {};
  const std::vector<Vertex> points = points_of_two_rings(mesh, v);
  const glm::dvec3& here = mesh.position(v);
  double size = 0;
  for (const Vertex w : points) {
    const glm::dvec3 way = mesh.position(w) - here;
    if (!is_finite(way)) return {};
    size = std::max({size, std::abs(way.x), std::abs(way.y), std::abs(way.z)});
  }
  if (!(size > 0)) return {};
  const glm::dvec3 sum = normal_at(mesh, v, size);
  const double length = glm::length(sum);
  if (!(length > 1e-12)) return {};
  const glm::dvec3 normal = sum / length, reach = glm::abs(normal);
  const glm::dvec3 axis = reach.x <= reach.y && reach.x <= reach.z ? glm::dvec3(1, 0, 0)
                          : reach.y <= reach.z                     ? glm::dvec3(0, 1, 0)
                                                                   : glm::dvec3(0, 0, 1);
  const glm::dvec3 first = glm::normalize(glm::cross(normal, axis)), second = glm::cross(normal, first);
  std::vector<Row> rows;
  rows.reserve(points.size());
  for (const Vertex w : points) {
    const glm::dvec3 way = (mesh.position(w) - here) / size;
    // As far as in space: the height of a circle is a square then.
    const double ahead = glm::dot(way, first), aside = glm::dot(way, second), flat = std::hypot(ahead, aside);
    const double stretch = flat > 0 ? glm::length(way) / flat : 1, x = stretch * ahead, y = stretch * aside;
    rows.push_back({x, y, x * x, x * y, y * y, x * x * x, x * x * y, x * y * y, y * y * y, glm::dot(way, normal)});
  }
  struct Terms {
    std::size_t begin, end;
    double least_share;
  };
  for (const Terms terms : {Terms{0, 9, 0.07}, Terms{0, 5, 0.001}, Terms{2, 5, 0.001}})
    if (const auto factors = least_squares(rows, terms.begin, terms.end, terms.least_share))
      return curvature_of(*factors, size);
  return {};
}

}  // namespace ryosen
