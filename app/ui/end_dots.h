// The vertices at the ends of edges whose lines would hide the dots that the surface has there.
#pragma once

#include <glm/vec3.hpp>
#include <map>
#include <span>

#include "app/editor/shown/gesturing.h"
#include "render/overlay.h"
#include "render/palette.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

class EndDots {
 public:
  explicit EndDots(const Mesh& mesh, const Gesturing& gesturing) : m_(mesh), places_(gesturing.drawn_positions()) {}

  void add(Edge e);
  void draw(Theme theme, Overlay& overlay) const;

 private:
  const Mesh& m_;
  std::span<const glm::dvec3> places_;
  std::map<Vertex, double> room_;  // the length of the shortest of its edges
};

}  // namespace ryosen
