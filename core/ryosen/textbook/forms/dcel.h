// The doubly connected edge list of the source texts: vertices with incident_edge, half-edges with origin, twin, next,
// prev and face, faces with an outer component and inner components.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <utility>
#include <vector>

#include "ryosen/base/handle.h"
#include "ryosen/textbook/forms/walk.h"

namespace ryosen::forms {

// The three tables, as the source texts name their fields.
struct DcelRecords {
  struct VertexRecord {
    glm::dvec3 coordinates{0.0};
    std::uint32_t incident_edge = no_index;

    friend bool operator==(const VertexRecord&, const VertexRecord&) = default;
  };
  struct HalfEdgeRecord {
    std::uint32_t origin = no_index, twin = no_index, next = no_index, prev = no_index, face = no_index;

    friend bool operator==(const HalfEdgeRecord&, const HalfEdgeRecord&) = default;
  };
  struct FaceRecord {
    std::uint32_t outer_component = no_index;
    std::vector<std::uint32_t> inner_components = {};

    friend bool operator==(const FaceRecord&, const FaceRecord&) = default;
  };
  std::vector<VertexRecord> vertices;
  std::vector<HalfEdgeRecord> half_edges;
  std::vector<FaceRecord> faces;

  friend bool operator==(const DcelRecords&, const DcelRecords&) = default;
};

// Every half-edge has a twin; outside the surface its face is none. The handle of an edge is one of its half-edges.
class Dcel : public LinkedForm<Dcel> {
 public:
  explicit Dcel(const Mesh& mesh);
  // Every row is in use, and the links are those of a mesh.
  explicit Dcel(DcelRecords records) : records_(std::move(records)) {}

  const DcelRecords& records() const { return records_; }

  std::size_t bytes() const override;
  Mesh to_mesh() const override;
  Fields record(Element own) const override;

  // The interface of walk.h.
  std::uint32_t from(std::uint32_t h) const { return records_.half_edges[h].origin; }
  std::uint32_t next(std::uint32_t h) const { return records_.half_edges[h].next; }
  std::uint32_t prev(std::uint32_t h) const { return records_.half_edges[h].prev; }
  std::uint32_t pair(std::uint32_t h) const { return records_.half_edges[h].twin; }
  std::uint32_t face(std::uint32_t h) const { return records_.half_edges[h].face; }
  std::uint32_t at_vertex(std::uint32_t v) const { return records_.vertices[v].incident_edge; }
  std::uint32_t at_face(std::uint32_t f) const { return records_.faces[f].outer_component; }
  const std::vector<std::uint32_t>& inner(std::uint32_t f) const { return records_.faces[f].inner_components; }

 private:
  DcelRecords records_;
};

}  // namespace ryosen::forms
