// The vertices at the ends of edges whose lines would hide the dots that the surface has there.
#pragma once

#include <glm/vec3.hpp>
#include <map>
#include <span>

#include "render/overlay.h"
#include "render/palette.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

class EndDots {
 public:
  EndDots(const Mesh& mesh, std::span<const glm::dvec3> places) : m_(mesh), places_(places) {}

  void add(Edge e);
  void draw(Theme theme, Overlay& overlay) const;

 private:
  const Mesh& m_;
  std::span<const glm::dvec3> places_;
  std::map<Vertex, double> room_;  // the length of the shortest of its edges
};

}  // namespace ryosen
