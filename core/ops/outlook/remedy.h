// What would make a refused operator legal.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/ops/all.h"
#include "core/ops/outlook/remedy_candidates.h"

namespace ryosen {

// Answers many questions about one mesh, which is changed for a moment by each and is byte-equal afterwards. Turning
// faces, which costs O(mesh), is done once, on a copy, and only when a question needs it; every answer is the same as
// if it were asked alone. Use it while the mesh stays as it is.
class RemedySearch {
 public:
  explicit RemedySearch(Mesh& mesh);
  ~RemedySearch();
  RemedySearch(const RemedySearch&) = delete;
  RemedySearch& operator=(const RemedySearch&) = delete;

  // Script lines after which `line` is legal as it stands, in order; empty when no sequence of a few local remedies, or
  // of `orient` and such, was found. Every answer has been tried: after it the line still names what it names now.
  // Empty too where the line is legal or names nothing. Cost: a few operators per reason.
  std::vector<std::string> find(const std::string& line);

 private:
  Mesh* oriented();

  Mesh& mesh_;
  KnownSheets sheets_, sheets_when_turned_;
  bool orient_was_tried_ = false;
  std::unique_ptr<Mesh> oriented_;  // none until it is needed, and where no face would turn
};

// One question, about an operator as its own script line names it.
std::vector<std::string> find_remedy(Mesh& mesh, const AnyOp& op);

}  // namespace ryosen
