// Prepares a mesh for an algorithm: tells what is to stay as it is, cuts faces into triangles, and makes equal values
// of corners one, which is what operators know a chart of values by.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "ryosen/base/message.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/edit.h"

namespace ryosen {

// Whether a wire ends at a vertex, or several fans do; where points move it stays. Cost: its valence.
bool ends_a_wire_or_fan(const Mesh& mesh, Vertex v);

// Whether two faces differ in a value (material, group): the line between them stays.
inline bool face_values_differ(const Mesh& mesh, Face a, Face b) {
  for (const AttributeColumn& column : mesh.attributes()) {
    if (column.element != ElementKind::face) continue;
    const auto words = [&](Face f) { return column.data.data() + std::size_t{f.index} * column.words; };
    if (!std::equal(words(a), words(a) + column.words, words(b))) return true;
  }
  return false;
}

// The living faces of more than three corners or with rings.
std::vector<Face> polygons_of_mesh(const Mesh& mesh);

// A bridge within one loop shows as a halfedge whose twin has the same face.
bool has_bridge(const Mesh& mesh, Face f);

// Cuts faces by diagonals where that makes no edge twice, else from a new vertex in the middle. A clause that names the
// face where neither is possible; those before it are cut then.
std::optional<Text> cut_faces(Edit& edit, std::span<const Face> faces);

// Corners with the same value in two places of a pool refer to the first of them. O(corners).
void share_equal_values(Edit& edit);

}  // namespace ryosen
