// Many vertices taken out one after another, where unite_edge may: at the cost of what is near each vertex.
//
// By itself each call reads the faces at the vertex, which is quadratic where they all lie along one face. Here what is
// known of a face is kept while it loses corners.
#pragma once

#include <cstdint>

#include "core/mesh/edit.h"
#include "core/ops/rules/local_facts.h"

namespace ryosen {

class UniteSeries {
 public:
  explicit UniteSeries(Edit& edit) : edit_(edit) {}

  // Takes the vertex out as unite_edge does; false where that is not legal. In between nothing else changes the mesh.
  bool unite(Vertex v);
  // Corners and faces that were looked at: what the work is measured by.
  std::uint64_t looks() const { return looks_; }

 private:
  enum class Answer { yes, no, unsure };
  Answer answer_of(Vertex v);
  Answer answer_of_face(Face f, Face beyond, Vertex a, Vertex b);
  std::uint32_t corner_count(Face f);

  const Mesh& mesh() const { return edit_.mesh(); }

  Edit& edit_;
  LocalFacts known_;
  std::uint64_t looks_ = 0;
};

}  // namespace ryosen
