#include "ryosen/algo/subdivide/masks.h"

#include <array>
#include <cmath>
#include <numbers>

#include "ryosen/algo/subdivide/limit_normals.h"
#include "ryosen/base/column_memory.h"
#include "ryosen/base/parallel.h"

namespace ryosen::subdivide {

namespace {

// By valence; the first ones are computed once.
template <double (*weight)(std::uint32_t)>
double weight_by_valence(std::uint32_t n) {
  static const std::array<double, 64> known = [] {
    std::array<double, 64> weights{};
    for (std::uint32_t k = 1; k < weights.size(); ++k) weights[k] = weight(k);
    return weights;
  }();
  return n < known.size() ? known[n] : weight(n);
}

double cosine_of_share(std::uint32_t n) { return std::cos(2 * std::numbers::pi / n); }

double loop_weight(std::uint32_t n) {
  const double c = 0.375 + 0.25 * cosine_of_share(n);
  return (0.625 - c * c) / n;
}
double loop_limit_weight(std::uint32_t n) { return 1 / (n + 3 / (8 * loop_weight(n))); }
double sqrt3_weight(std::uint32_t n) { return (4 - 2 * cosine_of_share(n)) / (9.0 * n); }
double sqrt3_limit_weight(std::uint32_t n) { return 3 * sqrt3_weight(n) / (1 + 3 * n * sqrt3_weight(n)); }

std::uint32_t neighbour_count(const Mesh& mesh, Vertex v) {
  std::uint32_t n = 0;
  for ([[maybe_unused]] const Halfedge h : outgoing(mesh, v)) ++n;
  return n;
}

// All neighbours with a weight by the valence, the rest for the vertex itself.
template <double (*weight)(std::uint32_t)>
glm::dvec3 around(const Mesh& mesh, Vertex v) {
  constexpr std::uint32_t usual = 16;
  std::array<Vertex, usual> near;
  std::uint32_t n = 0;
  for (const Vertex w : neighbours(mesh, v)) {
    if (n < usual) near[n] = w;
    ++n;
  }
  const double share = weight_by_valence<weight>(n);
  glm::dvec3 sum = (1 - n * share) * mesh.position(v);
  if (n <= usual) {
    for (std::uint32_t i = 0; i < n; ++i) sum += share * mesh.position(near[i]);
    return sum;
  }
  for (const Vertex w : neighbours(mesh, v)) sum += share * mesh.position(w);
  return sum;
}

template <class Place>
void for_each_slot(std::uint32_t count, const Place& place) {
  for_each_part(count, threads_for(count), [&](unsigned, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; i < end; ++i) place(i);
  });
}

Places room_for(std::size_t count) {
  Places places;
  reserve_large(places, count);
  places.resize(count);
  return places;
}

// Of the vertices that are alive; dead ones keep their place.
template <class Place>
void place_vertices(const Mesh& mesh, Places& places, const Place& place) {
  for_each_slot(mesh.vertex_slots(), [&](std::uint32_t i) {
    places[i] = mesh.is_alive(Vertex(i)) ? place(Vertex(i)) : mesh.position(Vertex(i));
  });
}

template <class Smooth>
Places limit_by(const Mesh& mesh, const Creases& creases, Scheme scheme, const Smooth& smooth) {
  Places places = room_for(mesh.vertex_slots());
  const auto dart = [&](Vertex v) {
    return scheme == Scheme::sqrt3 ? smooth(v) : limit_of_dart(mesh, creases, v, scheme);
  };
  place_vertices(mesh, places, [&](Vertex v) { return limit_of_vertex(mesh, creases, v, smooth, dart); });
  return places;
}

// The centres behind the places of vertices and edges, in the order of the living faces: the means of their corners.
void place_centres(const Mesh& mesh, const std::vector<std::uint32_t>& centre_of, Places& places) {
  const std::size_t first = std::size_t{mesh.vertex_slots()} + mesh.edge_slots();
  for_each_slot(mesh.face_slots(), [&](std::uint32_t i) {
    const Face f(i);
    if (!mesh.is_alive(f)) return;
    double n = 0;
    for ([[maybe_unused]] const Halfedge h : loop(mesh, mesh.halfedge(f))) ++n;
    glm::dvec3 sum(0);
    for (const Halfedge h : loop(mesh, mesh.halfedge(f))) sum += mesh.position(mesh.from(h)) / n;
    places[first + (centre_of.empty() ? i : centre_of[i])] = sum;
  });
}

// Loop's scheme on triangles [Loop87]: the places of the old vertices, then one for each edge.
//
//        1                b--b
//       / \              /    \        b = (5/8 - (3/8 + cos(2 pi/n)/4)^2) / n, in the middle 1 - n b
//      3-x-3  / 8       b  v  b
//       \ /              \    /
//        1                b--b         limit: b' = 1 / (n + 3 / (8 b)) in place of b
Places loop_places(const Mesh& mesh, const Creases& creases) {
  const std::uint32_t vertices = mesh.vertex_slots();
  Places places = room_for(std::size_t{vertices} + mesh.edge_slots());
  const auto smooth_vertex = [&](Vertex v) { return around<loop_weight>(mesh, v); };
  place_vertices(mesh, places, [&](Vertex v) { return place_of_vertex(mesh, creases, v, smooth_vertex); });
  const auto smooth_edge = [&](Halfedge h) {
    const glm::dvec3 ends = 0.375 * mesh.position(mesh.from(h)) + 0.375 * mesh.position(mesh.to(h));
    return ends +
           (0.125 * mesh.position(mesh.from(mesh.prev(h))) + 0.125 * mesh.position(mesh.from(mesh.prev(twin(h)))));
  };
  for_each_slot(mesh.edge_slots(), [&](std::uint32_t e) {
    places[std::size_t{vertices} + e] = place_on_edge(mesh, creases, Edge(e), smooth_edge);
  });
  return places;
}

// Catmull's and Clark's scheme on polygons [Catmull78]: the places of the old vertices, of the edges, then of the
// living faces.
//
//      o---o            f        face: the mean f of its corners
//      | f |         a--x--b     edge: (a + b + f + g) / 4
//      o---o            g        vertex of valence n: (Q + 2 R + (n - 3) v) / n, Q the mean of the faces, R of the
//                                middles of the edges
//   limit, of a mesh of quads: (n n v + 4 sum of the neighbours + sum of the vertices across the quads) / (n (n + 5))
Places catmull_clark_places(const Mesh& mesh, const Creases& creases, const std::vector<std::uint32_t>& centre_of) {
  const std::uint32_t vertices = mesh.vertex_slots(), edges = mesh.edge_slots();
  const std::size_t first_centre = std::size_t{vertices} + edges;
  Places places = room_for(first_centre + mesh.live().faces);
  place_centres(mesh, centre_of, places);
  const auto centre = [&](Halfedge h) -> const glm::dvec3& {
    const std::uint32_t f = mesh.face(h).index;
    return places[first_centre + (centre_of.empty() ? f : centre_of[f])];
  };
  const auto smooth_edge = [&](Halfedge h) {
    return (0.25 * mesh.position(mesh.from(h)) + 0.25 * mesh.position(mesh.to(h))) +
           (0.25 * centre(h) + 0.25 * centre(twin(h)));
  };
  for_each_slot(edges, [&](std::uint32_t e) {
    places[std::size_t{vertices} + e] = place_on_edge(mesh, creases, Edge(e), smooth_edge);
  });
  // Q / n + 2 R / n + (n - 3) v / n, where R is the mean of (v + w) / 2: v weighs (n - 2) / n in all.
  const auto smooth_vertex = [&](Vertex v) {
    const double n = neighbour_count(mesh, v), share = 1 / (n * n);
    glm::dvec3 sum = ((n - 2) / n) * mesh.position(v);
    for (const Halfedge h : outgoing(mesh, v)) sum += share * centre(h) + share * mesh.position(mesh.to(h));
    return sum;
  };
  place_vertices(mesh, places, [&](Vertex v) { return place_of_vertex(mesh, creases, v, smooth_vertex); });
  return places;
}

Places catmull_clark_limit(const Mesh& mesh, const Creases& creases) {
  return limit_by(mesh, creases, Scheme::catmull_clark, [&](Vertex v) {
    const double n = neighbour_count(mesh, v), share = 1 / (n * (n + 5));
    glm::dvec3 sum = (n / (n + 5)) * mesh.position(v);
    for (const Halfedge h : outgoing(mesh, v)) {
      const Vertex across = mesh.to(mesh.next(h));
      sum += (4 * share) * mesh.position(mesh.to(h)) + share * mesh.position(across);
    }
    return sum;
  });
}

// Every vertex stays; new ones lie in the middle of edges and, `with_centres`, at the mean of the corners of faces.
Places midpoint_places(const Mesh& mesh, const std::vector<std::uint32_t>& centre_of, bool with_centres) {
  const std::uint32_t vertices = mesh.vertex_slots(), edges = mesh.edge_slots();
  Places places = room_for(std::size_t{vertices} + edges + (with_centres ? mesh.live().faces : 0));
  for_each_slot(vertices, [&](std::uint32_t i) { places[i] = mesh.position(Vertex(i)); });
  for_each_slot(edges, [&](std::uint32_t e) {
    const auto [a, b] = ends(mesh, Edge(e));
    places[std::size_t{vertices} + e] = 0.5 * mesh.position(a) + 0.5 * mesh.position(b);
  });
  if (with_centres) place_centres(mesh, centre_of, places);
  return places;
}

}  // namespace

