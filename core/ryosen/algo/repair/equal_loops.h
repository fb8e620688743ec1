// Faces on the same loop of points as another, and which of them go without opening the surface.
#pragma once

#include <vector>

#include "ryosen/algo/repair/pair_faces.h"

namespace ryosen {

struct EqualLoops {
  std::vector<Face> redundant;       // go
  std::vector<Face> of_solids;       // stay since they bound closed parts
  std::vector<Face> holding;         // stay since an edge would open without them
  std::vector<Face> of_other_loops;  // on the same points as another, in another order

  // Faces that run alike on one loop can stand for each other.
  struct Alike {
    std::vector<Face> faces;  // ascending
    std::size_t closed = 0;   // how many of those that stay bound closed parts
  };
  std::vector<Alike> alike;
  // As many as are redundant, the highest of those that run alike: to go in their place where that opens no closed
  // part.
  std::vector<Face> highest;
  std::vector<Face> closed_alone;  // faces of closed parts that run like no other
};

// Keeps one of the faces on the same loop of points, regardless of direction and start: where the pairs of faces
// (pair_faces.h) make no difference, the lowest. A face of a closed part goes only where all of that part goes, because
// a lower part has the same faces; another face goes where no face that stays is paired with it. O(n log n).
EqualLoops find_equal_loops(const Mesh& mesh);

// Whether the faces of closed parts that were to stay bound closed parts. O(n).
bool keeps_closed(const EqualLoops& found, const FacePairing& after);

}  // namespace ryosen
