#include "core/algo/simplify/nearer_swaps.h"

#include <algorithm>

#include "core/base/parallel.h"
#include "core/ops/swap_edge.h"
#include "core/pick/bvh.h"
#include "core/pick/nearest.h"

namespace ryosen {

namespace {

constexpr int most_rounds = 6;
// A swap gains at least such a share of the sum, so that rounding does not swap an edge to and fro.
constexpr double least_gain = 1e-6;

bool is_plain_triangle(const Mesh& mesh, Face f) {
  const Halfedge h = mesh.halfedge(f);
  return !mesh.has_rings(f) && mesh.next(mesh.next(h)) == mesh.prev(h);
}

// The places by the face that each is nearest to, and what a swap would make of their distances.
class NearerSwaps {
 public:
  NearerSwaps(Edit& edit, const CollapseSurface& surface, const std::vector<glm::dvec3>& samples)
      : edit_(edit), mesh_(edit.mesh()), surface_(surface), samples_(samples), next_(samples.size(), no_index) {
    places_.reserve(mesh_.vertex_slots());
    for (std::uint32_t i = 0; i < mesh_.vertex_slots(); ++i) places_.push_back(surface.place(Vertex(i)));
  }

  bool assign(Progress& progress);
  // Whether it was swapped.
  bool try_edge(Edge e);
  // The sides of both faces of an edge.
  template <class Visit>
  void for_each_side(Edge e, Visit visit) const {
    for (unsigned side : {0u, 1u})
      for (Halfedge h : {mesh_.next(halfedge(e, side)), mesh_.prev(halfedge(e, side))}) visit(edge(h));
  }

 private:
  double square(const Primitive& triangle, std::uint32_t sample) const {
    const double distance = nearest_place(places_, triangle, samples_[sample]).distance;
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

  Edit& edit_;
  const Mesh& mesh_;
  const CollapseSurface& surface_;
  const std::vector<glm::dvec3>& samples_;
  std::vector<glm::dvec3> places_;    // by vertex
  std::vector<std::uint32_t> first_;  // by face, its first sample
  std::vector<std::uint32_t> next_;   // by sample, the next one of its face
};

bool NearerSwaps::assign(Progress& progress) {
  std::vector<Primitive> primitives(mesh_.face_slots());
  for (std::uint32_t i = 0; i < mesh_.face_slots(); ++i) {
    const Face f(i);
    if (!mesh_.is_alive(f) || !is_plain_triangle(mesh_, f)) continue;
    const Halfedge h = mesh_.halfedge(f);
    primitives[i] =
        Primitive::triangle(mesh_.from(h).index, mesh_.to(h).index, mesh_.from(mesh_.prev(h)).index, f.index);
  }
  Bvh tree;
  tree.build(places_, std::move(primitives));
  const auto count = static_cast<std::uint32_t>(samples_.size());
  std::vector<std::uint32_t> faces(count, no_index);
  constexpr std::uint32_t piece = 1 << 16;  // between two looks at whether it is cancelled
  for (std::uint32_t first = 0; first < count; first += piece) {
    if (!progress.go_on()) return false;
    const std::uint32_t here = std::min(piece, count - first);
    for_each_part(here, threads_for(count), [&](unsigned, std::uint32_t begin, std::uint32_t end) {
      for (std::uint32_t i = first + begin; i < first + end; ++i)
        if (const auto hit = tree.nearest(places_, samples_[i], std::numeric_limits<double>::infinity()))
          faces[i] = hit->slot;
    });
  }
  first_.assign(mesh_.face_slots(), no_index);
  for (std::uint32_t i = 0; i < count; ++i)
    if (faces[i] != no_index) put(Face(faces[i]), i);
  return true;
}

bool NearerSwaps::try_edge(Edge e) {
  const Halfedge h = halfedge(e), o = twin(h);
  if (!surface_.may_swap(h)) return false;
  const Face left = mesh_.face(h), right = mesh_.face(o);
  const Vertex a = mesh_.from(h), b = mesh_.to(h), c = mesh_.from(mesh_.prev(h)), d = mesh_.from(mesh_.prev(o));
  const Primitive was_left = triangle(a, b, c), was_right = triangle(b, a, d);
  const Primitive new_a = triangle(c, a, d), new_b = triangle(d, b, c);
  double before = 0, after = 0;
  for (Face f : {left, right})
    for_each_sample(f, [&](std::uint32_t s) {
      before += std::min(square(was_left, s), square(was_right, s));
      after += std::min(square(new_a, s), square(new_b, s));
    });
  if (!(after < before * (1 - least_gain)) || surface_.swap_spoils_face(h) || !SwapEdge{h}.is_legal(mesh_))
    return false;
  std::vector<std::uint32_t> theirs;
  for (Face f : {left, right}) {
    for_each_sample(f, [&](std::uint32_t s) { theirs.push_back(s); });
    first_[f.index] = no_index;
  }
  SwapEdge{h}.apply(edit_);
  const bool is_first = mesh_.from(mesh_.prev(h)) == a;
  const Face with_a = mesh_.face(is_first ? h : o), with_b = mesh_.face(is_first ? o : h);
  for (const std::uint32_t s : theirs) put(square(new_a, s) <= square(new_b, s) ? with_a : with_b, s);
  return true;
}

}  // namespace

std::vector<glm::dvec3> sample_places(const CollapseSurface& surface) {
  const Mesh& mesh = surface.mesh();
  std::vector<glm::dvec3> places;
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i)
    if (const Vertex v(i); mesh.is_alive(v) && !mesh.is_isolated(v)) places.push_back(surface.place(v));
  for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
    const Face f(i);
    if (!mesh.is_alive(f) || !is_plain_triangle(mesh, f)) continue;
    const Halfedge h = mesh.halfedge(f);
    places.push_back(
        (surface.place(mesh.from(h)) + surface.place(mesh.to(h)) + surface.place(mesh.from(mesh.prev(h)))) / 3.0);
  }
  std::erase_if(places, [](const glm::dvec3& p) { return !is_finite(p); });
  return places;
}

std::size_t swap_nearer(Edit& edit, const CollapseSurface& surface, const std::vector<glm::dvec3>& samples,
                        Progress& progress) {
  NearerSwaps swaps(edit, surface, samples);
  if (!swaps.assign(progress)) return 0;
  const Mesh& mesh = edit.mesh();
  std::vector<std::uint8_t> is_asked(mesh.edge_slots(), 1);
  std::size_t swapped = 0, before = 0;
  for (int round = 0; round < most_rounds; ++round) {
    before = swapped;
    for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
      const Edge e(i);
      if (!mesh.is_alive(e) || !std::exchange(is_asked[i], std::uint8_t{0}) || !swaps.try_edge(e)) continue;
      swaps.for_each_side(e, [&](Edge side) { is_asked[side.index] = 1; });
      ++swapped;
      if (swapped % 1024 == 0 && !progress.go_on()) return swapped;
    }
    if (swapped == before) break;
  }
  return swapped;
}

}  // namespace ryosen
