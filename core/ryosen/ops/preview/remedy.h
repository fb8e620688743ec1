// Search for remedies: operators that make a refused operator legal.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "ryosen/ops/all.h"
#include "ryosen/ops/preview/remedy_candidates.h"

namespace ryosen {

// For many queries on one mesh; each modifies the mesh temporarily and leaves it byte-equal. Orienting, which costs
// O(mesh), is done at most once, on a copy. Results are the same as with one search per query. Valid while the mesh
// does not change.
class RemedySearch {
 public:
  explicit RemedySearch(Mesh& mesh);
  ~RemedySearch();
  RemedySearch(const RemedySearch&) = delete;
  RemedySearch& operator=(const RemedySearch&) = delete;

  // Script lines, in order, after which `line` is legal unchanged; empty if no short sequence of local remedies,
  // optionally after `orient`, was found. Every result has been verified, including that the line still names the same
  // elements. Empty too if the line is legal or does not parse, at faces and holes of more than 1000 sides, and for a
  // collapse at points of a higher valence. Cost: a few operators per reason.
  std::vector<std::string> find(const std::string& line);

 private:
  Mesh* oriented();
  bool is_beside_misoriented_edge(const Reason& reason);

  Mesh& mesh_;
  KnownSheets sheets_, sheets_when_turned_;
  std::unordered_map<Vertex, bool> beside_misoriented_;  // of points
  bool orient_was_tried_ = false;
  std::unique_ptr<Mesh> oriented_;  // null until needed, and if no face would be flipped
};

// A single query, for an operator as named by its own script line.
std::vector<std::string> find_remedy(Mesh& mesh, const AnyOp& op);

}  // namespace ryosen
