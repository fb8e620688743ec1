#include "ryosen/algo/simplify/nearer_swaps.h"

#include <algorithm>

#include "ryosen/base/parallel.h"
#include "ryosen/geometry/trees/primitive.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/ops/swap_edge.h"

namespace ryosen {

namespace {

constexpr int most_rounds = 6;
// A swap gains at least such a share of the sum, so that rounding does not swap an edge to and fro.
constexpr double least_gain = 1e-6;

bool is_plain_triangle(const Mesh& mesh, Face f) {
  const Halfedge h = mesh.halfedge(f);
  return !mesh.has_rings(f) && mesh.next(mesh.next(h)) == mesh.prev(h);
}

Primitive triangle_primitive(const Mesh& mesh, Face f) {
  const Halfedge h = mesh.halfedge(f);
  return Primitive::triangle(mesh.from(h).index, mesh.to(h).index, mesh.from(mesh.prev(h)).index, f.index);
}

std::vector<glm::dvec3> places_of(const CollapseSurface& surface) {
  std::vector<glm::dvec3> places;
  places.reserve(surface.mesh().vertex_slots());
  for (std::uint32_t i = 0; i < surface.mesh().vertex_slots(); ++i) places.push_back(surface.place(Vertex(i)));
  return places;
}

// The triangles of a mesh that lie at finite places.
std::vector<Primitive> triangles_of(const Mesh& mesh, std::span<const glm::dvec3> places) {
  std::vector<Primitive> triangles;
  triangles.reserve(mesh.face_slots());
  for (const Face f : live_faces(mesh)) {
    if (!is_plain_triangle(mesh, f)) continue;
    const Primitive t = triangle_primitive(mesh, f);
    if (std::all_of(t.vertices.begin(), t.vertices.end(), [&](std::uint32_t v) { return is_finite(places[v]); }))
      triangles.push_back(t);
  }
  return triangles;
}

double area_of(std::span<const glm::dvec3> places, const Primitive& t) {
  const glm::dvec3& a = places[t.vertices[0]];
  return glm::length(glm::cross(places[t.vertices[1]] - a, places[t.vertices[2]] - a)) / 2;
}

// How far both surfaces lie from each other about each edge, and what a swap would make of it. An integral over a face
// of the surface before is taken from its corners and its middle, one over a face of now from the middles of its sides;
// both are exact for polynomials of degree two.
class NearerSwaps {
 public:
  NearerSwaps(Edit& edit, const CollapseSurface& surface, const SurfaceBefore& before)
      : edit_(edit),
        mesh_(edit.mesh()),
        surface_(surface),
        before_(before),
        places_(places_of(surface)),
        next_(before.samples.size(), no_index),
        square_at_middle_(mesh_.edge_slots(), unknown) {}

  // Gives each sample to the face that it is nearest to; false where it is cancelled.
  bool assign(Progress& progress) {
    const TriangleTree tree(places_, triangles_of(mesh_, places_), 1);
    const auto count = static_cast<std::uint32_t>(before_.samples.size());
    std::vector<std::uint32_t> faces(count, no_index);
    constexpr std::uint32_t piece = 1 << 16;  // between two looks at whether it is cancelled
    for (std::uint32_t first = 0; first < count && !tree.is_empty(); first += piece) {
      if (!progress.go_on()) return false;
      const std::uint32_t here = std::min(piece, count - first);
      for_each_part(here, threads_for(count), [&](unsigned, std::uint32_t begin, std::uint32_t end) {
        for (std::uint32_t i = first + begin; i < first + end; ++i)
          faces[i] = tree.owner(tree.nearest(before_.samples[i].place).triangle);
      });
    }
    first_.assign(mesh_.face_slots(), no_index);
    for (std::uint32_t i = 0; i < count; ++i)
      if (faces[i] != no_index) put(Face(faces[i]), i);
    return true;
  }
  // Whether it was swapped.
  bool try_edge(Edge e) {
    const Halfedge h = halfedge(e), o = twin(h);
    if (!surface_.may_swap(h)) return false;
    const Quad quad{mesh_.from(h), mesh_.to(h), mesh_.from(mesh_.prev(h)), mesh_.from(mesh_.prev(o))};
    if (!comes_nearer(h, quad) || surface_.swap_spoils_face(h) || !SwapEdge{h}.is_legal(mesh_)) return false;
    swap(h, quad);
    return true;
  }
  // The sides of both faces of an edge.
  template <class Visit>
  void for_each_side(Edge e, Visit visit) const {
    for (unsigned side : {0u, 1u})
      for (Halfedge h : {mesh_.next(halfedge(e, side)), mesh_.prev(halfedge(e, side))}) visit(edge(h));
  }

 private:
  static constexpr double unknown = -1;
  // Two triangles about an edge, a b c and b a d, and those about the other diagonal.
  struct Quad {
    Vertex a, b, c, d;
  };

