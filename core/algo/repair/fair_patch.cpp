#include "core/algo/repair/fair_patch.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <unordered_map>
#include <unordered_set>

#include "core/base/sort_unique.h"
#include "core/geometry/is_finite.h"
#include "core/mesh/circulate.h"
#include "core/mesh/face_polygon.h"
#include "core/ops/poke.h"
#include "core/ops/swap_edge.h"

namespace ryosen {

namespace {

constexpr std::size_t most_new_vertices = 100000;

class PatchRefiner {
 public:
  PatchRefiner(Edit& edit, Patch& patch, Progress& progress)
      : edit_(edit), patch_(patch), progress_(progress), faces_(patch.faces.begin(), patch.faces.end()) {
    for (Vertex v : patch.boundary) spacing_[v] = mean_edge_outside(v);
    for (Vertex v : patch.inner) spacing_[v] = mean_spacing_around(v);
  }

  void run() {
    constexpr int most_rounds = 50;
    for (int round = 0; round < most_rounds && divide() > 0; ++round) relax();
  }

 private:
  const Mesh& mesh() const { return edit_.mesh(); }
  const glm::dvec3& place(Vertex v) const { return mesh().position(v); }
  bool is_within(Halfedge h) const { return faces_.contains(mesh().face(h)) && faces_.contains(mesh().face(twin(h))); }

  double mean_edge_outside(Vertex v) const {
    double sum = 0;
    int count = 0;
    for (Halfedge h : outgoing(mesh(), v)) {
      if (is_within(h)) continue;
      sum += glm::distance(place(v), place(mesh().to(h)));
      ++count;
    }
    return count > 0 ? sum / count : 0;
  }
  double mean_spacing_around(Vertex v) const {
    double sum = 0;
    int count = 0;
    for (Vertex w : neighbours(mesh(), v)) {
      const auto known = spacing_.find(w);
      if (known == spacing_.end()) continue;
      sum += known->second;
      ++count;
    }
    return count > 0 ? sum / count : 0;
  }

  std::size_t divide() {
    std::size_t divided = 0;
    const std::size_t count = patch_.faces.size();
    for (std::size_t i = 0; i < count && patch_.inner.size() < most_new_vertices && progress_.go_on(); ++i)
      divided += divide(patch_.faces[i]);
    return divided;
  }

  bool divide(Face f) {
    const Poke op{f};
    const glm::dvec3 middle = op.position(mesh());
    std::array<Halfedge, 3> sides;
    std::size_t n = 0;
    double spacing = 0;
    for (Halfedge h : halfedges_around(mesh(), f)) {
      spacing += spacing_.at(mesh().from(h)) / 3;
      sides[n++] = h;
    }
    for (Halfedge h : sides) {
      const double reach = std::sqrt(2.0) * glm::distance(middle, place(mesh().from(h)));
      if (!(reach > spacing) || !(reach > spacing_.at(mesh().from(h)))) return false;
    }
    if (!op.check(mesh()).legal()) return false;
    const OpEffect effect = op.apply(edit_);
    for (const Element& e : effect.created) {
      if (e.kind == Element::Kind::vertex) {
        spacing_[e.vertex()] = spacing;
        patch_.inner.push_back(e.vertex());
      } else if (e.kind == Element::Kind::face) {
        faces_.insert(e.face());
        patch_.faces.push_back(e.face());
      }
    }
    for (Halfedge h : sides) swap_if_better(h);
    return true;
  }

  // Cotangent of the angle opposite h, without trigonometry.
  double cotangent_across(Halfedge h) const {
    const glm::dvec3& apex = place(mesh().to(mesh().next(h)));
    const glm::dvec3 u = place(mesh().from(h)) - apex, v = place(mesh().to(h)) - apex;
    const double area = glm::length(glm::cross(u, v));
    return area > 0 ? glm::dot(u, v) / area : glm::dot(u, v) < 0 ? -1e9 : 1e9;
  }

  // Delaunay criterion: swap if the opposite angles sum to more than 180 degrees (cotangent sum negative).
  bool swap_if_better(Halfedge h) {
    if (!is_within(h) || !(cotangent_across(h) + cotangent_across(twin(h)) < -1e-9)) return false;
    const SwapEdge op{h};
    if (!op.check(mesh()).legal()) return false;
    op.apply(edit_);
    return true;
  }

  void relax() {
    constexpr int most_sweeps = 20;
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
      std::size_t swapped = 0;
      for (Face f : patch_.faces) {
        if (!progress_.go_on()) return;
        std::array<Halfedge, 3> sides;
        std::size_t n = 0;
        for (Halfedge h : halfedges_around(mesh(), f)) sides[n++] = h;
        for (Halfedge h : sides)
          if (mesh().face(h) == f) swapped += swap_if_better(h);
      }
      if (swapped == 0) return;
    }
  }

