// What a movement by hand takes hold of, and what it snaps to.
#pragma once

#include "app/editor/shown/transform_gesture.h"
#include "ryosen/scene/pick/picker.h"

namespace ryosen {

class Mesh;

class Findings;
struct Preferences;
struct ViewState;

// Pixels are those of the view. Of the points that are moved the nearest to the pointer on the screen, if it is near
// and seen, and one that is moved alone wherever it is; else none.
Vertex held_point(Findings& findings, const ViewState& view, const Preferences& preferences,
                  const std::vector<MovedPoint>& moved, glm::dvec2 pixel);

// Of what is not moved itself: a vertex near the pointer, else an edge, else the face under it.
std::optional<SnapTarget> snap_target(Findings& findings, const ViewState& view, const Preferences& preferences,
                                      glm::dvec2 pixel, const PassedOver& own);

// Of the lines on the ground below the mesh. O(vertices).
RoundStep step_of_ground(const Mesh& mesh);

}  // namespace ryosen
