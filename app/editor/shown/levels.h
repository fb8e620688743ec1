// All levels of detail of a mesh in the view: what the command `levels` and the slider of its panel go through.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "app/editor/document/findings.h"
#include "ryosen/algo/simplify/simplify.h"
#include "ryosen/document/document.h"

namespace ryosen {

struct Frontend;
class Shown;

// What may be said of a simplification to all levels: its parameters but for a number or a share of faces.
std::span<const ParameterRow> level_parameters();

// The mesh of a level is shown in place of the document's, beside the history (Shown), so that nothing of the document
// changes; whatever edits it ends this.
class ShownLevels {
 public:
  // The values are those of the simplification that the levels were built with.
  ShownLevels(std::unique_ptr<DetailLevels> levels, ParameterValues values, const Document& document);

  const DetailLevels& levels() const { return *levels_; }
  // With the faces set aside, which each level has.
  std::size_t faces(std::size_t level) const { return levels_->faces(level) + quarantined_; }
  std::size_t faces() const { return faces(levels_->level()); }
  // The first level that has at most so many.
  std::size_t level_of(std::size_t faces) const;

  // level <= levels().last().
  void go_to(std::size_t level) { levels_->go_to(level); }
  // The line that simplifies to the level as an entry of the history.
  std::string line() const;

 private:
  std::unique_ptr<DetailLevels> levels_;
  ParameterValues values_;
  std::size_t quarantined_;
};

// The way back, told.
Outcome leave_level(Shown& shown);

// The line that has made what is shown, where it accounts for the edges that it left: of the level of detail, else the
// last one of the history. Empty where there is none.
std::string line_to_account_for(const Document& document, const Shown& shown);

// Finds it where it is not there yet, at the cost of that line. Null where there is none, or it was cancelled.
const LeftEdges* find_left_edges(Document& document, Findings& findings, const Shown& shown, const Frontend& frontend);

}  // namespace ryosen
