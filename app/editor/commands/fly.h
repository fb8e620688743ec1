// Moves the camera to elements, to a side from which they are seen.
#pragma once

#include <span>

#include "ryosen/base/element.h"

namespace ryosen {

class Findings;
class Framing;
struct ViewState;

// Shows elements with all vertices around them, centred; all of the mesh where there are none. Looks on in the same
// direction if they are seen from there, else along their normals, else along the next of other directions from which
// they are; of many elements a sample is asked about.
void fly_to(Findings& findings, ViewState& view, Framing& framing, std::span<const Element> elements);

// Leaves the camera alone if the middle of an element is seen; else puts it into the middle of the view at the same
// distance, or turns about it until it is seen.
void keep_in_sight(Findings& findings, ViewState& view, Framing& framing, const Element& element);

}  // namespace ryosen
