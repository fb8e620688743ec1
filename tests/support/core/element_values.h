// Values on all elements of a mesh, to see what becomes of them.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "ryosen/mesh/journal.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen::test {

// Gives random whole numbers to vertices (vertex.mass, vertex.top, vertex.mean, vertex.mark), edges (edge.count,
// edge.length, edge.crease), corners (corner.mark, corner.mean) and faces (face.count, face.area, face.mean,
// face.mark): as sums of integers and doubles, means, greatest and first ones. Points and undirected edges have one.
void add_values(Mesh& mesh, Journal* journal);

// Copies of a point, and edges of the same two points, have the same values.
void expect_copies_agree(const Mesh& mesh);

// The values of live elements by attribute and vertices: of a vertex, an edge, a corner or a face.
using ElementValues = std::map<std::tuple<std::string, std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>>;
ElementValues values_of(const Mesh& mesh);

}  // namespace ryosen::test
