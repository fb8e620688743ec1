// The gesture that goes on: for the files that begin and end gestures.
#pragma once

#include <functional>

#include "app/editor/commands/text/command.h"
#include "app/editor/shown/gesturing.h"
#include "app/editor/shown/snapping.h"

namespace ryosen {

struct Gesturing::Ongoing {
  TransformGesture transform;
  std::vector<glm::dvec3> places;  // of all vertices, as they are drawn
  TouchedElements touched;         // by what is moved
  std::vector<std::uint32_t> triangles;
  std::vector<Face> spoilt;
  std::optional<PassedOver> own;       // made where something is to be snapped to
  std::optional<RoundStep> step = {};  // of the ground, in the same way
  glm::dvec2 pixel{0};                 // of the window, where the pointer was last
  Modifiers modifiers = {};
  struct Made {
    // Makes it so far away; none: where it was made.
    std::function<Command(const std::optional<glm::dvec3>& way)> command;
    Text unmoved = {};                    // said where it ends without a movement
    Text given_up = {};                   // and where it is given up
    std::uint32_t first_made = no_index;  // of the vertices
    std::vector<Face> faces = {};         // without extent until something is moved; ascending
    Elements selected = {};               // in the end
  };
  std::optional<Made> made = {};  // of one that moves what is made by a line, which is on trial
  // Points that would be listed as coincident only by what is on trial, once they are known.
  std::optional<std::vector<Vertex>> unlisted = {};
};

}  // namespace ryosen
