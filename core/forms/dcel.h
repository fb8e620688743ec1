// The doubly connected edge list of the source texts: vertices with incident_edge, half-edges with origin, twin, next, prev and
// face, faces with an outer component and inner components.
#pragma once

#include <glm/vec3.hpp>

#include "core/forms/form.h"

namespace ryosen::forms {

// Every half-edge has a twin; outside the surface its face is none. The handle of an edge is one of its half-edges.
class Dcel : public Form {
 public:
  explicit Dcel(const Mesh& mesh);

  std::size_t bytes() const override;
  Mesh to_mesh() const override;
  std::uint32_t find_edge(std::uint32_t a, std::uint32_t b) const override;
  bool answer(Relation relation, std::uint32_t element, Answer& out) const override;
  Fields record(Element own) const override;

  // The interface of walk.h.
  std::uint32_t from(std::uint32_t h) const { return half_edges_[h].origin; }
  std::uint32_t next(std::uint32_t h) const { return half_edges_[h].next; }
  std::uint32_t prev(std::uint32_t h) const { return half_edges_[h].prev; }
  std::uint32_t pair(std::uint32_t h) const { return half_edges_[h].twin; }
  std::uint32_t face(std::uint32_t h) const { return half_edges_[h].face; }
  std::uint32_t at_vertex(std::uint32_t v) const { return vertices_[v].incident_edge; }
  std::uint32_t at_face(std::uint32_t f) const { return faces_[f].outer_component; }
  std::uint32_t at_edge(std::uint32_t h) const { return h; }
  const std::vector<std::uint32_t>& inner(std::uint32_t f) const { return faces_[f].inner_components; }

 private:
  struct VertexRecord {
    glm::dvec3 coordinates;
    std::uint32_t incident_edge;
  };
  struct HalfEdgeRecord {
    std::uint32_t origin, twin, next, prev, face;
  };
  struct FaceRecord {
    std::uint32_t outer_component;
    std::vector<std::uint32_t> inner_components;
  };
  std::vector<VertexRecord> vertices_;
  std::vector<HalfEdgeRecord> half_edges_;
  std::vector<FaceRecord> faces_;
};

}  // namespace ryosen::forms
