// Remedies for many refused operators of one mesh.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/ops/remedy.h"

namespace ryosen::cli {

// Finds what find_remedy finds, but turns the faces, which costs O(mesh), once instead of once per question.
class Remedies {
 public:
  // The mesh is changed for a moment by every question and is byte-equal afterwards.
  explicit Remedies(Mesh& mesh) : mesh_(mesh) {}

  // Script lines after which the operator is legal; empty where none were found. `verdict` is the one on the operator.
  std::vector<std::string> find(const AnyOp& op, const Verdict& verdict);

 private:
  struct Oriented;
  Oriented* oriented();

  Mesh& mesh_;
  bool orient_was_tried_ = false;
  std::shared_ptr<Oriented> oriented_;
};

}  // namespace ryosen::cli
