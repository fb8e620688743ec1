#include "ryosen/algo/simplify/near_samples.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "ryosen/base/parallel.h"
#include "ryosen/geometry/closest.h"
#include "ryosen/geometry/unit_vector.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen {

namespace {

bool is_plain_triangle(const Mesh& mesh, Face f) {
  const Halfedge h = mesh.halfedge(f);
  return !mesh.has_rings(f) && mesh.next(mesh.next(h)) == mesh.prev(h);
}

TriangleTree tree_of(const CollapseSurface& surface) {
  std::vector<glm::dvec3> places(surface.mesh().vertex_slots());
  for (const Vertex v : live_vertices(surface.mesh())) places[v.index] = surface.place(v);
  return TriangleTree(places, plain_triangles(surface.mesh(), places), 1);
}

std::vector<glm::dvec3> places_of_input(const Mesh& input, const CollapseSurface& surface) {
  std::vector<glm::dvec3> places(input.vertex_slots());
  for (const Vertex v : live_vertices(input)) places[v.index] = surface.scale().scaled(input.position(v));
  return places;
}

}  // namespace

Primitive triangle_primitive(const Mesh& mesh, Face f) {
  const Halfedge h = mesh.halfedge(f);
  return Primitive::triangle(mesh.from(h).index, mesh.to(h).index, mesh.from(mesh.prev(h)).index, f.index);
}

std::vector<Primitive> plain_triangles(const Mesh& mesh, std::span<const glm::dvec3> places) {
  std::vector<Primitive> triangles;
  triangles.reserve(mesh.live().faces);
  for (const Face f : live_faces(mesh)) {
    if (!is_plain_triangle(mesh, f)) continue;
    const Primitive t = triangle_primitive(mesh, f);
    if (std::all_of(t.vertices.begin(), t.vertices.end(), [&](std::uint32_t v) { return is_finite(places[v]); }))
      triangles.push_back(t);
  }
  return triangles;
}

TriangleTree tree_of_input(const Mesh& input, const CollapseSurface& surface) {
  const std::vector<glm::dvec3> places = places_of_input(input, surface);
  return TriangleTree(places, plain_triangles(input, places), 1);
}

NearSamples::NearSamples(const Mesh& input, const CollapseSurface& surface)
    : input_(input), surface_(surface), vertex_areas_(input.vertex_slots()) {
  for (const Face f : live_faces(input_)) {
    if (!is_sampled(f)) {
      covers_input_ = false;
      continue;
    }
    const auto area = static_cast<float>(middle_of(f).area / 9);  // a twelfth of the triangle
    for (const std::uint32_t v : triangle_primitive(input_, f).vertices) vertex_areas_[v] += area;
  }
}

bool NearSamples::is_sampled(Face f) const {
  if (!input_.is_alive(f) || !is_plain_triangle(input_, f)) return false;
  const Primitive t = triangle_primitive(input_, f);
  return std::all_of(t.vertices.begin(), t.vertices.end(),
                     [&](std::uint32_t v) { return is_finite(input_.position(Vertex(v))); });
}

NearSamples::Sample NearSamples::middle_of(Face f) const {
  const auto place = [&](std::uint32_t v) { return surface_.scale().scaled(input_.position(Vertex(v))); };
  const auto& [a, b, c] = triangle_primitive(input_, f).vertices;
  const glm::dvec3 x = place(a), y = place(b), z = place(c);
  return {(x + y + z) / 3.0, glm::length(glm::cross(y - x, z - x)) * 3 / 8};
}

std::array<Vertex, 3> NearSamples::corners(std::uint32_t i) const {
  const std::uint32_t number = numbers_[i], faces = input_.face_slots();
  if (number >= faces) return {Vertex(number - faces), Vertex(number - faces), Vertex(number - faces)};
  const auto& [a, b, c] = triangle_primitive(input_, Face(number)).vertices;
  return {Vertex(a), Vertex(b), Vertex(c)};
}

Halfedge NearSamples::corner_of_input(std::uint32_t i) const {
  const std::uint32_t number = numbers_[i], faces = input_.face_slots();
  if (number < faces) return input_.halfedge(Face(number));
  for (const Halfedge h : outgoing(input_, Vertex(number - faces)))
    if (input_.face(h) && is_sampled(input_.face(h))) return h;
  return Halfedge();
}

