// Seams that are weighed: their points may leave along them, as long as both charts and the line stay what they are.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <unordered_map>
#include <vector>

#include "ryosen/algo/remesh/features.h"
#include "ryosen/mesh/edit.h"

namespace ryosen::remesh {

// A step is asked about, and if it is done, told.
class SeamLines {
 public:
  // They outlive it.
  SeamLines(Edit& edit, const Features& features) : edit_(edit), mesh_(edit.mesh()), features_(features) {}

  // Whether a halfedge may collapse into its end: it and its start are weighed, on both sides the values of the start
  // become those of the end, no chart vanishes, and each point that the seam had there stays within reach of it.
  bool allows_collapse(Halfedge h, double reach);
  // Before it does: all corners at its start come to share the value of their side.
  void share_values(Halfedge h);
  // The collapse that was asked about last is done.
  void collapsed();
  // A weighed edge was split at this vertex, which made another.
  void split(Edge e, Vertex middle);

 private:
  using Places = std::vector<glm::dvec3>;

  bool values_allow(Halfedge h) const;
  Halfedge other_weighed(Halfedge h) const;
  bool stays_near(std::span<const glm::dvec3> places, const glm::dvec3& a, const glm::dvec3& b, double reach) const;

  Edit& edit_;
  const Mesh& mesh_;
  const Features& features_;
  std::unordered_map<Edge, Places> left_;  // by edge: points that have left the seam where it lies
  // The collapse asked about last:
  Places places_;
  Edge gone_, longer_, beside_;
};

}  // namespace ryosen::remesh
