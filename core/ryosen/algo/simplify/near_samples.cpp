#include "ryosen/algo/simplify/near_samples.h"

#include <algorithm>
#include <utility>

#include "ryosen/base/parallel.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen {

namespace {

bool is_plain_triangle(const Mesh& mesh, Face f) {
  const Halfedge h = mesh.halfedge(f);
  return !mesh.has_rings(f) && mesh.next(mesh.next(h)) == mesh.prev(h);
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
    : input_(input),
      surface_(surface),
      places_(surface.mesh().vertex_slots()),
      vertex_areas_(input.vertex_slots()),
      next_(count(), no_index) {
  for (const Vertex v : live_vertices(surface.mesh())) places_[v.index] = surface.place(v);
  for (const Face f : live_faces(input_)) {
    if (!is_sampled(f)) continue;
    const auto area = static_cast<float>(sample(f.index).area / 9);  // a twelfth of the triangle
    for (const std::uint32_t v : triangle_primitive(input_, f).vertices) vertex_areas_[v] += area;
  }
}

bool NearSamples::is_sampled(Face f) const {
  if (!input_.is_alive(f) || !is_plain_triangle(input_, f)) return false;
  const Primitive t = triangle_primitive(input_, f);
  return std::all_of(t.vertices.begin(), t.vertices.end(),
                     [&](std::uint32_t v) { return is_finite(input_.position(Vertex(v))); });
}

NearSamples::Sample NearSamples::sample(std::uint32_t i) const {
  const auto place = [&](std::uint32_t v) { return surface_.scale().scaled(input_.position(Vertex(v))); };
  const std::uint32_t faces = input_.face_slots();
  if (i >= faces) return {place(i - faces), vertex_areas_[i - faces]};
  const auto& [a, b, c] = triangle_primitive(input_, Face(i)).vertices;
  const glm::dvec3 x = place(a), y = place(b), z = place(c);
  return {(x + y + z) / 3.0, glm::length(glm::cross(y - x, z - x)) * 3 / 8};
}

bool NearSamples::assign(std::span<const Vertex> hints, Progress& progress) {
  const Mesh& mesh = surface_.mesh();
  const std::vector<Primitive> triangles = plain_triangles(mesh, places_);
  const TriangleTree tree(places_, triangles, 1);
  std::vector<std::uint32_t> triangle_at(hints.empty() ? 0 : mesh.vertex_slots(), no_index);
  if (!hints.empty())
    for (std::uint32_t t = 0; t < tree.size(); ++t)
      for (const std::uint32_t v : tree.corners(t)) triangle_at[v] = t;
  const std::uint32_t faces = input_.face_slots();
  const auto hint_of = [&](std::uint32_t i) {
    if (hints.empty()) return no_index;
    const Vertex v = i < faces ? input_.from(input_.halfedge(Face(i))) : Vertex(i - faces);
    return hints[v.index] ? triangle_at[hints[v.index].index] : no_index;
  };
  std::vector<std::uint32_t> faces_of(count(), no_index);
  constexpr std::uint32_t piece = 1 << 16;  // between two looks at whether it is cancelled
  for (std::uint32_t first = 0; first < count() && !tree.is_empty(); first += piece) {
    if (!progress.go_on()) return false;
    const std::uint32_t here = std::min(piece, count() - first);
    for_each_part(here, threads_for(count()), [&](unsigned, std::uint32_t begin, std::uint32_t end) {
      for (std::uint32_t i = first + begin; i < first + end; ++i)
        if (i < faces ? is_sampled(Face(i)) : vertex_areas_[i - faces] > 0)
          faces_of[i] = tree.owner(tree.nearest(sample(i).place, hint_of(i)).triangle);
    });
  }
  first_.assign(mesh.face_slots(), no_index);
  for (std::uint32_t i = 0; i < count(); ++i)
    if (faces_of[i] != no_index) give(Face(faces_of[i]), i);
  return true;
}

void NearSamples::take(Face f, std::vector<std::uint32_t>& taken) {
  for_each(f, [&](std::uint32_t i) { taken.push_back(i); });
  first_[f.index] = no_index;
}

}  // namespace ryosen
