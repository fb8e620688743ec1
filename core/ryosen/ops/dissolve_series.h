// Many edges dissolved one after another: the same faces with the same numbers as by one call each, at the cost of what
// is near each edge.
//
// By itself a call reads both faces and renumbers the higher one, which is quadratic where one face takes in all
// others. Here the smaller of two faces takes over the slot of the larger, and the number that the face goes by is kept
// beside it until the end; what is known of a face is kept while it grows; and two faces that touch more than once are
// not asked about again until one of them has changed. n edges cost n log n looks at corners.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "ryosen/ops/dissolve.h"
#include "ryosen/ops/rules/local_facts.h"

namespace ryosen {

class DissolveSeries {
 public:
  // The extent of a dissolved edge: its whole chain, or that edge alone, as unite_loop has it.
  enum class Takes { chain, edge };
  explicit DissolveSeries(Edit& edit, Takes takes = Takes::chain) : edit_(edit), takes_(takes) {}

  // The first rule that the operator breaks, as check() has it.
  std::optional<Rule> broken_rule(const Dissolve& op);
  // The first warning, for those who take it for a refusal: asked about again, the two faces are refused by it.
  std::optional<Rule> doubt(const Dissolve& op);
  // Of a legal one.
  void apply(const Dissolve& op);
  // Gives the faces their numbers, and returns whether one had another. Afterwards the mesh may change in other ways
  // too.
  bool finish();

  // Corners that were looked at and renumbered: what the work is measured by.
  std::uint64_t looks() const { return looks_; }

 private:
  struct Refusal {
    Rule rule;
    std::uint64_t at;  // the number of changes of both faces
  };

  const Mesh& mesh() const { return edit_.mesh(); }
  std::optional<Rule> broken_rule_of_edge(Halfedge h);
  // Judges an interior vertex whose faces are simple loops; unsure where anything about it is out of the ordinary.
  Union judge_star(Vertex v);
  std::vector<std::vector<Halfedge>> plain_chains(Vertex v);
  bool may_another_lie_on(std::span<const std::uint32_t> points, std::size_t corners, Vertex v);
  Face number(Face slot) const;
  std::uint64_t changes(Face f, Face g) const;
  std::uint64_t key(Face f, Face g) const;
  const Rule* known_refusal(Face f, Face g) const;
  void refuse(Face f, Face g, Rule rule);
  std::vector<Halfedge> chain_of(Halfedge h) const;
  bool is_known_chain(Halfedge h) const;
  void merge_values(std::span<const Halfedge> halves);
  void unite(const std::vector<Halfedge>& chain);
  void unite_star(Vertex v);
  void take_spike_away(const std::vector<Halfedge>& chain);
  void give_corners(Face from, Face to);
  void forget_all();

  Edit& edit_;
  Takes takes_;
  LocalFacts known_;
  std::unordered_map<Face, Face> numbers_;  // by slot, where it is another
  std::unordered_map<Face, std::uint64_t> changes_;
  std::unordered_map<std::uint64_t, Refusal> refused_;    // by both faces
  std::unordered_map<Edge, std::uint64_t> known_chains_;  // the number of changes of both faces then
  std::vector<Halfedge> plain_;  // the chain that was found to be one whose faces may be united
  Vertex plain_star_;            // or the vertex
  std::uint64_t looks_ = 0, change_ = 0;
};

}  // namespace ryosen
