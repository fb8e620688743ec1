// The verdicts of one tool on all elements that it acts on, asked a part at a time and kept up with edits.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "ryosen/mesh/journal.h"
#include "ryosen/ops/all.h"
#include "ryosen/ops/preview/known_answers.h"

namespace ryosen {

// Whether a click is legal, of an edge on its middle; `none` for what is dead or was not asked about yet.
enum class ElementVerdict : std::uint8_t { none, legal, refused };

// Cost: one byte for each slot; the first time the checks of all elements, each subject (op.h) once, on a mesh of
// triangles 0.2 to 0.5 microseconds an edge; after an edit those of the elements around what it touched: after one
// collapse on a mesh of triangles some 200 edges, of a tool on boundaries whole boundaries.
class ToolVerdicts {
 public:
  // Of a tool that acts on any element (OpTargetKind::any) those on elements of this kind, which must be one it acts
  // on.
  ToolVerdicts(const Mesh& mesh, const OpInfo& op, Element::Kind sort);

  // No two have the same one, and none has 0.
  std::uint64_t serial() const { return serial_; }
  const OpInfo& op() const { return *op_; }
  Element::Kind sort() const { return sort_; }
  // Asks what is not known until all is, or `may_go_on` says no, which is asked now and then.
  void ask(const Mesh& mesh, const std::function<bool()>& may_go_on = {});
  // The mesh has changed; not for an edit that touched everything.
  void follow(const Mesh& mesh, const TouchedElements& touched);

  // One entry per slot; those from asked() on are not known, nor are some of the others while it is not complete.
  std::span<const ElementVerdict> all() const { return verdicts_; }
  std::uint32_t asked() const { return asked_; }
  bool is_complete() const { return due_.empty() && asked_ == verdicts_.size(); }
  // Of what is to be asked, from 0 to 1.
  double share() const { return verdicts_.empty() ? 1 : double(asked_) / double(verdicts_.size()); }
  // Slots below asked() that were asked again since the last call: their verdicts or their places may be others.
  std::vector<std::uint32_t> take_asked_again();

 private:
  void ask_about(const Mesh& mesh, std::uint32_t slot);

  std::uint64_t serial_;
  const OpInfo* op_;
  Element::Kind sort_;
  std::vector<ElementVerdict> verdicts_;
  std::uint32_t asked_ = 0;         // all below were asked about
  std::vector<std::uint32_t> due_;  // to be asked again, ascending
  std::vector<std::uint32_t> asked_again_;
  KnownAnswers answers_;
};

}  // namespace ryosen
