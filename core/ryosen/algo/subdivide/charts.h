// Values as places: what a mask does to places it does to values, so that these stay on the surface where they are.
//
// Of vertices (colours) on the mesh itself; of corners (texture coordinates, normals) on a mesh of their charts, which
// is torn where values differ. There a chart has a boundary, and so its outline runs by the mask of boundaries.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "ryosen/algo/subdivide/creases.h"
#include "ryosen/algo/subdivide/masks.h"
#include "ryosen/mesh/attribute.h"

namespace ryosen::subdivide {

// The smallest and largest values in the faces around each vertex: masks stay between them but for rounding, and where
// they are equal to the bit.
class ValueBounds {
 public:
  explicit ValueBounds(const Mesh& mesh);
  void keep_within(glm::dvec3& value, Vertex around) const { keep_within(value, around, around); }
  void keep_within(glm::dvec3& value, Vertex a, Vertex b) const;

 private:
  std::vector<std::pair<glm::dvec3, glm::dvec3>> bounds_;
};

// The mesh with the values of vertices, three of them from `first` on, as places and without attributes.
Mesh mesh_of_values(const Mesh& mesh, const AttributeColumn& column, glm::length_t first);

class Charts {
 public:
  Charts(const Mesh& mesh, const Creases& creases, const CornerAttribute& attribute);

  // Faces have the numbers they had; those of which a corner has no value are not there. Each vertex has one value.
  const Mesh& mesh() const { return charts_; }
  const Creases& creases() const { return own_creases_; }
  // The halfedge at the same corner; none where the face is not there.
  Halfedge of(Halfedge h) const { return of_[h.index]; }

  // What masks(mesh, creases) makes of values; vertices come first. A chart that is torn up to a vertex has one value
  // there: it goes by the mask of the whole mesh, with the means of what its neighbours have.
  template <class Masks>
  Places values(const Masks& masks) const {
    Places values = masks(charts_, own_creases_);
    if (!means_) return values;
    const Places means = masks(*means_, creases_);
    for (const auto& [own, v] : tips_) values[own.index] = means[v.index];
    return values;
  }

 private:
  void build(const AttributeColumn& index, const AttributeColumn& pool);
  void take_creases();
  void find_tips();

  const Mesh& mesh_;
  const Creases& creases_;
  Mesh charts_;
  Creases own_creases_;
  std::vector<Halfedge> of_;
  std::vector<Vertex> vertex_of_;                // by vertex of the charts
  std::vector<std::pair<Vertex, Vertex>> tips_;  // of the charts, of the mesh
  std::optional<Mesh> means_;
};

}  // namespace ryosen::subdivide
