// The elements that new elements come from.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "ryosen/base/element.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// By slot behind the change the element before it of which it is a part, or which it is; none where it is of none.
// Points keep their numbers.
struct Descent {
  std::vector<Face> faces;
  std::vector<Edge> edges;
};

// Adds a column in which each face has its own number, which faces that are cut from it get with its other values.
void add_origins(MeshColumns& columns);
// The same, of a copy.
Mesh with_origins(const Mesh& mesh);
// Takes it out: of which face each comes, by slot.
std::vector<Face> take_origins(MeshColumns& columns);
// Each as what it is, for those that keep their numbers.
std::vector<Edge> own_edges(std::uint32_t count);

// What these elements of the mesh before have become: each is followed by all that comes of it. Halves of edges are
// those of its parts on the same side. O(result), and what is found by a logarithm.
std::vector<Element> descended(const Mesh& mesh, const Descent& descent, std::span<const Element> elements);

}  // namespace ryosen
