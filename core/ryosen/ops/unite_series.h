// Many vertices taken out one after another, where unite_edge may: at the cost of what is near each vertex.
//
// By itself each call reads the faces at the vertex, which is quadratic where they all lie along one face. Here what is
// known of a face is kept while it loses corners.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "ryosen/ops/op.h"
#include "ryosen/ops/rules/local_facts.h"

namespace ryosen {

class UniteSeries {
 public:
  explicit UniteSeries(Edit& edit) : edit_(&edit) {}

  // The first rule that unite_edge breaks, as its check() has it. In between nothing else changes the mesh, but for
  // what is to be forgotten.
  std::optional<Rule> broken_rule(Vertex v);
  // Takes out the vertex that was asked about last, which may be.
  void apply(Vertex v);
  // Both; false where that is not legal.
  bool unite(Vertex v);
  void forget(const OpEffect& other);
  // Corners and faces that were looked at: what the work is measured by.
  std::uint64_t looks() const { return looks_; }

 private:
  // A face at the vertex loses a corner, breaks a rule, or must be checked by itself.
  enum class Answer { yes, no, unsure };
  Answer answer_of_face(Face f, Face beyond, Vertex a, Vertex b);
  std::uint32_t corner_count(Face f);

  const Mesh& mesh() const { return edit_->mesh(); }

  Edit* edit_;
  LocalFacts known_;
  bool is_sure_ = false;  // of the last answer, that every face loses a corner
  std::uint64_t looks_ = 0;
};

// The ends of these edges that have not two edges as it is, ascending.
std::vector<Vertex> ends_with_more_edges(const Mesh& mesh, std::span<const Element> elements);
// Takes out those that have two edges now, where unite_edge may; returns how many.
std::size_t unite_ends(Edit& edit, std::span<const Vertex> ends);

}  // namespace ryosen
