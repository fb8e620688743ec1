// Single moves of vertices of a simplified surface, within all that holds collapses.
#pragma once

#include <algorithm>
#include <cstddef>

#include "ryosen/algo/simplify/collapse_surface.h"
#include "ryosen/algo/simplify/distance_guard.h"
#include "ryosen/mesh/edit.h"

namespace ryosen {

struct NearerMoves {
  std::size_t moves = 0;
  double error_max = 0;   // the largest of CollapseSurface::error_of_move()
  std::size_t looks = 0;  // at what was looked at for them, where it is counted
};

// Nothing goes beyond the error, no face turns too far, loses its area or gets too small an angle, and where there is a
// guard, nothing is moved whose distance it cannot prove; it follows. Colours that take part in the error go along;
// other values stay.
class VertexMover {
 public:
  VertexMover(Edit& edit, CollapseSurface& surface, DistanceGuard* guard)
      : edit_(edit), surface_(surface), guard_(guard) {}

  // But for the guard.
  bool may_move(Vertex v, const glm::dvec3& position) const {
    return surface_.error_of_move(v, position) <= surface_.error_limit() &&
           !surface_.move_spoils_face(v, position, Face()) && !surface_.move_tilts_face(v, position);
  }
  // Moves it, which it may, unless the guard refuses; whether it did.
  bool move(Vertex v, const glm::dvec3& position) {
    if (guard_) {
      if (guard_->move_may_exceed(v, position)) return false;
      guard_->follow();
    }
    moves_.error_max = std::max(moves_.error_max, surface_.error_of_move(v, position));
    ++moves_.moves;
    edit_.set_position(v, position);
    surface_.move(v, position);
    if (const AttributeError* const fit = surface_.values()) fit->write_colours(edit_, v, surface_.place(v));
    return true;
  }
  const NearerMoves& moves() const { return moves_; }

 private:
  Edit& edit_;
  CollapseSurface& surface_;
  DistanceGuard* guard_;
  NearerMoves moves_;
};

}  // namespace ryosen
