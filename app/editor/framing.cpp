#include "app/editor/framing.h"

#include <glm/geometric.hpp>
#include <vector>

namespace ryosen {

namespace {

struct SortedPlaces {
  std::vector<glm::dvec3> with_edges, isolated;
};

bool all_have_edges(const Mesh& mesh) {
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i)
    if (!mesh.is_alive(Vertex(i)) || mesh.is_isolated(Vertex(i))) return false;
  return true;
}

SortedPlaces sorted_places(const Mesh& mesh) {
  SortedPlaces places;
  places.with_edges.reserve(mesh.vertex_slots());
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i)
    if (const Vertex v(i); mesh.is_alive(v))
      (mesh.is_isolated(v) ? places.isolated : places.with_edges).push_back(mesh.position(v));
  return places;
}

// Of places that are not finite none is near.
void add_near(std::vector<glm::dvec3>& places, std::span<const glm::dvec3> others) {
  constexpr double most_diagonals = 4;
  const Box box = bounds_of(places);
  const double most = most_diagonals * length_of(box.highest - box.lowest);
  for (const glm::dvec3& place : others)
    if (length_of(place - box.middle()) <= most) places.push_back(place);
}

}  // namespace

void with_places_of_edges(const Mesh& mesh, const PlacesVisit& visit) {
  if (all_have_edges(mesh)) return visit(mesh.positions());
  const SortedPlaces places = sorted_places(mesh);
  visit(places.with_edges.empty() ? places.isolated : places.with_edges);
}

void with_places_to_frame(const Mesh& mesh, const PlacesVisit& visit) {
  if (all_have_edges(mesh)) return visit(mesh.positions());
  SortedPlaces places = sorted_places(mesh);
  if (places.with_edges.empty()) return visit(places.isolated);
  add_near(places.with_edges, places.isolated);
  visit(places.with_edges);
}

Camera framing(std::initializer_list<const Mesh*> meshes, const Camera& from, Size view) {
  const double aspect = static_cast<double>(view.width) / view.height;
  Camera found = from;
  if (meshes.size() == 1) {
    with_places_to_frame(**meshes.begin(), [&](auto places) { found = fitted(from, places, aspect); });
    return found;
  }
  std::vector<glm::dvec3> all;
  for (const Mesh* const mesh : meshes)
    with_places_to_frame(*mesh, [&](auto places) { all.insert(all.end(), places.begin(), places.end()); });
  return fitted(from, all, aspect);
}

}  // namespace ryosen