// Looks for the nearest face: among those around the vertex that a sample's has become, and from one that lies across
// on among those around its corners, as long as that comes nearer.
class NearSamples::Search {
 public:
  // `tree`: of all triangles, asked in place of the faces around a hub, and of all where it is to be exact.
  Search(const CollapseSurface& surface, const TriangleTree& tree, bool is_exact)
      : mesh_(surface.mesh()), surface_(surface), tree_(tree), is_exact_(is_exact) {}

  static bool is_hub(const Mesh& mesh, Vertex v) {
    std::size_t valence = 0;
    for ([[maybe_unused]] const Halfedge h : outgoing(mesh, v))
      if (++valence > most_asked) return true;
    return false;
  }

  void start_at(Vertex v) {
    by_tree_ = is_exact_ || is_hub(mesh_, v);
    around_.clear();
    if (by_tree_) return;
    for (const Halfedge h : outgoing(mesh_, v)) {
      const std::optional<Triangle> triangle = triangle_at(h);
      if (!triangle) continue;
      const auto& [a, b, c] = triangle->places;
      const glm::dvec3 normal = glm::cross(b - a, c - a);
      around_.push_back({*triangle, unit_or_zero(glm::cross(b - a, normal)), unit_or_zero(glm::cross(normal, c - a))});
    }
    bounds_.resize(around_.size());
  }

  // Returns none where there is no triangle.
  std::uint32_t nearest_face(const glm::dvec3& place) {
    if (by_tree_) return tree_.is_empty() ? no_index : tree_.owner(tree_.nearest(place).triangle);
    if (around_.empty()) return no_index;
    double least = std::numeric_limits<double>::infinity();
    Halfedge nearest;
    const auto is_nearer = [&](const Triangle& t) {
      const double square = square_from_triangle(t.places, place);
      if (!(square < least)) return false;
      least = square;
      nearest = t.corner;
      return true;
    };
    // The one in whose sector the place lies comes first.
    const glm::dvec3 from_vertex = place - around_[0].triangle.places[0];
    std::size_t first = 0;
    for (std::size_t i = 0; i < around_.size(); ++i) {
      const double beside =
          std::max(glm::dot(around_[i].beside_b, from_vertex), glm::dot(around_[i].beside_c, from_vertex));
      bounds_[i] = std::max(beside, 0.0);
      if (bounds_[i] < bounds_[first]) first = i;
    }
    is_nearer(around_[first].triangle);
    for (std::size_t i = 0; i < around_.size(); ++i)
      if (i != first && bounds_[i] * bounds_[i] < least) is_nearer(around_[i].triangle);
    if (!nearest) return no_index;
    const auto ask = [&](Halfedge corner) {
      const std::optional<Triangle> triangle = triangle_at(corner);
      return triangle && is_nearer(*triangle);
    };
    const double length2 = squared(surface_.place(mesh_.to(nearest)) - surface_.place(mesh_.from(nearest)));
    bool comes_nearer = ask(twin(mesh_.next(nearest)));  // the first corner is the vertex
    if (least > far_share * length2) comes_nearer = true;
    for (int step = 0; comes_nearer && step < most_steps; ++step) {
      comes_nearer = false;
      const Halfedge here = nearest;
      for (const Halfedge corner : {here, mesh_.next(here), mesh_.prev(here)}) {
        std::size_t asked = 0;
        for (const Halfedge h : outgoing(mesh_, mesh_.from(corner))) {
          if (++asked > most_asked) break;
          if (ask(h)) comes_nearer = true;
        }
      }
    }
    return mesh_.face(nearest).index;
  }

 private:
  static constexpr std::size_t most_asked = 32;
  static constexpr int most_steps = 32;
  // A place whose squared distance is more than this share of that of a side may be nearest to any triangle about it.
  static constexpr double far_share = 0.0025;

  struct Triangle {
    std::array<glm::dvec3, 3> places;
    Halfedge corner;
  };
  std::optional<Triangle> triangle_at(Halfedge h) const {
    if (!mesh_.face(h)) return std::nullopt;
    const Halfedge next = mesh_.next(h), prev = mesh_.prev(h);
    if (mesh_.next(next) != prev) return std::nullopt;
    return Triangle{{surface_.place(mesh_.from(h)), surface_.place(mesh_.from(next)), surface_.place(mesh_.from(prev))},
                    h};
  }