void sqrt3_places(const Mesh& mesh, const Creases& creases, bool cuts_creases, Places& places) {
  place_vertices(mesh, places, [&](Vertex v) {
    const glm::dvec3& here = mesh.position(v);
    if (mesh.is_isolated(v)) return here;
    const RuleAt at = rule_at(mesh, creases, v);
    if (at.rule == VertexRule::smooth) return around<sqrt3_weight>(mesh, v);
    if (at.rule == VertexRule::corner || !cuts_creases) return here;
    return here * (19.0 / 27) + (mesh.position(at.along[0]) * (4.0 / 27) + mesh.position(at.along[1]) * (4.0 / 27));
  });
}

glm::dvec3 third_of_crease(const Mesh& mesh, const Creases& creases, Vertex a, Vertex b) {
  const glm::dvec3 &near = mesh.position(a), &far = mesh.position(b);
  const RuleAt at = rule_at(mesh, creases, a);
  if (at.rule != VertexRule::crease) return near * (2.0 / 3) + far / 3.0;
  const glm::dvec3& before = mesh.position(at.along[0] == b ? at.along[1] : at.along[0]);
  return near * (16.0 / 27) + (before / 27.0 + far * (10.0 / 27));
}

Places split_places(const Mesh& mesh, const Creases& creases, Scheme scheme, const SplitNumbers& numbers) {
  if (scheme == Scheme::loop) return loop_places(mesh, creases);
  if (scheme == Scheme::catmull_clark) return catmull_clark_places(mesh, creases, numbers.centre_of());
  return midpoint_places(mesh, numbers.centre_of(), numbers.split() == Split::into_quads);
}

Places limit_places(const Mesh& mesh, const Creases& creases, Scheme scheme) {
  if (scheme == Scheme::catmull_clark) return catmull_clark_limit(mesh, creases);
  const auto loop = [&](Vertex v) { return around<loop_limit_weight>(mesh, v); };
  const auto sqrt3 = [&](Vertex v) { return around<sqrt3_limit_weight>(mesh, v); };
  return scheme == Scheme::loop ? limit_by(mesh, creases, scheme, loop) : limit_by(mesh, creases, scheme, sqrt3);
}

}  // namespace ryosen::subdivide
