// What a view is framed by: the vertices with edges, and isolated ones that are not far from them.
#pragma once

#include <functional>
#include <initializer_list>
#include <span>

#include "core/mesh/mesh.h"
#include "core/view/camera.h"

namespace ryosen {

using PlacesVisit = std::function<void(std::span<const glm::dvec3>)>;

// Calls visit(places) of the vertices that have edges, or of all where none has. O(n).
void with_places_of_edges(const Mesh& mesh, const PlacesVisit& visit);

// The same with isolated vertices up to four diagonals of their box from its middle, so that the mesh takes an eighth of
// the view at least: one that a scanner left in a corner of its room would make it a dot.
void with_places_to_frame(const Mesh& mesh, const PlacesVisit& visit);

// The camera in the same direction that shows these places of all of these meshes.
Camera framing(std::initializer_list<const Mesh*> meshes, const Camera& from, Size view);

}  // namespace ryosen
