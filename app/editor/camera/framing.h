// Chooses the camera that shows a mesh: of one that was just opened its direction, and the place from which all of it
// lies in the free part of a view: all vertices with edges, and isolated ones that are not far from them.
#pragma once

#include <functional>
#include <initializer_list>
#include <optional>
#include <span>

#include "app/editor/camera/view_state.h"
#include "ryosen/mesh/mesh.h"
#include "ryosen/scene/view/camera.h"

namespace ryosen {

// From the front, slightly above and right, so that three sides of most shapes are visible; to be fitted.
Camera first_camera();
// The same, but turned by as little as it takes where a small closed surface would show hardly more than one flat side,
// as if it were a single face.
Camera first_camera_of(const Mesh& mesh);

using PlacesVisit = std::function<void(std::span<const glm::dvec3>)>;

// Calls visit(places) of the vertices that have edges, or of all where none has. O(n).
void with_places_of_edges(const Mesh& mesh, const PlacesVisit& visit);

// The same with isolated vertices up to four diagonals of their box from its middle, so that the mesh takes an eighth
// of the view at least: one that a scanner left in a corner of its room would make it a dot.
void with_places_to_frame(const Mesh& mesh, const PlacesVisit& visit);

// The parts of a view that something lies over, in its pixels: strips along its sides, and the axes in its upper
// right corner, in the circle within that square. A camera keeps what it shows off the strips, unless they leave
// hardly any of the view, and off the axes where one of its places would lie there.
struct Covered {
  double left = 0, right = 0, above = 0;
  std::optional<PixelRect> corner;
};

// The strips as shares of the view; none where they leave hardly any of it.
CoveredShares shares_beside(const Covered& covered, Size view);
// The camera in the same direction that shows places in the free part of a view.
Camera fitted_beside(const Covered& covered, const Camera& from, std::span<const glm::dvec3> places, Size view);
// Whether a camera shows all of these that are finite beside the strips.
bool shows_all(const Camera& camera, Size view, const Covered& covered, std::span<const glm::dvec3> places);

// The camera in the same direction that shows the places to frame of all of these meshes.
Camera framing(std::initializer_list<const Mesh*> meshes, const Camera& from, Size view, const Covered& covered = {});

}  // namespace ryosen
