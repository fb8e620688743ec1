#include "ryosen/algo/repair/fair_patch.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "ryosen/geometry/is_finite.h"
#include "ryosen/geometry/polygon_normal.h"

namespace ryosen {

namespace {

using Places = std::vector<glm::dvec3>;

double inner_product(const Places& a, const Places& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += glm::dot(a[i], b[i]);
  return sum;
}

// a += t b
void add_times(Places& a, double t, const Places& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += t * b[i];
}

// The cotangent Laplacian at each vertex of the patch and its loop, divided by the square root of the vertex area; a
// linear function of the new vertices' positions. Its squared norm is the thin-plate energy.
class PlateEquations {
 public:
  PlateEquations(const HolePatch& patch, const HoleLoop& loop)
      : patch_(patch), loop_(loop), row_(vertices(), no_index) {
    // Corners on another boundary are skipped: their one-ring is incomplete.
    for (std::uint32_t v = 0; v < patch.places.size(); ++v)
      if (v >= patch.corners || !loop.around.is_open[v]) add_row(v);
    for (const CornerTriangle& t : patch.triangles) add_triangle(t);
    for (const CornerTriangle& t : loop.around.triangles)
      add_triangle({behind_patch(t[0]), behind_patch(t[1]), behind_patch(t[2])});
    for (Row& row : rows_) {
      const double scale = row.area > 0 ? 1 / std::sqrt(row.area) : 0;
      row.fixed *= scale;
      for (Term& term : row.terms) term.weight *= scale;
    }
  }

  // The values of all rows, with or without the constant part of the fixed vertices.
  Places values(const Places& inner, bool with_fixed) const {
    Places result(rows_.size(), glm::dvec3(0.0));
    for (std::size_t r = 0; r < result.size(); ++r) {
      if (with_fixed) result[r] = rows_[r].fixed;
      for (const Term& term : rows_[r].terms) result[r] += term.weight * inner[term.inner];
    }
    return result;
  }
  Places transposed(const Places& values) const {
    Places result(patch_.new_vertices(), glm::dvec3(0.0));
    for (std::size_t r = 0; r < values.size(); ++r)
      for (const Term& term : rows_[r].terms) result[term.inner] += term.weight * values[r];
    return result;
  }
  // The inverse of the diagonal of the normal equations.
  std::vector<double> inverse_diagonal() const {
    std::vector<double> sum(patch_.new_vertices(), 0.0);
    for (const Row& row : rows_)
      for (const Term& term : row.terms) sum[term.inner] += term.weight * term.weight;
    for (double& s : sum) s = s > 0 ? 1 / s : 0;
    return sum;
  }

 private:
  struct Term {
    std::uint32_t inner;
    double weight;
  };
  struct Row {
    std::vector<Term> terms;
    glm::dvec3 fixed{0.0};
    double area = 0;
  };

  // Vertices are numbered as in the patch, those around it behind.
  std::size_t vertices() const { return patch_.places.size() + loop_.around.places.size(); }
  std::uint32_t behind_patch(std::uint32_t v) const { return v < patch_.corners ? v : v + patch_.new_vertices(); }
  bool is_inner(std::uint32_t v) const { return v >= patch_.corners && v < patch_.places.size(); }
  const glm::dvec3& place(std::uint32_t v) const {
    return v < patch_.places.size() ? patch_.places[v] : loop_.around.places[v - patch_.places.size()];
  }

  void add_row(std::uint32_t v) {
    row_[v] = static_cast<std::uint32_t>(rows_.size());
    rows_.emplace_back();
  }

  void add_triangle(const CornerTriangle& t) {
    for (std::size_t k = 0; k < 3; ++k) add_corner(t[k], t[(k + 1) % 3], t[(k + 2) % 3]);
  }

  // The cotangent at a corner is the weight of the opposite side; a third of the triangle's area goes to the corner.
  void add_corner(std::uint32_t corner, std::uint32_t next, std::uint32_t last) {
    const glm::dvec3 u = place(next) - place(corner), v = place(last) - place(corner);
    const double area = glm::length(glm::cross(u, v));
    if (!(area > 0)) return;
    constexpr double most = 20;
    const double weight = std::clamp(glm::dot(u, v) / area, -most, most) / 2;
    add_difference(next, last, weight);
    add_difference(last, next, weight);
    if (row_[corner] != no_index) rows_[row_[corner]].area += area / 6;
  }

