// The three tables of the doubly connected edge list, as the source texts name their fields.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "ryosen/base/handle.h"

namespace ryosen::forms {

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

}  // namespace ryosen::forms