  Edit& edit_;
  Patch& patch_;
  Progress& progress_;
  std::unordered_set<Face> faces_;
  std::unordered_map<Vertex, double> spacing_;
};

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

// The cotangent Laplacian at each vertex of the patch and its boundary, divided by the square root of the vertex area;
// a linear function of the inner positions. Its squared norm is the thin-plate energy.
class PlateEquations {
 public:
  PlateEquations(const Mesh& mesh, const Patch& patch) {
    for (Vertex v : patch.inner) inner_.emplace(v, static_cast<std::uint32_t>(inner_.size()));
    for (Vertex v : patch.inner) add_row(v);
    // Skip vertices on another boundary: their one-ring is incomplete.
    for (Vertex v : patch.boundary)
      if (!mesh.is_boundary(v)) add_row(v);
    for (Face f : faces_around_patch(mesh, patch)) add_face(mesh, f);
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
    Places result(inner_.size(), glm::dvec3(0.0));
    for (std::size_t r = 0; r < values.size(); ++r)
      for (const Term& term : rows_[r].terms) result[term.inner] += term.weight * values[r];
    return result;
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

  void add_row(Vertex v) {
    row_.emplace(v, static_cast<std::uint32_t>(rows_.size()));
    rows_.emplace_back();
  }

  static std::vector<Face> faces_around_patch(const Mesh& mesh, const Patch& patch) {
    std::vector<Face> faces = patch.faces;
    for (Vertex v : patch.boundary)
      for (Face f : faces_around(mesh, v))
        if (f) faces.push_back(f);
    sort_unique(faces);
    return faces;
  }

  void add_face(const Mesh& mesh, Face f) {
    polygon_.read(mesh, f);
    if (!polygon_.is_finite()) return;
    polygon_.triangulate(triangles_);
    for (const CornerTriangle& t : triangles_)
      for (std::size_t k = 0; k < 3; ++k) add_corner(mesh, t[k], t[(k + 1) % 3], t[(k + 2) % 3]);
  }

  // The cotangent at a corner is the weight of the opposite side; a third of the triangle's area goes to the corner.
  void add_corner(const Mesh& mesh, std::uint32_t corner, std::uint32_t next, std::uint32_t last) {
    const auto vertex = [&](std::uint32_t c) { return mesh.from(polygon_.corners()[c]); };
    const glm::dvec3& apex = polygon_.places()[corner];
    const glm::dvec3 u = polygon_.places()[next] - apex, v = polygon_.places()[last] - apex;
    const double area = glm::length(glm::cross(u, v));
    if (!(area > 0)) return;
    constexpr double most = 20;
    const double weight = std::clamp(glm::dot(u, v) / area, -most, most) / 2;
    add_difference(mesh, vertex(next), vertex(last), weight);
    add_difference(mesh, vertex(last), vertex(next), weight);
    if (const auto row = row_.find(vertex(corner)); row != row_.end()) rows_[row->second].area += area / 6;
  }

  void add_difference(const Mesh& mesh, Vertex of, Vertex to, double weight) {
    const auto row = row_.find(of);
    if (row == row_.end()) return;
    add_term(mesh, rows_[row->second], to, weight);
    add_term(mesh, rows_[row->second], of, -weight);
  }

  void add_term(const Mesh& mesh, Row& row, Vertex v, double weight) {
    const auto inner = inner_.find(v);
    if (inner == inner_.end()) {
      row.fixed += weight * mesh.position(v);
      return;
    }
    for (Term& term : row.terms)
      if (term.inner == inner->second) {
        term.weight += weight;
        return;
      }
    row.terms.push_back({inner->second, weight});
  }

  std::unordered_map<Vertex, std::uint32_t> inner_, row_;
  std::vector<Row> rows_;
  FacePolygon polygon_;
  std::vector<CornerTriangle> triangles_;
};

// Conjugate gradients on the normal equations. Calls go_on(step, most steps) before each step.
template <class GoOn>
Places minimise_bending(const PlateEquations& plate, Places x, const GoOn& go_on) {
  Places residual = plate.transposed(plate.values(x, true));
  for (glm::dvec3& r : residual) r = -r;
  Places direction = residual;
  double size = inner_product(residual, residual);
  const double enough = size * 1e-20;
  const std::size_t most_steps = std::min<std::size_t>(4 * x.size() + 100, 1000);
  for (std::size_t step = 0; step < most_steps && size > enough && size > 0 && go_on(step, most_steps); ++step) {
    const Places image = plate.values(direction, false);
    const double bend = inner_product(image, image);
    if (!(bend > 0)) break;
    add_times(x, size / bend, direction);
    add_times(residual, -size / bend, plate.transposed(image));
    const double next = inner_product(residual, residual);
    for (std::size_t i = 0; i < x.size(); ++i) direction[i] = residual[i] + (next / size) * direction[i];
    size = next;
  }
  return x;
}

}  // namespace

void refine(Edit& edit, Patch& patch, Progress& progress) { PatchRefiner(edit, patch, progress).run(); }

void fair(Edit& edit, const Patch& patch, Progress& progress) {
  if (patch.inner.empty()) return;
  // The weights depend on the current positions, so iterate.
  constexpr std::size_t large = 5000;
  const std::size_t rounds = patch.inner.size() < large ? 4 : 1;
  for (std::size_t round = 0; round < rounds; ++round) {
    const auto go_on = [&](std::size_t step, std::size_t steps) {
      return progress.go_on(round * steps + step, rounds * steps);
    };
    Places x;
    for (Vertex v : patch.inner) x.push_back(edit.mesh().position(v));
    x = minimise_bending(PlateEquations(edit.mesh(), patch), std::move(x), go_on);
    for (std::size_t i = 0; i < x.size(); ++i)
      if (is_finite(x[i])) edit.set_position(patch.inner[i], x[i]);
  }
}

}  // namespace ryosen