  void add_difference(std::uint32_t of, std::uint32_t to, double weight) {
    if (row_[of] == no_index) return;
    add_term(rows_[row_[of]], to, weight);
    add_term(rows_[row_[of]], of, -weight);
  }

  void add_term(Row& row, std::uint32_t v, double weight) {
    if (!is_inner(v)) {
      row.fixed += weight * place(v);
      return;
    }
    const std::uint32_t inner = v - patch_.corners;
    for (Term& term : row.terms)
      if (term.inner == inner) {
        term.weight += weight;
        return;
      }
    row.terms.push_back({inner, weight});
  }

  const HolePatch& patch_;
  const HoleLoop& loop_;
  std::vector<std::uint32_t> row_;  // by vertex
  std::vector<Row> rows_;
};

// Conjugate gradients on the normal equations, preconditioned by their diagonal. Calls go_on(step, most steps) before
// each step.
template <class GoOn>
Places minimise_bending(const PlateEquations& plate, Places x, std::size_t most_steps, const GoOn& go_on) {
  const std::vector<double> inverse = plate.inverse_diagonal();
  const auto scaled = [&](Places places) {
    for (std::size_t i = 0; i < places.size(); ++i) places[i] *= inverse[i];
    return places;
  };
  Places residual = plate.transposed(plate.values(x, true));
  for (glm::dvec3& r : residual) r = -r;
  Places direction = scaled(residual);
  double size = inner_product(residual, direction);
  const double enough = size * 1e-18;
  for (std::size_t step = 0; step < most_steps && size > enough && size > 0 && go_on(step, most_steps); ++step) {
    const Places image = plate.values(direction, false);
    const double bend = inner_product(image, image);
    if (!(bend > 0)) break;
    add_times(x, size / bend, direction);
    add_times(residual, -size / bend, plate.transposed(image));
    const Places next_direction = scaled(residual);
    const double next = inner_product(residual, next_direction);
    for (std::size_t i = 0; i < x.size(); ++i) direction[i] = next_direction[i] + (next / size) * direction[i];
    size = next;
  }
  return x;
}

// Unit normals of the new vertices; zero where there is none.
Places normals_of(const HolePatch& patch) {
  Places normals(patch.new_vertices(), glm::dvec3(0.0));
  for (const CornerTriangle& t : patch.triangles) {
    const glm::dvec3& a = patch.places[t[0]];
    const glm::dvec3 normal = glm::cross(patch.places[t[1]] - a, patch.places[t[2]] - a);
    for (const std::uint32_t v : t)
      if (v >= patch.corners) normals[v - patch.corners] += normal;
  }
  for (glm::dvec3& normal : normals) {
    const double length = glm::length(normal);
    normal = length > 0 ? normal / length : glm::dvec3(0.0);
  }
  return normals;
}

}  // namespace

bool is_flat(const HoleLoop& loop) {
  const glm::dvec3 normal = polygon_normal(loop.places);
  double reach = 0, height = 0;
  for (const std::vector<glm::dvec3>* places : {&loop.places, &loop.around.places})
    for (const glm::dvec3& p : *places) {
      reach = std::max(reach, glm::distance(p, loop.places[0]));
      height = std::max(height, std::abs(glm::dot(normal, p - loop.places[0])));
    }
  return normal != glm::dvec3(0.0) && height <= 1e-6 * reach;
}

void fair(HolePatch& patch, const HoleLoop& loop, FairMove move, Progress& progress) {
  const std::size_t n = patch.new_vertices();
  if (n == 0 || is_flat(loop)) return;
  constexpr std::size_t most_work = 1000000;  // what a tenth of a second does or so
  const std::size_t steps = std::clamp<std::size_t>(most_work / n, 20, std::min<std::size_t>(4 * n + 100, 1000));
  const auto go_on = [&](std::size_t step, std::size_t all) { return progress.go_on(step, all); };
  const Places x = minimise_bending(PlateEquations(patch, loop),
                                    {patch.places.begin() + patch.corners, patch.places.end()}, steps, go_on);
  const Places normals = move == FairMove::along_normals ? normals_of(patch) : Places();
  for (std::size_t i = 0; i < n; ++i) {
    if (!is_finite(x[i])) continue;
    glm::dvec3& place = patch.places[patch.corners + i];
    place = normals.empty() ? x[i] : place + glm::dot(normals[i], x[i] - place) * normals[i];
  }
}

}  // namespace ryosen
