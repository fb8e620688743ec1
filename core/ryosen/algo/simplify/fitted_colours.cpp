#include "ryosen/algo/simplify/fitted_colours.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/vec4.hpp>
#include <limits>

#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen {

namespace {

// A colour is held by this share where samples leave it open.
constexpr double colour_held_share = 0.01;
// A difference of colours below this is rounding.
constexpr double least_difference = 1e-12;
constexpr int colour_sweeps = 12;

bool is_finite_colour(const glm::dvec4& c) {
  return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z) && std::isfinite(c.w);
}

glm::dvec4 without_rounding(glm::dvec4 difference) {
  for (int i = 0; i < 4; ++i)
    if (std::abs(difference[i]) < least_difference) difference[i] = 0;
  return difference;
}

// The equations of the changes of colours by vertex, for which the squares are least.
class Fit {
 public:
  Fit(const CollapseSurface& surface, const NearSamples& samples, const Mesh& input, const AttributeColumn& colours)
      : surface_(surface),
        mesh_(surface.mesh()),
        colours_(colours),
        equations_(mesh_.vertex_slots()),
        between_(mesh_.edge_slots()) {
    const AttributeColumn& before = *find_column(input, attribute_names::colour);
    for (const Vertex v : live_vertices(input))
      if (const auto colour = attribute_value<glm::dvec4>(before, v.index); is_finite_colour(colour)) {
        lowest_ = glm::min(lowest_, colour);
        highest_ = glm::max(highest_, colour);
      }
    for (const Face f : live_faces(mesh_)) add(f, samples, before);
  }

  void sweep() {
    for (const Vertex v : live_vertices(mesh_)) {
      Equation& own = equations_[v.index];
      if (!(own.squares > 0) || !surface_.has_changed(v) || !surface_.is_free(v)) continue;
      glm::dvec4 rest = own.wanted;
      for (const Halfedge h : outgoing(mesh_, v))
        rest -= between_[edge(h).index] * equations_[mesh_.to(h).index].change;
      own.change = rest / (own.squares + colour_held_share * own.area);
    }
  }

  void write(Edit& edit, std::size_t column) const {
    for (const Vertex v : live_vertices(mesh_)) {
      const glm::dvec4& change = equations_[v.index].change;
      if (change == glm::dvec4(0.0)) continue;
      const auto colour = attribute_value<glm::dvec4>(colours_, v.index);
      edit.set_attribute(column, v.index, attribute_words(glm::clamp(colour + change, lowest_, highest_)));
    }
  }

 private:
  struct Equation {
    double squares = 0, area = 0;  // of the shares of samples, by their areas
    glm::dvec4 wanted{0.0}, change{0.0};
  };

  // Whether a place is on an edge or vertex between points of the boundary: a sample nearest to it may lie beyond a
  // boundary that has moved, and have no place on the surface.
  bool is_at_boundary(const std::array<Halfedge, 3>& corners, const glm::dvec3& shares) const {
    bool is_within = true, has_inner = false;
    for (std::size_t i = 0; i < 3; ++i) {
      const bool counts = shares[static_cast<int>(i)] > 0;
      is_within = is_within && counts;
      has_inner = has_inner || (counts && !mesh_.is_boundary(mesh_.from(corners[i])));
    }
    return !is_within && !has_inner;
  }

  void add(Face f, const NearSamples& samples, const AttributeColumn& before) {
    const Halfedge h = mesh_.halfedge(f);
    const std::array<Halfedge, 3> corners{h, mesh_.next(h), mesh_.prev(h)};
    const auto at = [&](std::size_t i) { return mesh_.from(corners[i]).index; };
    std::array<glm::dvec3, 3> places{};
    for (std::size_t i = 0; i < 3; ++i) places[i] = surface_.place(mesh_.from(corners[i]));
    samples.for_each(f, [&](std::uint32_t s) {
      const auto [place, area] = samples.sample(s);
      glm::dvec4 difference{0.0};
      for (const Vertex v : samples.corners(s)) difference += attribute_value<glm::dvec4>(before, v.index) / 3.0;
      const glm::dvec3 shares = nearest_on_triangle(places, place).barycentric;
      for (std::size_t i = 0; i < 3; ++i)
        difference -= shares[static_cast<int>(i)] * attribute_value<glm::dvec4>(colours_, at(i));
      if (is_at_boundary(corners, shares)) return;
      if (!is_finite_colour(difference)) return;
      difference = without_rounding(difference);
      for (std::size_t i = 0; i < 3; ++i) {
        const double share = shares[static_cast<int>(i)];
        Equation& own = equations_[at(i)];
        own.squares += area * share * share;
        own.area += area * share;
        own.wanted += area * share * difference;
        between_[edge(corners[i]).index] += area * share * shares[static_cast<int>((i + 1) % 3)];
      }
    });
  }

  const CollapseSurface& surface_;
  const Mesh& mesh_;
  const AttributeColumn& colours_;
  std::vector<Equation> equations_;  // by vertex
  std::vector<double> between_;      // by edge, of its ends
  glm::dvec4 lowest_{std::numeric_limits<double>::infinity()}, highest_{-std::numeric_limits<double>::infinity()};
};

}  // namespace

void fit_colours(Edit& edit, const CollapseSurface& surface, const NearSamples& samples, const Mesh& input) {
  const int column = edit.mesh().find_attribute(attribute_names::colour);
  if (column < 0) return;
  const auto index = static_cast<std::size_t>(column);
  Fit fit(surface, samples, input, edit.mesh().attributes()[index]);
  for (int i = 0; i < colour_sweeps; ++i) fit.sweep();
  fit.write(edit, index);
}

}  // namespace ryosen
