// What an edit may have changed the answer about: the elements at the points that it wrote. All that is kept current by
// asking elements anew asks these.
#pragma once

#include <vector>

#include "ryosen/analysis/neighbourhood.h"
#include "ryosen/mesh/journal.h"

namespace ryosen {

// Sorted, without repetition. Dead elements and those past the end of the columns are among them.
struct EditReach {
  std::vector<Vertex> vertices;
  std::vector<Edge> edges;
  std::vector<Face> faces;
};

enum class WrittenValues : bool { ignored, counted };  // of attributes

// All elements at the points where transaction i wrote links or positions, or values where these count, and the
// neighbours of these points. Not for a transaction that replaces all columns. Cost: the cells written and the stars of
// their points.
EditReach edit_reach(const Journal& journal, std::size_t i, Neighbourhood& around,
                     WrittenValues values = WrittenValues::ignored);

// Adds the edges and vertices of the faces in it.
void add_whole_faces(Neighbourhood& around, EditReach& reach);
// Adds the vertices at the other ends of the edges at its points.
void add_neighbours(Neighbourhood& around, EditReach& reach);

}  // namespace ryosen
