// How a simplifier brings the surface nearer to the input in the end.
#include <algorithm>
#include <utility>

#include "ryosen/algo/simplify/fitted_colours.h"
#include "ryosen/algo/simplify/nearer_farthest.h"
#include "ryosen/algo/simplify/nearer_moves.h"
#include "ryosen/algo/simplify/nearer_swaps.h"
#include "ryosen/algo/simplify/simplifier.h"

namespace ryosen {

namespace {

// Swaps know nothing of colours and texture: where these weigh more than this, swaps lose more of them than they gain.
constexpr double most_weight_of_swaps = 0.1;

}  // namespace

std::span<const Vertex> Simplifier::find_merged() {
  for (std::uint32_t i = 0; i < merged_into_.size(); ++i) {
    Vertex v(i);
    while (merged_into_[v.index]) v = merged_into_[v.index];
    for (Vertex w(i); w != v;) w = std::exchange(merged_into_[w.index], v);  // a shorter way for the others
  }
  return merged_into_;
}

bool Simplifier::come_nearer(Progress& progress) {
  NearSamples samples(*input_, surface_);
  const TriangleTree input = goal_.effort == 2 ? tree_of_input(*input_, surface_) : TriangleTree();
  DistanceGuard* const guard = distance_guard_ ? &*distance_guard_ : nullptr;
  const AttributeError* const values = surface_.values();
  if (goal_.effort == 2 && !(values && values->weight() > most_weight_of_swaps)) {
    if (!samples.assign(find_merged(), true, progress)) return false;
    swaps_ = swap_nearer(*edit_, surface_, samples, input, guard, progress);
    if (swaps_ > 0 && !is_at_goal() && find_further(progress) && !collapse_all(progress)) return false;
  }
  const NearerMoves moves =
      move_nearer(*edit_, surface_, samples, find_merged(), goal_.effort == 2 ? &input : nullptr, guard, progress);
  if (progress.is_cancelled()) return false;  // samples may have no faces
  const NearerMoves further = move_farthest(*edit_, surface_, samples, *input_, guard, progress);
  if (progress.is_cancelled()) return false;
  moves_ = moves.moves + further.moves;
  farthest_looks_ += further.looks;
  if (values) fit_colours(*edit_, surface_, samples, *input_);
  error_max_ = std::max({error_max_, moves.error_max, further.error_max});
  // What a face that turned too far had refused may be possible now.
  if (moves_ > 0 && !is_at_goal() && find_further(progress) && !collapse_all(progress)) return false;
  return progress.go_on();
}

}  // namespace ryosen
