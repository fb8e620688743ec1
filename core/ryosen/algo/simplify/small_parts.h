// Parts of a surface that are so small that they may go as a whole.
#pragma once

#include <optional>
#include <vector>

#include "ryosen/algo/simplify/collapse_surface.h"
#include "ryosen/mesh/edit.h"

namespace ryosen {

struct SmallPart {
  double size;  // the diagonal of its box, scaled
  std::vector<Vertex> vertices;
};

// The components whose size is at most that, smallest first. Those with a wire, a ring, or a vertex that something
// keeps in its place are none. O(n).
std::vector<SmallPart> find_small_parts(const CollapseSurface& surface, double largest);
// The one of a vertex, whatever its size; none where it may not go as a whole, or has more vertices than parts have
// that are too small to collapse. O(1).
std::optional<SmallPart> find_small_part(const CollapseSurface& surface, Vertex first);
// Removes the vertices with the edges and faces at them.
void remove_part(Edit& edit, const std::vector<Vertex>& vertices);

}  // namespace ryosen
