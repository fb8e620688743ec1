// The steps of a convex hull as they are played.
#pragma once

#include <optional>
#include <vector>

#include "ryosen/textbook/steps/hull/hull_steps.h"
#include "ryosen/textbook/steps/sequence.h"

namespace ryosen::steps {

// Makes a stretch of steps at a time, from copies that it keeps of the builder on the way. Up to most_made of them it
// makes all once to begin with, so that all counts are known; of more only those up to one that is asked for. In each
// stretch the elements of the mesh are numbered anew. Memory: O(points).
class HullSequence : public Sequence {
 public:
  static constexpr std::size_t most_made = 100000;

  // Of points whose dimension is 2 or 3.
  HullSequence(std::vector<glm::dvec3> points, HullOrder order, std::uint64_t seed);

  std::size_t size() const override { return size_; }
  Step at(std::size_t i) override;
  const Mesh& mesh_at(std::size_t i) override;
  bool edits() const override { return true; }
  Text remark() const override;
  void add_remark(const Text& more) { more_ = more; }
  std::optional<Curve> curve() const override;

 private:
  static constexpr std::size_t stretch = 512;

  // Reads i - 1 or, of state 0, 0: in which stretch it is.
  std::size_t stretch_of(std::size_t i) const { return i == 0 ? 0 : (i - 1) / stretch; }
  RecordedSteps& load(std::size_t number);
  void go_to(std::size_t step);
  void note_count();
  bool is_known() const { return made_.size() == size_; }

  std::vector<glm::dvec3> points_;
  Text more_;                    // to be remarked
  HullSteps now_;                // the builder where it stands
  std::vector<HullSteps> kept_;  // copies in ascending states, the first before all steps
  std::size_t keep_every_;
  std::size_t size_;
  std::vector<std::uint32_t> made_;  // behind each step that was made so far, how many elements
  std::optional<RecordedSteps> loaded_;
  std::size_t loaded_number_ = 0;
};

}  // namespace ryosen::steps