  // Its first corner is the vertex. The other vectors point away from it in its plane, across the sides there, so that
  // no place is nearer to it than it lies beyond these.
  struct Sector {
    Triangle triangle;
    glm::dvec3 beside_b, beside_c;
  };

  const Mesh& mesh_;
  const CollapseSurface& surface_;
  const TriangleTree& tree_;
  bool is_exact_, by_tree_ = false;
  std::vector<Sector> around_;
  std::vector<double> bounds_;  // how near each may be to the place that is looked for
};

std::vector<std::uint32_t> NearSamples::take_samples(std::span<const Vertex> merged) {
  const auto vertex_of = [&](Vertex was) {
    const Vertex v = merged[was.index] ? merged[was.index] : was;
    return surface_.mesh().is_alive(v) ? v.index : no_index;
  };
  const std::uint32_t faces = input_.face_slots(), count = faces + input_.vertex_slots();
  std::vector<std::uint32_t> slots(count, no_index);  // by number in the input: first its vertex, then its place
  const auto for_each_sample = [&](const auto& visit) {
    for_each_part(count, threads_for(count), [&](unsigned, std::uint32_t begin, std::uint32_t end) {
      for (std::uint32_t i = begin; i < end; ++i) visit(i, slots[i]);
    });
  };
  for_each_sample([&](std::uint32_t i, std::uint32_t& slot) {
    if (i >= faces)
      slot = vertex_areas_[i - faces] > 0 ? vertex_of(Vertex(i - faces)) : no_index;
    else if (is_sampled(Face(i)))
      slot = vertex_of(input_.from(input_.halfedge(Face(i))));
  });
  std::vector<std::uint32_t> begins(surface_.mesh().vertex_slots() + 1);
  for (const std::uint32_t v : slots)
    if (v != no_index) ++begins[v];
  std::exclusive_scan(begins.begin(), begins.end(), begins.begin(), 0u);
  sample_places_.resize(begins.back());
  sample_areas_.resize(begins.back());
  numbers_.resize(begins.back());
  std::vector<std::uint32_t> ends = begins;
  for (std::uint32_t& slot : slots)
    if (slot != no_index) slot = ends[slot]++;
  for_each_sample([&](std::uint32_t i, std::uint32_t slot) {
    if (slot == no_index) return;
    numbers_[slot] = i;
    const auto [place, area] =
        i < faces ? middle_of(Face(i))
                  : Sample{surface_.scale().scaled(input_.position(Vertex(i - faces))), vertex_areas_[i - faces]};
    sample_places_[slot] = place;
    sample_areas_[slot] = static_cast<float>(area);
  });
  return begins;
}

bool NearSamples::assign(std::span<const Vertex> merged, bool is_exact, Progress& progress) {
  const Mesh& mesh = surface_.mesh();
  const std::uint32_t vertices = mesh.vertex_slots();
  const std::vector<std::uint32_t> begins = take_samples(merged);
  bool needs_tree = is_exact;
  for (std::uint32_t v = 0; v < vertices && !needs_tree; ++v)
    needs_tree = begins[v] < begins[v + 1] && Search::is_hub(mesh, Vertex(v));
  const TriangleTree tree = needs_tree ? tree_of(surface_) : TriangleTree();
  next_.assign(sample_places_.size(), no_index);  // first the faces
  constexpr std::uint32_t piece = 1 << 16;        // between two looks at whether it is cancelled
  for (std::uint32_t first = 0; first < vertices; first += piece) {
    if (!progress.go_on()) return false;
    for_each_part(std::min(piece, vertices - first), threads_for(next_.size()),
                  [&](unsigned, std::uint32_t begin, std::uint32_t end) {
                    Search search(surface_, tree, is_exact);
                    for (std::uint32_t v = first + begin; v < first + end; ++v) {
                      if (begins[v] == begins[v + 1]) continue;
                      search.start_at(Vertex(v));
                      for (std::uint32_t i = begins[v]; i < begins[v + 1]; ++i)
                        next_[i] = search.nearest_face(sample_places_[i]);
                    }
                  });
  }
  first_.assign(mesh.face_slots(), no_index);
  for (std::uint32_t i = 0; i < next_.size(); ++i)
    if (next_[i] != no_index) give(Face(next_[i]), i);
  return true;
}

void NearSamples::take(Face f, std::vector<std::uint32_t>& taken) {
  for_each(f, [&](std::uint32_t i) { taken.push_back(i); });
  first_[f.index] = no_index;
}

}  // namespace ryosen