  double square(const Primitive& triangle, std::uint32_t sample) const {
    const double distance = nearest_place(places_, triangle, before_.samples[sample].place).distance;
    return distance * distance;
  }
  template <class Visit>
  void for_each_sample(Face f, Visit visit) const {
    for (std::uint32_t s = first_[f.index]; s != no_index;) {
      const std::uint32_t next = next_[s];
      visit(s);
      s = next;
    }
  }
  void put(Face f, std::uint32_t sample) {
    next_[sample] = first_[f.index];
    first_[f.index] = sample;
  }
  Primitive triangle(Vertex a, Vertex b, Vertex c) const { return Primitive::triangle(a.index, b.index, c.index, 0); }
  double area(Vertex a, Vertex b, Vertex c) const { return area_of(places_, triangle(a, b, c)); }
  // Of the place in the middle of two from the surface before.
  double square_between(Vertex a, Vertex b) const {
    const glm::dvec3 middle = (places_[a.index] + places_[b.index]) / 2.0;
    if (before_.triangles.is_empty() || !is_finite(middle)) return 0;
    const double distance = before_.triangles.nearest(middle).distance;
    return distance * distance;
  }
  double square_at_middle(Halfedge h) {
    double& square = square_at_middle_[edge(h).index];
    if (square == unknown) square = square_between(mesh_.from(h), mesh_.to(h));
    return square;
  }
  // Whether the edge of two faces, swapped, makes both surfaces come nearer to each other.
  bool comes_nearer(Halfedge h, const Quad& quad) {
    const auto [a, b, c, d] = quad;
    const Primitive was_left = triangle(a, b, c), was_right = triangle(b, a, d);
    const Primitive new_a = triangle(c, a, d), new_b = triangle(d, b, c);
    double was = 0, is = 0;
    for (Halfedge side : {h, twin(h)})
      for_each_sample(mesh_.face(side), [&](std::uint32_t s) {
        was += before_.samples[s].area * std::min(square(was_left, s), square(was_right, s));
        is += before_.samples[s].area * std::min(square(new_a, s), square(new_b, s));
      });
    const double left = area(a, b, c) / 3, right = area(b, a, d) / 3, at_a = area(c, a, d) / 3,
                 at_b = area(d, b, c) / 3;
    const double bc = square_at_middle(mesh_.next(h)), ca = square_at_middle(mesh_.prev(h));
    const double ad = square_at_middle(mesh_.next(twin(h))), db = square_at_middle(mesh_.prev(twin(h)));
    was += left * (bc + ca) + right * (ad + db) + (left + right) * square_at_middle(h);
    is += at_a * (ca + ad) + at_b * (bc + db);
    const double wanted = was * (1 - least_gain);
    return is < wanted && is + (at_a + at_b) * square_between(c, d) < wanted;
  }
  void swap(Halfedge h, const Quad& quad) {
    const auto [a, b, c, d] = quad;
    std::vector<std::uint32_t> samples;
    for (Face f : {mesh_.face(h), mesh_.face(twin(h))}) {
      for_each_sample(f, [&](std::uint32_t s) { samples.push_back(s); });
      first_[f.index] = no_index;
    }
    SwapEdge{h}.apply(edit_);
    square_at_middle_[edge(h).index] = unknown;
    const bool is_first = mesh_.from(mesh_.prev(h)) == a;
    const Face with_a = mesh_.face(is_first ? h : twin(h)), with_b = mesh_.face(is_first ? twin(h) : h);
    const Primitive new_a = triangle(c, a, d), new_b = triangle(d, b, c);
    for (const std::uint32_t s : samples) put(square(new_a, s) <= square(new_b, s) ? with_a : with_b, s);
  }

  Edit& edit_;
  const Mesh& mesh_;
  const CollapseSurface& surface_;
  const SurfaceBefore& before_;
  std::vector<glm::dvec3> places_;        // by vertex
  std::vector<std::uint32_t> first_;      // by face, its first sample
  std::vector<std::uint32_t> next_;       // by sample, the next one of its face
  std::vector<double> square_at_middle_;  // by edge, or unknown
};

}  // namespace

SurfaceBefore surface_before(const CollapseSurface& surface) {
  const Mesh& mesh = surface.mesh();
  SurfaceBefore before;
  const std::vector<glm::dvec3> places = places_of(surface);
  const std::vector<Primitive> triangles = triangles_of(mesh, places);
  std::vector<double> areas(mesh.vertex_slots());
  for (const Primitive& t : triangles) {
    const double area = area_of(places, t);
    glm::dvec3 sum{0.0};
    for (const std::uint32_t v : t.vertices) {
      areas[v] += area / 12;
      sum += places[v];
    }
    before.samples.push_back({sum / 3.0, area * 3 / 4});
  }
  for (std::uint32_t v = 0; v < areas.size(); ++v)
    if (areas[v] > 0) before.samples.push_back({places[v], areas[v]});
  before.triangles = TriangleTree(places, triangles, 1);
  return before;
}

std::size_t swap_nearer(Edit& edit, const CollapseSurface& surface, const SurfaceBefore& before, Progress& progress) {
  NearerSwaps swaps(edit, surface, before);
  if (!swaps.assign(progress)) return 0;
  const Mesh& mesh = edit.mesh();
  std::vector<std::uint8_t> is_asked(mesh.edge_slots(), 1);
  std::size_t swapped = 0, swapped_before = 0;
  for (int round = 0; round < most_rounds; ++round) {
    swapped_before = swapped;
    for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
      if (i % 1024 == 0 && !progress.go_on()) return swapped;
      const Edge e(i);
      if (!mesh.is_alive(e) || !std::exchange(is_asked[i], std::uint8_t{0}) || !swaps.try_edge(e)) continue;
      swaps.for_each_side(e, [&](Edge side) { is_asked[side.index] = 1; });
      ++swapped;
    }
    if (swapped == swapped_before) break;
  }
  return swapped;
}

}  // namespace ryosen
