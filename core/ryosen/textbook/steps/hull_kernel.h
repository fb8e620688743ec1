// The kernel's mesh beside the DCEL of a hull that is built step by step: it does the same, as edits.
#pragma once

#include <span>
#include <vector>

#include "ryosen/mesh/edit.h"
#include "ryosen/mesh/journal.h"
#include "ryosen/mesh/mesh.h"
#include "ryosen/textbook/steps/hull/hull_steps.h"

namespace ryosen::steps {

class HullKernel {
 public:
  // Of the records in the state from which it goes on. In a plane the face is a polygon.
  HullKernel(const forms::DcelRecords& records, bool is_planar);

  // By rows of the DCEL, also of elements that a step is about to take away.
  Face face(std::uint32_t row) const { return face_[row]; }
  Halfedge halfedge(std::uint32_t row) const { return half_[row]; }
  // `records`: as they are behind the step.
  void follow(const HullStep& step, const forms::DcelRecords& records);

  const Mesh& mesh() const { return mesh_; }
  std::size_t position() const { return journal_.position(); }
  Mesh take_mesh() { return std::move(mesh_); }
  Journal take_journal() { return std::move(journal_); }

 private:
  void follow_in_space(Edit& edit, const HullStep& step, const forms::DcelRecords& records);
  void follow_in_plane(Edit& edit, const HullStep& step, const forms::DcelRecords& records);
  void remove_seen(Edit& edit, const HullStep& step);
  void add_face(Edit& edit, const forms::DcelRecords& records, std::uint32_t f);

  bool is_planar_;
  Mesh mesh_;
  Journal journal_;
  std::vector<Halfedge> half_;
  std::vector<Face> face_;
};

}  // namespace ryosen::steps
