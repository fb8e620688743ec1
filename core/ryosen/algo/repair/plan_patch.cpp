#include "ryosen/algo/repair/plan_patch.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "ryosen/algo/repair/patch_crossings.h"
#include "ryosen/algo/repair/refine_patch.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/geometry/polygon_normal.h"
#include "ryosen/geometry/single_precision.h"

namespace ryosen {

namespace {

// Moves of new vertices towards the least bending.
enum class FairMove { all_the_way, along_normals };

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

// Conjugate gradients on the normal equations, preconditioned by their diagonal.
Places minimise_bending(const PlateEquations& plate, Places x, std::size_t most_steps, Progress& progress) {
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
  for (std::size_t step = 0; step < most_steps && size > enough && size > 0 && progress.go_on(step, most_steps);
       ++step) {
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

// Whether all corners and the vertices around them lie in a plane, but for rounding.
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

// Moves the new vertices to minimise the thin-plate energy, with tangent continuity at the loop: the sum over the
// vertices, the loop's included, of area times squared mean curvature normal, with cotangent weights: the bi-Laplacian
// of the places is zero [Botsch04]. The weights are those of the places before, so that it is to be called again. Moves
// along normals alone keep an even patch even. Conjugate gradients, at most 1000 steps, fewer in large patches. Nothing
// moves where the patch and the faces around it lie in a plane.
void fair(HolePatch& patch, const HoleLoop& loop, FairMove move, Progress& progress) {
  const std::size_t n = patch.new_vertices();
  if (n == 0 || is_flat(loop)) return;
  constexpr std::size_t most_work = 1000000;  // what a tenth of a second does or so
  const std::size_t steps = std::clamp<std::size_t>(most_work / n, 20, std::min<std::size_t>(4 * n + 100, 1000));
  const Places x = minimise_bending(PlateEquations(patch, loop),
                                    {patch.places.begin() + patch.corners, patch.places.end()}, steps, progress);
  const Places normals = move == FairMove::along_normals ? normals_of(patch) : Places();
  for (std::size_t i = 0; i < n; ++i) {
    if (!is_finite(x[i])) continue;
    glm::dvec3& place = patch.places[patch.corners + i];
    place = normals.empty() ? x[i] : place + glm::dot(normals[i], x[i] - place) * normals[i];
  }
}

bool is_weighed(const HoleLoop& hole) { return hole.size() <= most_weighed_corners; }

// The growth of edges per unit of distance from the rim: slowly where the triangles are to be even, and fast
// where a few do.
constexpr double growth_of_fair = 0.1, growth_of_flat = 0.4;

HoleTriangles best_triangles(const HoleLoop& hole, Progress& progress) {
  return is_weighed(hole) ? weigh_triangles(hole, progress) : project_triangles(hole);
}

HoleTriangles other_triangles(const HoleLoop& hole, Progress& progress) {
  return is_weighed(hole) ? project_triangles(hole) : cut_ears(hole, progress);
}

HoleTriangles fan_around_middle(const HoleLoop& hole, Progress&) {
  HoleTriangles fan;
  for (std::uint32_t i = 0; i < hole.size(); ++i) fan.triangles.push_back({i, (i + 1) % hole.size(), hole.size()});
  return fan;
}

HoleTriangles projected_triangles(const HoleLoop& hole, Progress&) { return project_triangles(hole); }

HoleTriangles unprojected_triangles(const HoleLoop& hole, Progress& progress) {
  return is_weighed(hole) ? weigh_triangles(hole, progress) : cut_ears(hole, progress);
}

constexpr WayToFill fair_ways[] = {
    {best_triangles, Fineness::fair},    {other_triangles, Fineness::fair},   {best_triangles, Fineness::even},
    {other_triangles, Fineness::even},   {best_triangles, Fineness::bare},    {other_triangles, Fineness::bare},
    {fan_around_middle, Fineness::fair}, {fan_around_middle, Fineness::bare},
};

constexpr WayToFill unfaired_ways[] = {
    {best_triangles, Fineness::even},  {other_triangles, Fineness::even},   {best_triangles, Fineness::bare},
    {other_triangles, Fineness::bare}, {fan_around_middle, Fineness::bare},
};

constexpr WayToFill planar_ways[] = {
    {projected_triangles, Fineness::even}, {unprojected_triangles, Fineness::even},
    {projected_triangles, Fineness::bare}, {unprojected_triangles, Fineness::bare},
    {fan_around_middle, Fineness::bare},
};

void add_middle(HolePatch& patch) {
  patch.places.push_back(mean_of(patch.places));
  patch.parents.push_back({no_index, no_index, no_index});
}

bool has_flat_triangle(const HolePatch& patch) {
  return std::any_of(patch.triangles.begin(), patch.triangles.end(),
                     [&](const CornerTriangle& t) { return patch.is_flat(t); });
}

// In the last turn no more vertices come.
constexpr FairMove moves[] = {FairMove::all_the_way, FairMove::all_the_way, FairMove::along_normals,
                              FairMove::along_normals};
constexpr std::size_t last_turn = std::size(moves) - 1;

void fair_in_turn(std::size_t turn, HolePatch& patch, const HoleLoop& hole, Progress& progress) {
  constexpr double steps = 10000;
  const auto report = [&](double share) {
    return progress.go_on(static_cast<std::size_t>((static_cast<double>(turn) + share) * steps),
                          static_cast<std::size_t>(steps) * std::size(moves));
  };
  Progress of_turn(report, {});
  fair(patch, hole, moves[turn], of_turn);
}

void round_places(const PatchStyle& style, HolePatch& patch) {
  for (std::uint32_t v = patch.corners; v < patch.places.size(); ++v) {
    glm::dvec3& place = patch.places[v];
    if (style.plane) place = style.plane->nearest(place);
    if (style.snaps_to_floats) place = to_single(place);
  }
}

}  // namespace

std::span<const WayToFill> ways_to_fill(const PatchStyle& style) {
  if (style.fairs) return fair_ways;
  return style.plane ? std::span<const WayToFill>(planar_ways) : unfaired_ways;
}

PlanResult arrange_patch(const WayToFill& way, const HoleTriangles& base, const HoleLoop& hole, const PatchStyle& style,
                         HolePatch& patch, Progress& progress) {
  if (base.triangles.empty()) return {base.cause};
  patch.corners = hole.size();
  patch.places = hole.places;
  patch.triangles = base.triangles;
  if (patch.triangles.size() == patch.corners) add_middle(patch);
  const bool refines = way.fineness >= Fineness::even, fairs = way.fineness == Fineness::fair;
  if (refines) swap_edges(patch, hole, progress);
  if (has_flat_triangle(patch)) return {WhyOpen::without_area};
  if (!style.may_cross && is_flat(hole))
    if (const auto side = side_on_surroundings(hole, patch)) return {WhyOpen::crosses, hole.sides[*side]};
  if (refines) refine(patch, hole, fairs ? growth_of_fair : growth_of_flat, progress);
  // The weights and the spacing follow the places, so that both are done in turns; so many that the places stay.
  for (std::size_t turn = 0; fairs && turn < last_turn; ++turn) {
    fair_in_turn(turn, patch, hole, progress);
    refine(patch, hole, growth_of_fair, progress);
  }
  return {};
}

PlanResult finish_patch(const WayToFill& way, const HoleLoop& hole, const PatchStyle& style, HolePatch& patch,
                        Progress& progress) {
  if (way.fineness == Fineness::fair) {
    fair_in_turn(last_turn, patch, hole, progress);
    swap_edges(patch, hole, progress);
  }
  round_places(style, patch);
  if (has_flat_triangle(patch)) return {WhyOpen::without_area};
  if (style.may_cross) return {};
  const auto side = side_on_surroundings(hole, patch);
  return side ? PlanResult{WhyOpen::crosses, hole.sides[*side]} : PlanResult{};
}

}  // namespace ryosen
