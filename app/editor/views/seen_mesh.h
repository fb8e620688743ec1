// A mesh as a view in space shows it: all that its picture and its labels are made from, but for what belongs to the
// mesh that is edited.
#pragma once

#include <glm/vec3.hpp>
#include <span>

namespace ryosen {

class Document;
class Findings;
struct Preferences;
struct ViewState;

struct SeenMesh {
  const Document& document;
  Findings& findings;
  const ViewState& view;
  const Preferences& preferences;
  std::span<const glm::dvec3> places;  // where its vertices are drawn
};

}  // namespace ryosen
